# A transient: tractions within their bound at the end, and force and creepage on the way.
traction = tables."/traction.tsv"
history = tables."/history.tsv"
eval page(640, 620)
set multiplot layout 2,1 margins 0.15,0.83,0.11,0.96 spacing 0.13
set xlabel "x [mm], rolling to the right"
set ylabel "traction p [N/mm^2]"
set key at graph 0.66,0.9
plot traction using "x":"bound" with @bound_line title "bound ±g", \
     traction using "x":(-column("bound")) with @bound_line notitle, \
     traction using "x":"traction" with lines linetype 1 title "traction at the end"
set autoscale xfix
set xlabel "distance rolled q [mm]"
set ylabel "force F [N/mm]"
set y2label "creepage w" offset -1,0
set ytics nomirror
set y2tics
set yrange [*<0:0<*]
set y2range [*<0:0<*]
set key at graph 0.97,1.06 horizontal
# The first row is the start, where there is no creepage.
plot history using "q":"force" with lines linetype 3 title "force, left", \
     history using (column("q") > 0 ? column("q") : NaN):"creepage" axes x1y2 with lines linetype 2 title "creepage, right"
unset multiplot
