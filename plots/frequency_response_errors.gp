# Error of dF/dw against N, over waves of 1.7 to 20 half-widths: where everything adheres, and about a state with
# slip. Filled points are steps of an element.
errors = tables."/errors.tsv"
slips = 0.6
names = "material direct relaxed fractional"
of(ratio, scheme, c) = strcol("kernel") eq "plane" && same(column("stick_ratio"), ratio) && strcol("scheme") eq scheme \
  && same(column("step_ratio"), c) ? column("elements") : NaN
eval page(860, 430)
set multiplot layout 1,2 margins 0.085,0.98,0.14,0.9 spacing 0.09
set logscale xy
set format y "10^{%T}"
set xlabel "elements N [1]"
set xrange [13:120]
set xtics (15, 27, 51, 99)
set yrange [2e-6:0.1]
set ylabel "relative error of dF/dw [1]"
set title "all adheres"
unset key
slope(n, order, from) = from * (27 / n)**order
# With c = 1 direct, relaxed and fractional are one scheme.
plot for [k=1:2] errors using (of(1, word(names, k), 1)):"error" with linespoints linetype k pointtype 7 pointsize 0.6, \
     for [k=1:4] errors using (of(1, word(names, k), 0.3)):"error" with linespoints linetype k dashtype 2 pointtype 6 pointsize 0.8, \
     slope(x, 1, 1.5e-3) with lines linecolor "gray50" dashtype 3, \
     slope(x, 2, 4e-4) with lines linecolor "gray50" dashtype 3
set title "a' = 0.6"
unset ylabel
set key bottom left
plot for [k=1:2] errors using (of(slips, word(names, k), 1)):"error" with linespoints linetype k pointtype 7 pointsize 0.6 \
       title word(names, k).", c = 1".(k == 2 ? " (as relaxed, fractional)" : ""), \
     for [k=1:4] errors using (of(slips, word(names, k), 0.3)):"error" with linespoints linetype k dashtype 2 pointtype 6 pointsize 0.8 \
       title word(names, k).", c = 0.3", \
     slope(x, 1, 1.5e-3) with lines linecolor "gray50" dashtype 3 title "order 1, left order 2, too"
unset multiplot
