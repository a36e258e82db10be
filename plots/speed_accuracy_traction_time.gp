# For accurate tractions elements gain less over the thesis's scheme (standard) than for the force; Chebyshev
# collocation and inversion are exact. Steady rolling. Each line is one scheme with its best basis, step ratio, solver
# and N; dots are all runs.
problems = "plane strip"
quantities = "traction traction"
titles = "'tractions, plane strain' 'tractions, strip of one contact length'"
names = "standard known_edge calibrated aligned chebyshev inversion"
least = 1.0e-12
load scripts."/speed_accuracy.gpi"
