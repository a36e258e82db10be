# Thesis Fig. 6.8: the Fourier inverse step by step, for linear functions.
basis = "linear"
load scripts."/fourier_inverse.gpi"
