# Thesis Figs. 6.1 and 6.2: constant functions.
block = 0
load scripts."/wiggle_spectrum.gpi"
