# With short steps the direct scheme has by far the largest error of the traction; the errors of the other treatments of
# the edges hardly depend on the step ratio.
errors = tables."/errors.tsv"
of(name) = strcol("treatment") eq name ? column("step_ratio") : NaN
names = '"at_node" "cell_mean" "cut" "direct"'
titles = '"nodes on and off" "mean bounds" "cut elements" "direct scheme"'

set logscale xy
set xrange [0.04:1.25]
set xtics (0.05, 0.1, 0.2, 0.5, 1)
set yrange [3e-4:0.1]
set format y "10^{%T}"
set xlabel "step ratio c [1]"
set ylabel "error of the traction (1-norm) [N/mm]"
set key at graph 0.98, 0.97
set title "from a Cattaneo shift to Carter's solution"
plot for [i=1:4] errors using (of(word(names, i))):"error" \
       with linespoints linecolor rgb colour_of(word(names, i)) pointtype (word("7 5 6 9", i) + 0) pointsize 0.6 title word(titles, i)
