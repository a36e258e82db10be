# The results of inversion and remembered do not depend on the step ratio; the results of the other schemes do. Left is
# steady rolling, right is rolling on from a shift.
steady = tables."/steady_steps.tsv"
steps = tables."/steps.tsv"
of(scheme) = strcol("scheme") eq scheme ? column("step_ratio") : NaN

eval page(860, 400)
set multiplot layout 1,2 margins 0.11,0.98,0.16,0.9 spacing 0.12
set logscale xy
set format "10^{%T}"
set xlabel "step ratio c = dq/dx [1]"
set ylabel "error of the force [1]"
set title "steady rolling"
set key at graph 0.62, 0.36
set xtics 1e-12, 1000
plot steady using (of("standard")):"force_error" with linespoints linecolor rgb colour_of("standard") pointtype 7 pointsize 0.5 title "standard", \
     steady using (of("inversion")):"force_error" with linespoints linecolor rgb colour_of("inversion") pointtype 7 pointsize 0.5 title "inversion"
set xtics auto
set title "from a Cattaneo shift"
set ylabel "integral of |p - reference| [N/mm]"
set key inside bottom left
set format x "%g"
plot steps using (of("direct")):"error" with linespoints linecolor rgb colour_of("direct") pointtype 7 pointsize 0.5 title "direct", \
     steps using (of("relaxed")):"error" with linespoints linecolor rgb colour_of("relaxed") pointtype 7 pointsize 0.5 title "relaxed, c* = 1", \
     steps using (of("remembered")):"error" with linespoints linecolor rgb colour_of("remembered") pointtype 7 pointsize 0.5 title "remembered"
unset multiplot
