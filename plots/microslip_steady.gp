# The contact slips where the traction reaches its bound, and sticks elsewhere. Steady rolling: tractions above, slip
# below, for one or more results, and with Carter's exact solution where it holds.
load scripts."/microslip.gpi"
traction = tables."/traction.tsv"
rows_of_key = rows(lines + 1)
height = 490 + key_height(lines + 1)
eval page(640, height)
set multiplot layout 2,1 margins 0.15,0.97,57./height,1-key_height(lines + 1)/height spacing 0.04
eval "set xrange ".x_range
set format x ""
set ylabel "traction p [N/mm^2]"
eval above(height)
plot for [k=1:lines] traction using (of(k, column("x"))):"bound" with @bound_line title k == 1 ? "bound ±g" : "", \
     for [k=1:lines] traction using (of(k, column("x"))):(-column("bound")) with @bound_line notitle, \
     for [k=1:lines] traction using (of(k, column("x"))):"traction" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k) title label(k)
set format x
set xlabel "x [mm], rolling to the right"
set ylabel "relative slip s"
unset key
eval zero_axis(traction, "x", "slip", "no slip: all sticks")
plot for [k=1:lines] traction using (of(k, column("x"))):"slip" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
unset multiplot
