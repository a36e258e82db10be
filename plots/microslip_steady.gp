# Steady rolling: tractions within their bound, and slip.
traction = tables."/traction.tsv"
eval page(640, 520)
set multiplot layout 2,1 margins 0.15,0.97,0.11,0.96 spacing 0.04
set format x ""
set ylabel "traction p [N/mm^2]"
set key at graph 0.66,0.9
plot traction using "x":"bound" with @bound_line title "bound ±g", \
     traction using "x":(-column("bound")) with @bound_line notitle, \
     traction using "x":"traction" with lines linetype 1 title "traction"
set format x
set xlabel "x [mm], rolling to the right"
set ylabel "relative slip s"
set key top right
plot traction using "x":"slip" with lines linetype 2 title "slip"
unset multiplot
