# Calibrated elements give the creepage of bodies of different material far more accurately than the standard scheme,
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
set label 1 "standard, as CONTACT: first order" at 100, 0.07 textcolor rgb label_colour_of("standard")
set label 2 "calibrated" at 700, 3e-6 left textcolor rgb label_colour_of("calibrated")
plot for [k=1:3] errors using "elements":(of("standard", word(forces, k) + 0)) with linespoints linecolor rgb colour_of("standard") pointtype (2*k+3) pointsize 0.7 notitle, \
     for [k=1:3] errors using "elements":(of("calibrated", word(forces, k) + 0)) with linespoints linecolor rgb colour_of("calibrated") pointtype (2*k+3) pointsize 0.7 notitle, \
     for [k=1:3] keyentry with points linecolor "gray40" pointtype (2*k+3) pointsize 0.7 title word(titles, k)
