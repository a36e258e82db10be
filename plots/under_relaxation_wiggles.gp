# Under-relaxation removes the wiggles at any step: the local extrema of the traction stay as few as at c = 1. After the
# first distance.
wiggles = tables."/wiggles.tsv"
of(scheme) = strcol("scheme") eq scheme ? column("step_ratio") : NaN

eval page(640, 360)
set logscale x
set format x "10^{%T}"
set xlabel "step ratio c = dq/dx [1]"
set ylabel "local extrema of the traction [1]"
set yrange [0:*]
set key at graph 0.6, 0.5
set title "wiggles against the step"
plot wiggles using (of("direct")):"turning_points" with linespoints linecolor rgb colour_of("direct") pointtype 6 pointsize 0.6 title "direct", \
     wiggles using (of("relaxed")):"turning_points" with linespoints linecolor rgb colour_of("relaxed") pointtype 7 pointsize 0.5 title "relaxed, c* = 1"
