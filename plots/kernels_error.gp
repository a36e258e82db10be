# Where is the leading edge felt, and of which order is the force on each kernel? C_a = 2 (1 - nu) a/G.
edges = tables."/edges.tsv"
errors = tables."/errors.tsv"
slopes = tables."/slopes.tsv"
cases = system(sprintf("grep -v '^#' \"%s\" | tail -n +2 | cut -f2", slopes))
titled(k) = word(cases, k) eq "inf" ? "springs alone" : word(cases, k) + 0 == 0 ? "half-space" : sprintf("layer, C/C_a = %.3g", word(cases, k) + 0)
of(scheme, k) = strcol("scheme") eq scheme && strcol("softness") eq word(cases, k) ? shown(abs(column("error"))) : NaN
eval page(960, 430)
set multiplot layout 1,2 margins 0.075,0.98,0.16,0.95 spacing 0.1
set logscale x
set format x "10^{%T}"
set xlabel "compliance of the layer over that of an element [1]" offset 0,0.2
set ylabel "elements from the last node to the edge [1]"
set yrange [0.8:1.02]
set key bottom right
plot edges using "element_softness":"offset" with lines linetype 1 title "Wiener and Hopf", \
     edges using "element_softness":"measured" with points linetype 2 pointtype 6 pointsize 0.7 title "measured with 40 elements"
set logscale y
set format x "%g"
set format y "10^{%T}"
set xlabel "number of elements N"
set ylabel "error of the force over full sliding [1]"
set xtics (50, 100, 200, 400, 800)
set xrange [40:1000]
set yrange [3e-11:3e-2]
set key bottom left Left reverse
plot for [k=1:words(cases)] errors using "elements":(of("standard", k)) with linespoints linetype k dashtype 2 pointtype 6 pointsize 0.6 notitle, \
     for [k=1:words(cases)] errors using "elements":(of("calibrated", k)) with linespoints linetype k pointtype 7 pointsize 0.5 title titled(k), \
     keyentry with linespoints linecolor "gray40" dashtype 2 pointtype 6 pointsize 0.6 title "standard, as CONTACT"
unset multiplot
