# A cylinder from rest on a slope rolls right for every slope and step ratio: no tile is orange.
map = "cylinder"
across = "slope_ratio"
up = "step_ratio"
names = "verlet leapfrog midpoint direct_midpoint"
label_across = "slope force over full sliding"
label_up = "step ratio c"
across_tics = "0.001 0.1 2.5 10 1000"
up_tics = "0.1 0.3 1 3 10 100"
sentence(k) = most_error(scheme) < 1e-6 ? "right to rounding" : sprintf("up to %.2g %% off", 100 * most_error(scheme))
load scripts."/extremes.gpi"
