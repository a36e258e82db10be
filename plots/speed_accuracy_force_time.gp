# Aligned and calibrated elements need a tenth of the time of the thesis's scheme (standard) for 0.1 % of the force, and
# an ever smaller part for more accuracy; Chebyshev collocation and inversion are exact. Steady rolling. Each line is
# one scheme with its best basis, step ratio, solver and N; dots are all runs.
problems = "plane strip"
quantities = "force force"
titles = "'force, plane strain' 'force, strip of one contact length'"
names = "standard known_edge calibrated aligned chebyshev inversion"
least = 1.0e-12
load scripts."/speed_accuracy.gpi"
