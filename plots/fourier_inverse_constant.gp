# Thesis Fig. 6.7: constant functions.
basis = "constant"
load scripts."/fourier_inverse.gpi"
