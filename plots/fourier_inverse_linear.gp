# With the zero frequency the Fourier inverse is off by a constant; without it there is hardly a difference to be seen
# (last row). The rows are the steps for linear functions (thesis Fig. 6.8).
basis = "linear"
load scripts."/fourier_inverse.gpi"
