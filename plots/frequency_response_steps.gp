# After a step of the force the creepage has its peak where the first peak of the tractions leaves the contact (right);
# after a step of the creepage the force rises smoothly (left). Small steps from rest. Steps of one element: every
# ninth, another for each scheme, and in the small panel all steps near the peak.
steps = tables."/steps.tsv"
of(kind, scheme) = strcol("kind") eq kind && strcol("scheme") eq scheme ? column("distance") : NaN
at_peak = 0.15
some(kind, scheme, k) = enlarged || int(column(0)) % 9 == 3 * k ? of(kind, scheme) : NaN
names = "remembered direct"
point(k) = k == 1 ? 7 : 6
size(k) = k == 1 ? 0.45 : 0.65
eval page(860, 400)
set multiplot layout 1,2 margins 0.095,0.98,0.14,0.9 spacing 0.11
set xlabel "distance rolled, in half-widths [1]"
set xrange [0:5]
set key bottom right
enlarged = 0
do for [panel=1:3] {
  kind = panel == 1 ? "force" : "creepage"
  if (panel == 3) {
    enlarged = 1
    unset key
    unset xlabel
    set lmargin at screen 0.8
    set rmargin at screen 0.975
    set bmargin at screen 0.62
    set tmargin at screen 0.89
    set xrange [2 - at_peak:2 + at_peak]
    set xtics 2 - at_peak, at_peak
    set ytics 0.25
  }
  set title panel == 1 ? "step of the creepage" : panel == 2 ? "step of the force" : ""
  set ylabel (panel < 3 ? kind." over its steady value [1]" : "") offset 0.6,0
  set yrange [panel < 3 ? 0 : 1.1:panel == 1 ? 1.05 : panel == 2 ? 2 : 1.8]
  plot steps using (of(kind, "exact")):"value" with @exact_line title "exact", \
       for [k=2:1:-1] steps using (some(kind, word(names, k), k - 1)):"value" with points linecolor rgb colour_of(word(names, k)) \
         pointtype point(k) pointsize size(k) notitle, \
       for [k=1:2] keyentry with points linecolor rgb colour_of(word(names, k)) pointtype point(k) pointsize size(k) title word(names, k)
}
unset multiplot
