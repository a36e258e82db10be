# Thesis Fig. 6.7: the Fourier inverse step by step, for constant functions. With the zero frequency the inverse is
# off by a constant, without it there is no difference to be seen.
basis = "constant"
load scripts."/fourier_inverse.gpi"
