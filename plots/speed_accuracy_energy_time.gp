# The scheme remembered with the midpoint rule balances the energy exactly (above); Verlet is the fastest for the motion
# (below). A cylinder rolls from rest down a slope. Each line is one scheme with its best step ratio, solver and N; dots
# are all runs.
problems = "cylinder cylinder"
quantities = "energy motion"
titles = "'energy that the balance misses' 'velocity'"
names = "'remembered verlet' 'remembered midpoint' 'direct verlet' 'direct midpoint'"
least = 1.0e-12
load scripts."/speed_accuracy.gpi"
