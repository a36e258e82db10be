# For the same error of v(t) the midpoint rule solves the contact several times as often as Verlet (left); steps that
# are chosen by a tolerance are fewer than equal ones (right).
motion = tables."/motion_error.tsv"
control = tables."/step_control.tsv"
of(integrator) = strcol("scheme") eq "remembered" && strcol("integrator") eq integrator ? column("contact_steps") : NaN
by(steps) = strcol("steps") eq steps ? column("count") : NaN

eval page(860, 400)
set multiplot layout 1,2 margins 0.1,0.98,0.15,0.9 spacing 0.12
set logscale xy
set format y "10^{%T}"
set key inside top right
set ylabel "error of v(t), root of mean square [1]"
set xlabel "steps of the contact solved [1]"
set yrange [1e-6:1e-1]
set title "finer grids, c = 1"
plot motion using (of("verlet")):"velocity_error" with linespoints linecolor rgb colour_of("remembered verlet") pointtype 5 pointsize 0.5 title "Verlet", \
     motion using (of("leapfrog")):"velocity_error" with points linetype 7 pointtype 1 pointsize 0.8 title "leapfrog", \
     motion using (of("midpoint")):"velocity_error" with linespoints linecolor rgb colour_of("remembered midpoint") pointtype 7 pointsize 0.5 title "midpoint, exact balance", \
     0.5 / x**2 with lines linecolor "gray60" dashtype 2 title "second order"
set xlabel "time steps [1]"
set yrange [1e-7:1e-2]
set xrange [200:6000]
set xtics (250, 500, 1000, 2000, 4000)
set title "time steps alone, midpoint"
plot control using (by("equal")):"velocity_error" with linespoints linetype 7 pointtype 6 pointsize 0.6 title "equal: c = 4 to 0.25", \
     control using (by("tolerance")):"velocity_error" with linespoints linecolor rgb colour_of("remembered midpoint") pointtype 7 pointsize 0.5 title "by a tolerance, c = 4"
unset multiplot
