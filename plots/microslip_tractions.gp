# Tractions stay within their bounds; where a line touches its bound, the contact slips. Results of different kinds,
# transients at their end.
load scripts."/microslip.gpi"
traction = tables."/traction.tsv"
rows_of_key = rows(lines + 1)
height = 350 + key_height(lines + 1)
eval page(640, height)
set lmargin at screen 0.15; set rmargin at screen 0.97
set bmargin at screen 57./height; set tmargin at screen 1 - key_height(lines + 1) / height
eval "set xrange ".x_range
set xlabel "x [mm], rolling to the right"
set ylabel "traction p [N/mm^2]"
eval above(height)
plot for [k=1:lines] traction using (of(k, column("x"))):"bound" with @bound_line title k == 1 ? "bound ±g" : "", \
     for [k=1:lines] traction using (of(k, column("x"))):(-column("bound")) with @bound_line notitle, \
     for [k=1:lines] traction using (of(k, column("x"))):"traction" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k) title label(k)
