# A cylinder that rolls down a slope gains velocity while the force of its contact swings and settles. From above:
# tractions at the end, velocity, force, and what the balance of energy misses with tractions at the end of each step.
load scripts."/microslip.gpi"
traction = tables."/traction.tsv"
history = tables."/history.tsv"
rows_of_key = rows(lines + 1)
height = 860 + key_height(lines + 1)
eval page(640, height)
set multiplot layout 4,1 margins 0.15,0.97,57./height,1-key_height(lines + 1)/height spacing 0.07
eval "set xrange ".x_range
set xlabel "x [mm], rolling to the right"
set ylabel "traction p [N/mm^2]"
eval above(height)
plot for [k=1:lines] traction using (of(k, column("x"))):"bound" with @bound_line title k == 1 ? "bound ±g" : "", \
     for [k=1:lines] traction using (of(k, column("x"))):(-column("bound")) with @bound_line notitle, \
     for [k=1:lines] traction using (of(k, column("x"))):"traction" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k) title label(k)
unset key
set autoscale xfix
eval "set xrange ".q_range
set format x "%g"
set xlabel "distance rolled X [mm]"
set ylabel "velocity v [mm/s]"
plot for [k=1:lines] history using (of(k, column("X"))):"v" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
set ylabel "force F [N/mm]"
plot for [k=1:lines] history using (of(k, column("X"))):"force" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
set ylabel "energy missing, of F_{cm} X"
set logscale y
set format y "10^{%L}"
plot for [k=1:lines] history using (column("X") > 0 ? of(k, column("X")) : NaN):(shown(abs(column("total") / column("potential")))) with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
unset multiplot
