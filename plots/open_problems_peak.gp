# Steps below one element lower the travelling peak by the schemes direct and relaxed, and not by remembered. Left is
# its height against the step ratio, right the tractions at a small one; the reference is black.
steps = tables."/steps.tsv"
traction = tables."/traction.tsv"
of(scheme) = strcol("scheme") eq scheme ? column("step_ratio") : NaN
small = 0.1
at(scheme, c) = strcol("scheme") eq scheme && same(column("step_ratio"), c) ? column("x") : NaN

eval page(860, 400)
set multiplot layout 1,2 margins 0.105,0.98,0.14,0.9 spacing 0.115
set logscale x
set xlabel "step ratio c = dq/dx [1]"
set ylabel "height of the peak over the reference's [1]"
set title "peak"
set key bottom right
plot steps using (of("direct")):"peak" with linespoints linecolor rgb colour_of("direct") pointtype 7 pointsize 0.5 title "direct", \
     steps using (of("relaxed")):"peak" with linespoints linecolor rgb colour_of("relaxed") pointtype 7 pointsize 0.5 title "relaxed, c* = 1", \
     steps using (of("remembered")):"peak" with linespoints linecolor rgb colour_of("remembered") pointtype 7 pointsize 0.5 title "remembered"
unset logscale x
set xlabel "x [mm], rolling to the right"
set ylabel "traction p [N/mm^2]"
set title sprintf("c = %g", small)
unset key
set xrange [-1:1]
set yrange [0:*]
plot traction using (at("reference", 1)):"traction" with @exact_line title "reference", \
     traction using (at("direct", small)):"traction" with lines linecolor rgb colour_of("direct") title "direct", \
     traction using (at("relaxed", small)):"traction" with lines linecolor rgb colour_of("relaxed") title "relaxed", \
     traction using (at("remembered", small)):"traction" with linespoints linecolor rgb colour_of("remembered") pointtype 7 pointsize 0.3 title "remembered"
unset multiplot
