# Thesis Figs. 6.1 and 6.2: B = A - A' and its inverse for two step ratios, constant functions.
block = 0
load scripts."/wiggle_spectrum.gpi"
