# Force and creepage change as the contact rolls on (below); the tractions at the end stay within their bounds (above).
# A transient, for one or more results.
load scripts."/microslip.gpi"
traction = tables."/traction.tsv"
history = tables."/history.tsv"
rows_of_key = rows(lines + 1)
height = 690 + key_height(lines + 1)
top = 1 - key_height(lines + 1) / height
eval page(640, height)
set multiplot
set lmargin at screen 0.15; set rmargin at screen 0.97
set tmargin at screen top; set bmargin at screen top - 250./height
eval "set xrange ".x_range
set xlabel "x [mm], rolling to the right"
set ylabel "traction p at the end [N/mm^2]"
eval above(height)
plot for [k=1:lines] traction using (of(k, column("x"))):"bound" with @bound_line title k == 1 ? "bound ±g" : "", \
     for [k=1:lines] traction using (of(k, column("x"))):(-column("bound")) with @bound_line notitle, \
     for [k=1:lines] traction using (of(k, column("x"))):"traction" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k) title label(k)
unset key
set autoscale xfix
eval "set xrange ".q_range
set yrange [*<0:0<*]
unset xlabel
set format x ""
set tmargin at screen top - 320./height; set bmargin at screen top - 465./height
set ylabel "force F [N/mm]"
eval zero_axis(history, "q", "force", "no force")
plot for [k=1:lines] history using (of(k, column("q"))):"force" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
eval ordinary_axis
set yrange [*<0:0<*]
set format x "%g"
set xlabel "distance rolled q [mm]"
set ylabel "creepage w"
eval zero_axis(history, "q", "creepage", "no creepage")
set tmargin at screen top - 480./height; set bmargin at screen top - 625./height
plot for [k=1:lines] history using (of(k, column("q"))):"creepage" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
unset multiplot
