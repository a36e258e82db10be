# Under-relaxed small steps do not wiggle, and flatten the travelling peak (above); direct ones wiggle (below). After
# two distances; thesis Figs. 7.1 and 7.2.
traction = tables."/traction.tsv"
ratios = ""
distances = ""
set table $ratios
plot tables."/summary.tsv" using \
  (d = sprintf(" %g", column("distance")), \
   distances = strstrt(distances, d) ? distances : distances.d, \
   c = sprintf(" %g", column("step_ratio")), \
   ratios = strcol("scheme") eq "relaxed" && d eq " ".word(distances, 1) ? ratios.c : ratios, 0) with table
unset table
at(scheme, c, d) = strcol("scheme") eq scheme && same(column("step_ratio"), real(c)) && \
  same(column("distance"), real(d)) ? column("x") : NaN
from(d) = same(column("distance"), real(d)) ? column("x") : NaN

eval page(860, 600)
set multiplot layout 2,2 margins 0.095,0.98,0.1,0.93 spacing 0.08,0.16
set xrange [-0.7:1]
set yrange [0:1.02]
do for [scheme in "relaxed direct"] {
  do for [i=1:words(distances)] {
    d = word(distances, i)
    set title sprintf("%s, after %s dx", scheme eq "relaxed" ? "under-relaxed, c* = 1" : "direct", d)
    set xlabel scheme eq "direct" ? "x [mm], rolling to the right" : ""
    set ylabel i == 1 ? "traction p [N/mm^2]" : ""
    if (scheme eq "relaxed" && i == 1) { set key at 0.56,0.46 maxrows 4 samplen 1.2 spacing 1 width -1 } else { unset key }
    plot traction using (at("relaxed", word(ratios, 1), d)):"bound" with @bound_line title "bound g", \
         for [k=1:words(ratios)] traction using (at(scheme, word(ratios, k), d)):"traction" \
           with lines linetype k title "c = ".word(ratios, k), \
         tables."/reference.tsv" using (from(d)):"traction" with @exact_line title "reference"
  }
}
unset multiplot
