# The cheapest scheme for an accuracy is the line that crosses the dashed one farthest to the left: by number of
# elements (left) and by measured time (right). The dashed line is the accuracy wanted.
timing = tables."/converge_timing.tsv"
wanted = parameter(tables."/converge.tsv", "converge.error")
names = system(sprintf("grep -v '^#' \"%s\" | tail -n +2 | cut -f1 | uniq", timing))
of(k, value) = strcol("scheme") eq word(names, k) ? value : NaN
eval page(980, 450)
shown(error) = error < 1e-10 ? 1e-10 : error  # ten digits are enough
set multiplot
set logscale xy
set format y "10^{%T}"
set ylabel "relative error of the answer"
set bmargin at screen 0.15; set tmargin at screen 0.96
set lmargin at screen 0.08; set rmargin at screen 0.40
set xlabel "number of elements N"
set xtics (10, 20, 50, 100, 200, 500, 1000, 2000, 5000)
eval "set xrange ".x_range
unset key
plot wanted with lines linecolor "gray60" dashtype 2, \
     for [k=1:words(names)] timing using (of(k, column("elements"))):(shown(column("answer_error"))) with linespoints linecolor rgb colour_of(word(names, k)) pointtype 7 pointsize 0.5
set lmargin at screen 0.47; set rmargin at screen 0.79
set ylabel ""
set xlabel "measured time [s]"
set xtics autofreq
set xrange [*:*]
set format x "10^{%T}"
set key at screen 0.805, 0.95 left top Left reverse noenhanced
plot wanted with lines linecolor "gray60" dashtype 2 title sprintf("%g, wanted", wanted), \
     for [k=1:words(names)] timing using (of(k, column("time"))):(shown(column("answer_error"))) with linespoints linecolor rgb colour_of(word(names, k)) pointtype 7 pointsize 0.5 title word(names, k)
unset multiplot
