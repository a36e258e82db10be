# The balance of energy misses nothing but rounding by remembered with the midpoint rule, and some tenths of a percent
# with tractions at the end of each step (right). Most of the lost height becomes translation and rotation (left).
energy = tables."/energy.tsv"
at(scheme, integrator) = strcol("scheme") eq scheme && strcol("integrator") eq integrator ? column("X") : NaN

# Labels stand at the ends of the lines.
end = last_value(energy, "$1 == \"remembered\" && $2 == \"midpoint\"", "X")
end_of(name) = last_value(energy, "$1 == \"remembered\" && $2 == \"midpoint\"", name)
names = "potential translation rotation dissipated elastic"
said = "'lost height' translation rotation dissipated elastic"

eval page(900, 400)
set multiplot layout 1,2 margins 0.085,0.98,0.15,0.9 spacing 0.11
set xlabel "distance rolled X [mm]"
set ylabel "energy per mm of width [N]"
set logscale y
set format y "10^{%T}"
set yrange [1e-5:20]
set title "where the energy goes"
set xrange [0:1.32*end]
unset key
do for [k=1:5] { set label k word(said, k) at end, abs(end_of(word(names, k))) * (k == 1 ? 1.6 : k == 3 ? 0.7 : 1) offset 0.5,0 textcolor rgb (k == 1 ? "#000000" : label_colour_of_line(k - 1)) }
plot energy using (at("remembered", "midpoint")):(-column("potential")) with lines linetype 7, \
     energy using (at("remembered", "midpoint")):"translation" with lines linetype 1, \
     energy using (at("remembered", "midpoint")):"rotation" with lines linetype 2, \
     energy using (at("remembered", "midpoint")):"dissipated" with lines linetype 3, \
     energy using (at("remembered", "midpoint")):"elastic" with lines linetype 4
set yrange [1e-18:1]
set ylabel "|sum of energies| / (F_{cm} X) [1]"
set xrange [0:end]
unset label
set label 1 "end of step: direct, Verlet" at graph 0.5, first 3e-2 center textcolor rgb label_colour_of("direct verlet")
set label 2 "end of step: remembered, Verlet" at graph 0.5, first 2e-4 center textcolor rgb label_colour_of_line(5)
set label 3 "remembered, Verlet" at graph 0.5, first 8e-8 center textcolor rgb label_colour_of("remembered verlet")
set label 4 "remembered, midpoint: rounding" at graph 0.5, first 3e-14 center textcolor rgb label_colour_of("remembered midpoint")
set title "what is missing"
error(name) = abs(column(name) / column("potential")) + 1e-18
plot energy using (at("direct", "verlet")):(error("total")) with lines linecolor rgb colour_of("direct verlet"), \
     energy using (at("remembered", "verlet")):(error("total")) with lines linetype 5 dashtype 2, \
     energy using (at("remembered", "verlet")):(error("mean_total")) with lines linecolor rgb colour_of("remembered verlet"), \
     energy using (at("remembered", "midpoint")):(error("mean_total")) with lines linecolor rgb colour_of("remembered midpoint")
unset multiplot
