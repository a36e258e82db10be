# Waves from element to element where a circle sticks, and the error of its force long after a shift, against the step: both
# grow as the steps of the standard scheme become small. CONTACT's tractions have the same waves. Under-relaxed steps have no
# waves, and the error of steps of an element.
wiggles = tables."/wiggles.tsv"
of(load, scheme, q) = strcol("load") eq load && strcol("scheme") eq scheme && same(column("distance"), q) ? column("step_ratio") : NaN
names = "direct relaxed remembered"
labels = "standard under-relaxed remembered"
eval page(800, 400)
set multiplot layout 1,2 margins 0.105,0.98,0.17,0.89 spacing 0.115,0.14
set logscale xy
set format y "10^{%T}"
set xrange [0.025:1.2]
set xtics (0.03, 0.1, 0.3, 1)
set xlabel "step over the element, c [1]"
set title "waves after 1.5 a, over μp_0"
set ylabel "largest wave [1]"
set yrange [1e-4:1]
set key bottom left
plot for [s=1:3] wiggles using (of("creepage", word(names, s), 1.5)):"wave" with linespoints pointtype 7 pointsize 0.5 \
       linecolor rgb colour_of(word(names, s)) notitle, \
     for [s=1:3] wiggles using (of("force", word(names, s), 1.5)):"wave" with linespoints dashtype 2 pointtype 6 pointsize 0.6 \
       linecolor rgb colour_of(word(names, s)) notitle, \
     wiggles using (of("force", "contact", 1.5)):"wave" with points pointtype 2 linecolor "black" title "CONTACT, held force", \
     NaN with linespoints pointtype 7 pointsize 0.5 linecolor "black" title "under a creepage", \
     NaN with linespoints dashtype 2 pointtype 6 pointsize 0.6 linecolor "black" title "under a held force"
set title "force after 3 a, over full sliding"
set ylabel "error [1]"
set yrange [1e-5:0.1]
plot for [s=1:3] wiggles using (of("creepage", word(names, s), 3)):"force_error" with linespoints pointtype 7 pointsize 0.5 \
       linecolor rgb colour_of(word(names, s)) title word(labels, s)
unset multiplot
