# Left, where the energy of the lost height goes. Right, what the balance misses: nothing but rounding by remembered
# with the midpoint rule, some tenths of a percent with tractions at the end of each step.
energy = tables."/energy.tsv"
at(scheme, integrator) = strcol("scheme") eq scheme && strcol("integrator") eq integrator ? column("X") : NaN

eval page(860, 400)
set multiplot layout 1,2 margins 0.095,0.98,0.15,0.9 spacing 0.12
set xlabel "distance rolled X [mm]"
set ylabel "energy per mm of width [N]"
set key bottom right
set logscale y
set format y "10^{%T}"
set yrange [1e-5:20]
set title "where the energy goes"
plot energy using (at("remembered", "midpoint")):(-column("potential")) with lines linetype 7 title "lost height", \
     energy using (at("remembered", "midpoint")):"translation" with lines linetype 1 title "translation", \
     energy using (at("remembered", "midpoint")):"rotation" with lines linetype 2 title "rotation", \
     energy using (at("remembered", "midpoint")):"dissipated" with lines linetype 3 title "dissipated", \
     energy using (at("remembered", "midpoint")):"elastic" with lines linetype 4 title "elastic"
set yrange [1e-18:1]
set ylabel "|sum of energies| / (F_{cm} X) [1]"
set key inside right center
set title "what is missing"
error(name) = abs(column(name) / column("potential")) + 1e-18
plot energy using (at("direct", "verlet")):(error("total")) with lines linecolor rgb colour_of("direct verlet") title "direct, Verlet, end of step", \
     energy using (at("remembered", "verlet")):(error("total")) with lines linetype 5 dashtype 2 title "remembered, Verlet, end of step", \
     energy using (at("remembered", "verlet")):(error("mean_total")) with lines linecolor rgb colour_of("remembered verlet") title "remembered, Verlet", \
     energy using (at("remembered", "midpoint")):(error("mean_total")) with lines linecolor rgb colour_of("remembered midpoint") title "remembered, midpoint"
unset multiplot
