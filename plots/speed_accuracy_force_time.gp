# Steady rolling: error of the force against measured time.
cost = "time"
problems = "plane strip"
quantities = "force force"
titles = "'plane strain' 'strip of one contact length'"
errors = "'largest error of the force [1]' ''"
names = "standard known_edge calibrated trimmed aligned chebyshev inversion"
labels = names
bases = "linear quadratic 'trimmed linear'"
front = "elements"
load scripts."/speed_accuracy.gpi"
