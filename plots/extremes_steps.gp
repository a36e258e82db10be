# Steady rolling for tiny to huge steps and grids.
map = "steps"
across = "step_ratio"
up = "elements"
names = "standard 'standard linear' 'standard quadratic' known_edge trimmed inversion"
label_across = "step ratio c = dq/dx [1]"
label_up = "number of elements N [1]"
error = "error of force or creepage [1]"
set logscale xy
set format "10^{%T}"
set xrange [1e-13:1e4]
set yrange [0.6:2e5]
set xtics 1e-12, 1e4
load scripts."/extremes.gpi"
