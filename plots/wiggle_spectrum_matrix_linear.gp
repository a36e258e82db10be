# Thesis Figs. 6.4 and 6.5, linear functions: for small c the diagonal of B = A - A' vanishes, and the inverse
# alternates from entry to entry.
block = 1
load scripts."/wiggle_spectrum.gpi"
