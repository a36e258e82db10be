# Thesis Figs. 8.3 and 8.4: fractional powers after a whole distance, and against the direct scheme after
# one that is not.
traction = tables."/traction.tsv"
ratios = ""
distances = ""
set table $ratios
plot tables."/summary.tsv" using \
  (d = sprintf(" %g", column("distance")), \
   distances = strstrt(distances, d) ? distances : distances.d, \
   ratios = strcol("scheme") eq "fractional" && d eq " ".word(distances, 1) ? ratios.sprintf(" %g", column("step_ratio")) : ratios, \
   c = column("step_ratio"), 0) with table
unset table
whole = word(distances, 1)
part = word(distances, words(distances))
at(scheme, c, d) = strcol("scheme") eq scheme && same(column("step_ratio"), real(c)) && \
  same(column("distance"), real(d)) ? column("x") : NaN
from(d) = same(column("distance"), real(d)) ? column("x") : NaN

set terminal svg size 860,400
set multiplot layout 1,2 margins 0.08,0.98,0.15,0.9 spacing 0.08
set xrange [-0.7:1]
set yrange [0:1.02]
set xlabel "x [mm], rolling to the right"
set ylabel "traction p [N/mm^2]"
set key at 0.6,0.4 maxrows 3 samplen 1.5 width -1
set title "fractional powers, after ".whole." dx"
plot traction using (at("fractional", word(ratios, 1), whole)):"bound" with @bound_line title "bound g", \
     for [k=1:words(ratios)] traction using (at("fractional", word(ratios, k), whole)):"traction" \
       with linespoints linetype k pointtype 7 pointsize 0.25 title "c = ".word(ratios, k), \
     tables."/reference.tsv" using (from(whole)):"traction" with @exact_line title "reference"
set key at 0.6,0.35 maxrows 4
set ylabel ""
set title sprintf("c = %g, after %s dx", c, part)
plot traction using (at("direct", c, part)):"bound" with @bound_line title "bound g", \
     traction using (at("direct", c, part)):"traction" with linespoints linetype 2 pointtype 6 pointsize 0.3 title "direct", \
     traction using (at("fractional", c, part)):"traction" with linespoints linetype 1 pointtype 7 pointsize 0.25 title "fractional", \
     tables."/reference.tsv" using (from(part)):"traction" with @exact_line title "reference"
unset multiplot
