# A cylinder from rest down a slope: balance of energy, and its motion, against counted work.
cost = "work"
problems = "cylinder cylinder"
quantities = "energy motion"
titles = "'missing energy' 'velocity'"
errors = "'relative error [1]' ''"
names = "'direct verlet' 'direct midpoint' 'remembered verlet' 'direct leapfrog' 'remembered midpoint' 'remembered leapfrog'"
labels = names
bases = ""
front = "all"
load scripts."/speed_accuracy.gpi"
