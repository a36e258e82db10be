# The balance of energy is exact for any N by remembered with the midpoint rule. The motion converges with second
# order by remembered, and more slowly by direct.
energy = tables."/energy_error.tsv"
motion = tables."/motion_error.tsv"
of(scheme, integrator) = strcol("scheme") eq scheme && strcol("integrator") eq integrator ? column("elements") : NaN

eval page(900, 400)
set multiplot layout 1,2 margins 0.11,0.98,0.15,0.9 spacing 0.12
set logscale xy
set format y "10^{%T}"
set xlabel "number of elements N [1]"
set ylabel "|sum of energies| / (F_{cm} X) [1]"
set yrange [1e-18:0.1]
set key at graph 0.98, 0.68
set title "balance of energy"
plot energy using (of("direct", "verlet")):"error" with linespoints linecolor rgb colour_of("direct verlet") pointtype 6 pointsize 0.6 title "direct, Verlet, end of step", \
     energy using (of("direct", "leapfrog")):"error" with points linetype 7 pointtype 1 pointsize 0.6 title "direct, leapfrog", \
     energy using (of("remembered", "verlet")):"mean_error" with linespoints linecolor rgb colour_of("remembered verlet") pointtype 5 pointsize 0.4 title "remembered, Verlet", \
     energy using (of("remembered", "midpoint")):"error" with linespoints linetype 5 pointtype 8 pointsize 0.6 title "remembered, midpoint, end of step", \
     energy using (of("remembered", "midpoint")):(column("mean_error") + 1e-18) with linespoints linecolor rgb colour_of("remembered midpoint") pointtype 7 pointsize 0.5 title "remembered, midpoint", \
     0.2 / x with lines linecolor "gray60" dashtype 2 title "first order"
set yrange [*:*]
set xrange [15:210]
set ylabel "error of v(t), root of mean square [1]"
unset key
set key inside bottom left
set xtics (20, 40, 80, 160)
set title "motion, against a finer grid"
plot motion using (of("direct", "verlet")):"velocity_error" with linespoints linecolor rgb colour_of("direct verlet") pointtype 6 pointsize 0.6 title "direct, Verlet", \
     motion using (of("remembered", "verlet")):"velocity_error" with linespoints linecolor rgb colour_of("remembered verlet") pointtype 5 pointsize 0.4 title "remembered, Verlet", \
     motion using (of("remembered", "midpoint")):"velocity_error" with linespoints linecolor rgb colour_of("remembered midpoint") pointtype 7 pointsize 0.4 title "remembered, midpoint", \
     0.4 / x**2 with lines linecolor "gray60" dashtype 2 title "second order"
unset multiplot
