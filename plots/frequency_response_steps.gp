# Small steps from rest: the force after a step of the creepage, and the creepage after a step of the force, with its
# peak where the first peak of the tractions leaves the contact. Steps of one element.
steps = tables."/steps.tsv"
of(kind, scheme) = strcol("kind") eq kind && strcol("scheme") eq scheme ? column("distance") : NaN
eval page(860, 400)
set multiplot layout 1,2 margins 0.08,0.98,0.14,0.9 spacing 0.09
set xlabel "distance rolled, in half-widths [1]"
set xrange [0:5]
set yrange [0:1.05]
set ylabel "force over its steady value [1]"
set title "step of the creepage"
set key bottom right
plot steps using (of("force", "exact")):"value" with @exact_line title "exact", \
     steps using (of("force", "direct")):"value" with points linetype 1 pointtype 6 pointsize 0.5 title "direct", \
     steps using (of("force", "material")):"value" with points linetype 3 pointtype 7 pointsize 0.3 title "material"
set ylabel "creepage over its steady value [1]"
set title "step of the force"
set yrange [0:2]
plot steps using (of("creepage", "exact")):"value" with @exact_line title "exact", \
     steps using (of("creepage", "direct")):"value" with points linetype 1 pointtype 6 pointsize 0.5 title "direct", \
     steps using (of("creepage", "material")):"value" with points linetype 3 pointtype 7 pointsize 0.3 title "material"
unset multiplot
