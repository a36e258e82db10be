# Thesis Figs. 6.1 and 6.2, constant functions: for small c the diagonal of B = A - A' vanishes, and the inverse
# alternates from entry to entry.
block = 0
load scripts."/wiggle_spectrum.gpi"
