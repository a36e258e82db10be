# Thesis Figs. 6.4 and 6.5: linear functions.
block = 1
load scripts."/wiggle_spectrum.gpi"
