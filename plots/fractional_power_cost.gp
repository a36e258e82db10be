# One fractional step by a Schur method takes far longer than the action of the power on a vector, and its time grows
# faster with N.
timing = tables."/cost_timing.tsv"
stats timing using (log10(column("elements"))):(log10(column("action"))) name "action" nooutput
stats timing using (log10(column("elements"))):(log10(column("schur"))) name "schur" nooutput
eval page(640, 440)
set logscale xy
set format y "10^{%T}"
set xlabel "number of elements N [1]"
set ylabel "time of one step [s]"
set xrange [40:8000]
set yrange [1e-7:1e8]
set key top left Left reverse maxrows 5
set title "fractional step: cost against N"
plot timing using "elements":"schur" with linespoints linetype 2 pointtype 6 pointsize 0.6 \
       title sprintf("Schur method: N^{%.1f}", schur_slope), \
     10**(schur_intercept + schur_slope * log10(x)) with lines linetype 2 dashtype 3 title "its continuation", \
     timing using "elements":"action" with linespoints linetype 1 pointtype 7 pointsize 0.5 \
       title sprintf("action on a vector: N^{%.1f}", action_slope), \
     timing using "elements":"setup" with linespoints linetype 3 pointtype 5 pointsize 0.4 title "its setup, once", \
     timing using "elements":"product" with linespoints linetype 4 pointtype 9 pointsize 0.4 title "a dense product, for comparison"
