# A cylinder that rolls down a slope: tractions at the end, velocity, force of the contact, and what
# the balance of energy misses with tractions at the end of each step.
history = tables."/history.tsv"
traction = tables."/traction.tsv"
eval page(640, 900)
set multiplot layout 4,1 margins 0.15,0.97,0.06,0.98 spacing 0.07
set xlabel "x [mm], rolling to the right"
set ylabel "traction p [N/mm^2]"
set key at graph 0.66,0.9
plot traction using "x":"bound" with @bound_line title "bound ±g", \
     traction using "x":(-column("bound")) with @bound_line notitle, \
     traction using "x":"traction" with lines linetype 1 title "traction at the end"
set autoscale xfix
set format x "%g"
set xlabel "distance rolled X [mm]"
set ylabel "velocity v [mm/s]"
plot history using "X":"v" with lines linetype 1 notitle
set ylabel "force F [N/mm]"
plot history using "X":"force" with lines linetype 3 notitle
set ylabel "energy missing, of F_{cm} X"
set logscale y
set format y "10^{%L}"
plot history using (column("X") > 0 ? column("X") : NaN):(shown(abs(column("total") / column("potential")))) with lines linetype 4 notitle
unset multiplot
