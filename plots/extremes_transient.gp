# A Cattaneo shift that rolls on in steps of any length.
map = "transient"
across = "step_ratio"
up = "elements"
names = "remembered direct relaxed relaxed_traction fractional"
label_across = "step ratio c = dq/dx [1]"
label_up = "number of elements N [1]"
error = "error of the traction [1]"
set logscale xy
set format x "10^{%T}"
set xrange [1e-13:1e4]
set yrange [8:140]
set xtics 1e-12, 1e4
set ytics (11, 25, 51, 101)
load scripts."/extremes.gpi"
