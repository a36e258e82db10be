# For small c the diagonal of B = A - A' vanishes, and the inverse alternates from entry to entry. Linear functions,
# thesis Figs. 6.4 and 6.5.
block = 1
load scripts."/wiggle_spectrum.gpi"
