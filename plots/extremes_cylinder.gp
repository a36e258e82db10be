# A cylinder that starts from rest on a slope; leapfrog is as Verlet.
map = "cylinder"
across = "slope_ratio"
up = "step_ratio"
names = "midpoint verlet direct_midpoint"
label_across = "slope force over full sliding [1]"
label_up = "step ratio c = dq/dx [1]"
error = "error of velocity and energy [1]"
set logscale xy
set format x "10^{%T}"
set xrange [3e-4:4e3]
set yrange [0.05:200]
set xtics 1e-3, 100
load scripts."/extremes.gpi"
