# For small c the diagonal of B = A - A' vanishes, and the inverse alternates from entry to entry. Constant functions,
# thesis Figs. 6.1 and 6.2.
block = 0
load scripts."/wiggle_spectrum.gpi"
