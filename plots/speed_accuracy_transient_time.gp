# The scheme remembered is the fastest for a force better than 0.01 %; for the tractions no scheme gains much over the
# thesis's (direct). From a Cattaneo shift over a third of the contact, above under a constant creepage, below under a
# constant force. Each line is one scheme with its best basis, step ratio, solver and N; dots are all runs.
problems = "creepage transient"
quantities = "force traction"
titles = "'force after the shift' 'tractions after the shift'"
names = "remembered direct relaxed relaxed_traction fractional"
least = 1.0e-8
load scripts."/speed_accuracy.gpi"
