# With the remembered scheme the answer to waves of the normal load is of second order, for every wavelength and step.
# Error of dF/dP about a state with slip.
measured = tables."/measured.tsv"
lengths = "1 5 20 50"
of(k, c) = same(column("stick_ratio"), 0.6) && same(column("wavelength_ratio"), word(lengths, k) + 0) && same(column("step_ratio"), c) \
  ? column("elements") : NaN
stats measured using "elements" name "n" nooutput
eval page(620, 420)
set logscale xy
set format y "10^{%T}"
set xlabel "elements N [1]"
set xrange [0.9*n_min:1.1*n_max]
set xtics (25, 50, 100, 200)
set ylabel "relative error of dF/dP [1]"
set key outside right
slope(n) = 3e-3 * (25 / n)**2
plot for [k=1:4] measured using (of(k, 1)):"error" with linespoints linetype k pointtype 7 pointsize 0.6 title "L = ".word(lengths, k)." a, c = 1", \
     for [k=1:4] measured using (of(k, 0.3)):"error" with linespoints linetype k dashtype 2 pointtype 6 pointsize 0.8 notitle, \
     keyentry with linespoints linecolor "gray40" dashtype 2 pointtype 6 pointsize 0.8 title "c = 0.3", \
     slope(x) with lines linecolor "gray50" dashtype 3 title "order 2"
