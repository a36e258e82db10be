# Errors of the four coefficients by joined rows, the largest over the steady coefficients, on a circle: against the number
# of cells of a row for some wavelengths, and, over the coefficient at its own wavelength, against the cells that a wave has.
errors = tables."/errors.tsv"
of(wavelength) = same(column("aspect"), 1) && same(column("wavelength"), wavelength) ? column("elements") : NaN

eval page(800, 400)
set multiplot layout 1,2 margins 0.105,0.98,0.17,0.89 spacing 0.115,0.14
set logscale xy
set format y "10^{%T}"
set yrange [3e-6:0.3]
set ylabel "largest error [1]"
set xlabel "N, cells of a row [1]"
set xtics (10, 15, 20, 27)
set xrange [9:30]
set title "over the steady coefficient"
plot for [L in "100 10 2.5 1"] errors using (of(L)):"largest" with linespoints pointtype 7 pointsize 0.5 title "L/a = ".L
unset ylabel
set title "over the coefficient itself"
set xlabel "cells a wave [1]"
set xtics (3, 10, 30, 100, 300)
set xrange [2.5:1000]
unset key
plot errors using (same(column("aspect"), 1) ? column("cells_a_wave") : NaN):"own" with points pointtype 6 pointsize 0.6
unset multiplot
