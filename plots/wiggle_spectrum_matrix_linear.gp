# Thesis Figs. 6.4 and 6.5: B = A - A' and its inverse for two step ratios, linear functions.
block = 1
load scripts."/wiggle_spectrum.gpi"
