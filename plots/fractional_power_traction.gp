# Fractional powers keep travelling peaks for every step ratio (left); after a distance that is no whole number of
# elements the direct scheme smears them (right). Thesis Figs. 8.3 and 8.4.
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

eval page(860, 600)
set multiplot layout 2,2 margins 0.105,0.98,0.1,0.94 spacing 0.09,0.08
set xrange [-1:1]
set format x ""
do for [panel=1:4] {
  d = panel % 2 == 1 ? whole : part
  if (panel == 3) { set format x; set xlabel "x [mm], rolling to the right" }
  set title panel == 1 ? "fractional powers, after ".d." dx" : panel == 2 ? sprintf("c = %g, after %s dx", c, d) : ""
  set ylabel panel == 1 ? "traction p [N/mm^2]" : panel == 3 ? "p - reference [N/mm^2]" : ""
  if (panel > 2) {
    unset key
    set yrange [-0.25:0.1]
    shown(p, r) = p - r
  } else {
    set key at panel == 1 ? 0.57 : 0.3, 0.35 maxrows 4 samplen 1.5
    set yrange [-0.15:1.02]
    shown(p, r) = p
  }
  if (d eq whole) {
    plot traction using (at("fractional", word(ratios, 1), d)):(panel < 3 ? column("bound") : NaN) with @bound_line title "bound g", \
         tables."/reference.tsv" using (panel < 3 ? from(d) : NaN):"traction" with @exact_line title "reference", \
         for [k=1:words(ratios)] traction using (at("fractional", word(ratios, k), d)):(shown(column("traction"), column("reference"))) \
           with linespoints linetype k pointtype 7 pointsize 0.25 title "c = ".word(ratios, k)
  } else {
    plot traction using (at("direct", c, d)):(panel < 3 ? column("bound") : NaN) with @bound_line title "bound g", \
         tables."/reference.tsv" using (panel < 3 ? from(d) : NaN):"traction" with @exact_line title "reference", \
         traction using (at("direct", c, d)):(shown(column("traction"), column("reference"))) \
           with linespoints linecolor rgb colour_of("direct") pointtype 6 pointsize 0.3 title "direct", \
         traction using (at("fractional", c, d)):(shown(column("traction"), column("reference"))) \
           with linespoints linecolor rgb colour_of("fractional") pointtype 7 pointsize 0.25 title "fractional"
  }
}
unset multiplot
