# Thesis Fig. 6.8: linear functions.
basis = "linear"
load scripts."/fourier_inverse.gpi"
