# The scheme remembered is of second order with any step, the other schemes are of first order. Error of dF/dw over
# small waves of the creepage of 1.7 to 20 half-widths, where everything adheres, and about a state with slip. Filled
# points are steps of an element, where relaxed and fractional are the scheme direct.
errors = tables."/errors.tsv"
slips = 0.6
names = "remembered direct relaxed fractional"
of(ratio, scheme, c) = strcol("kernel") eq "plane" && same(column("stick_ratio"), ratio) && strcol("scheme") eq scheme \
  && same(column("step_ratio"), c) ? column("elements") : NaN
slope(n, order) = 1.5e-3 * (27 / n)**order
eval page(960, 430)
set multiplot layout 1,2 margins 0.085,0.835,0.14,0.9 spacing 0.08
set logscale xy
set format y "10^{%T}"
set xlabel "elements N [1]"
set xrange [24:110]
set xtics (27, 51, 99)
set yrange [4e-6:0.1]
do for [panel=1:2] {
  ratio = panel == 1 ? 1 : slips
  set title panel == 1 ? "all adheres" : "a' = 0.6"
  set ylabel panel == 1 ? "relative error of dF/dw [1]" : ""
  if (panel == 1) { unset key } else { set key at screen 0.85, 0.91 left top Left reverse samplen 1.8 }
  plot for [k=1:2] errors using (of(ratio, word(names, k), 1)):"error" with linespoints linecolor rgb colour_of(word(names, k)) \
         pointtype 7 pointsize 0.6 notitle, \
       for [k=1:4] errors using (of(ratio, word(names, k), 0.3)):"error" with linespoints linecolor rgb colour_of(word(names, k)) dashtype 2 \
         pointtype 6 pointsize (k == 4 ? 0.5 : 0.8) notitle, \
       slope(x, 1) with lines linecolor "gray50" dashtype 3 notitle, \
       slope(x, 2) with lines linecolor "gray50" dashtype 3 notitle, \
       for [k=1:4] keyentry with lines linecolor rgb colour_of(word(names, k)) title word(names, k), \
       keyentry with linespoints linecolor "gray40" pointtype 7 pointsize 0.6 title "c = 1", \
       keyentry with linespoints linecolor "gray40" dashtype 2 pointtype 6 pointsize 0.8 title "c = 0.3", \
       keyentry with lines linecolor "gray50" dashtype 3 title "orders 1, 2"
}
unset multiplot
