# Relaxed displacements (7.4) and relaxed tractions (7.10) are the same to rounding until their partitions first differ
# (left). Right, the elements in which they do.
comparison = tables."/comparison.tsv"
parting = tables."/parting.tsv"
first = 0.0
set table $first
plot parting using (first = column("q"), 0) with table
unset table
eval page(860, 380)
set multiplot layout 1,2 margins 0.105,0.98,0.16,0.9 spacing 0.115
set logscale y
set format y "10^{%T}"
set xlabel "distance rolled [dx]"
set ylabel "largest difference [N/mm^2]"
set yrange [1e-17:0.1]
set key bottom right
set title "(7.4) against (7.10)"
plot comparison using "q":"difference" with linespoints linetype 1 pointtype 7 pointsize 0.3 title "tractions", \
     comparison using "q":(column("differing_elements") > 0 ? column("difference") : NaN) \
       with points linetype 2 pointtype 6 pointsize 0.9 title "partitions differ"
unset logscale y
set format y
set xrange [-1:-0.4]
set yrange [0:1]
set xlabel "x [mm], rolling to the right"
set ylabel "traction p [N/mm^2]"
set title sprintf("where they part, after %g dx", first)
plot parting using "x":"bound" with @bound_line title "bound g", \
     parting using "x":"relaxed" with linespoints linecolor rgb colour_of("relaxed") pointtype 7 pointsize 0.4 title "A' relaxed (7.4)", \
     parting using "x":"relaxed_traction" with points linecolor rgb colour_of("relaxed_traction") pointtype 6 pointsize 0.7 title "tractions relaxed (7.10)", \
     parting using (strcol("relaxed_region") ne strcol("relaxed_traction_region") ? column("x") : NaN):"relaxed" \
       with points linetype 1 pointtype 4 pointsize 1.3 title "adhesion in one, slip in the other"
unset multiplot
