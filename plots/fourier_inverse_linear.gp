# Thesis Fig. 6.8: the Fourier inverse step by step, for linear functions. With the zero frequency the inverse is off
# by a constant, without it there is hardly a difference to be seen.
basis = "linear"
load scripts."/fourier_inverse.gpi"
