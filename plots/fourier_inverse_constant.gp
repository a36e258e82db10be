# Thesis Fig. 6.7: the Fourier inverse step by step, for constant functions.
basis = "constant"
load scripts."/fourier_inverse.gpi"
