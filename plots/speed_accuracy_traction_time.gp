# Error of the tractions against measured time.
cost = "time"
problems = "plane strip"
quantities = "traction traction"
titles = "'plane strain' 'strip of one contact length'"
errors = "'largest error of the tractions, 1-norm [1]' ''"
names = "standard known_edge calibrated trimmed aligned chebyshev inversion"
labels = names
bases = "linear quadratic 'trimmed linear'"
front = "elements"
load scripts."/speed_accuracy.gpi"
