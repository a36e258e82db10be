# Bodies of different material: calibrated elements give the creepage far more accurately than the standard scheme,
# which is of first order.
errors = tables."/errors.tsv"
of(scheme, force) = strcol("scheme") eq scheme && column("force_ratio") == force ? shown(abs(column("error"))) : NaN
forces = "0 0.75 -0.75"
titles = "'free rolling' '3/4 of full sliding' '-3/4 of full sliding'"
set logscale xy
set format y "10^{%T}"
set xlabel "number of elements N"
set ylabel "error of the creepage over μa/R [1]"
set xtics (50, 100, 200, 400, 800, 1600)
set xrange [40:2000]
set key bottom left
plot for [k=1:3] errors using "elements":(of("standard", word(forces, k) + 0)) with linespoints linetype k dashtype 2 pointtype 6 pointsize 0.7 notitle, \
     for [k=1:3] errors using "elements":(of("calibrated", word(forces, k) + 0)) with linespoints linetype k pointtype 7 pointsize 0.6 title word(titles, k), \
     keyentry with linespoints linecolor "gray40" pointtype 7 pointsize 0.6 title "calibrated", \
     keyentry with linespoints linecolor "gray40" dashtype 2 pointtype 6 pointsize 0.7 title "standard, as CONTACT"
