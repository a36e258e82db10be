# The noise of the creepage falls like 1/√N where nodes are switched on and off, and like 1/N with mean bounds (left).
# It is the standard deviation over one element's travel, over the mean.
noise = tables."/noise.tsv"
of(name, series) = strcol("treatment") eq name && strcol("series") eq series ? column(series) : NaN
names = '"at_node" "cell_mean" "cut" "direct"'
titles = '"nodes on and off" "mean bounds" "cut elements" "direct scheme"'
positive(name) = column(name) > 0 ? column(name) : NaN
stats noise using (strcol("series") eq "elements" ? column("elements") : NaN) name "n" nooutput
stats noise using (strcol("series") eq "elements" && column("elements") == n_min ? column("deviation") : NaN) name "coarse" nooutput
stats noise using (strcol("series") eq "elements" ? column("step_ratio") : NaN) name "c" nooutput
stats noise using (strcol("series") eq "step_ratio" ? column("elements") : NaN) name "fixed" nooutput

eval page(860, 440)
set multiplot layout 1,2 margins 0.09,0.98,0.14,0.92 spacing 0.1
set logscale xy
set yrange [1e-6:1]
set format y "10^{%T}"
set ylabel "deviation of the creepage / mean [1]"
do for [panel=1:2] {
  series = panel == 1 ? "elements" : "step_ratio"
  if (panel == 1) {
    set title sprintf("c = %g", c_min)
    set xlabel "number of elements N [1]"
    set xrange [0.8*n_min:1.25*n_max]
    set xtics (25, 50, 100, 200, 400, 800)
    unset key
    set label 1 "N^{-1/2}" at n_max, 1.25*coarse_max*sqrt(n_min/n_max)*2.4 right textcolor "gray40"
    set label 2 "N^{-1}" at n_max, 0.065*n_min/n_max*2.8 right textcolor "gray40"
  } else {
    set title sprintf("N = %g", fixed_min)
    set xlabel "step ratio c [1]"
    set xrange [0.008:0.65]
    set xtics (0.01, 0.02, 0.05, 0.1, 0.2, 0.5)
    set key bottom right
    unset label 1
    unset label 2
    set label 3 "1 %" at 0.009, 0.018 left textcolor "gray40"
  }
  plot for [i=1:4] noise using (of(word(names, i), series)):(positive("deviation")) \
         with linespoints linecolor rgb colour_of(word(names, i)) pointtype (word("7 7 6 5", i) + 0) pointsize (word("0.5 0.5 0.9 0.4", i) + 0) title word(titles, i), \
       noise using (of("at_node", series)):(positive("predicted")) with lines linetype 7 dashtype 3 linewidth 1.5 title "predicted for nodes on and off", \
       (panel == 1 ? 1.25*coarse_max*sqrt(n_min/x) : NaN) with lines linecolor "gray60" dashtype 2 notitle, \
       (panel == 1 ? 0.065*n_min/x : NaN) with lines linecolor "gray60" dashtype 2 notitle, \
       (panel == 2 ? 0.01 : NaN) with lines linecolor "gray60" dashtype 2 notitle
}
unset multiplot
