# With the zero frequency the Fourier inverse is off by a constant; without it there is no difference to be seen (last
# row). The rows are the steps for constant functions (thesis Fig. 6.7).
basis = "constant"
load scripts."/fourier_inverse.gpi"
