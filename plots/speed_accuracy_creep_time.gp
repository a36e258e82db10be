# The scheme remembered has the least noise of the creepage from step to step, and the most accurate cumulative creep.
# From a Cattaneo shift over a third of the contact, under a constant force. Each line is one scheme with its best
# basis, step ratio, solver and N; dots are all runs.
problems = "transient transient"
quantities = "creep noise"
titles = "'cumulative creep' 'noise of the creepage'"
names = "remembered direct relaxed relaxed_traction fractional"
least = 1.0e-8
load scripts."/speed_accuracy.gpi"
