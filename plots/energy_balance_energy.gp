# Energies against the distance, and the error of their sum for two ledgers.
energy = tables."/energy.tsv"
at(frame, integrator) = strcol("frame") eq frame && strcol("integrator") eq integrator ? column("X") : NaN

eval page(860, 400)
set multiplot layout 1,2 margins 0.095,0.98,0.15,0.9 spacing 0.12
set xlabel "distance rolled X [mm]"
set ylabel "energy per mm of width [N]"
set key bottom right
set logscale y
set format y "10^{%T}"
set yrange [1e-5:20]
set title "where the energy goes"
plot energy using (at("world", "midpoint")):(-column("potential")) with lines linetype 7 title "lost height", \
     energy using (at("world", "midpoint")):"translation" with lines linetype 1 title "translation", \
     energy using (at("world", "midpoint")):"rotation" with lines linetype 2 title "rotation", \
     energy using (at("world", "midpoint")):"dissipated" with lines linetype 3 title "dissipated", \
     energy using (at("world", "midpoint")):"elastic" with lines linetype 4 title "elastic"
set yrange [1e-18:1]
set ylabel "|sum of energies| / (F_{cm} X) [1]"
set key inside right center
set title "what is missing"
error(name) = abs(column(name) / column("potential")) + 1e-18
plot energy using (at("contact", "verlet")):(error("total")) with lines linetype 2 title "contact-fixed, Verlet, end of step", \
     energy using (at("world", "verlet")):(error("total")) with lines linetype 5 dashtype 2 title "world-fixed, Verlet, end of step", \
     energy using (at("world", "verlet")):(error("mean_total")) with lines linetype 3 title "world-fixed, Verlet, mean", \
     energy using (at("world", "midpoint")):(error("mean_total")) with lines linetype 1 title "world-fixed, midpoint, mean"
unset multiplot
