# The cheapest scheme for an accuracy is the line that crosses the dashed one farthest to the left: by number of
# elements (above) and by measured time (below). The dashed line is the accuracy wanted.
timing = tables."/converge_timing.tsv"
wanted = parameter(tables."/converge.tsv", "converge.error")
names = system(sprintf("grep -v '^#' \"%s\" | tail -n +2 | cut -f1 | uniq", timing))
of(k, value) = strcol("scheme") eq word(names, k) ? value : NaN
entries = 1 + words(names)
entry_label(i) = i == 1 ? sprintf("%g, wanted", wanted) : word(names, i - 1)
entry_colour(i) = i == 1 ? "#999999" : colour_of(word(names, i - 1))
entry_dash(i) = 1 + (i == 1)
entry_width(i) = 1
load scripts."/microslip_margins.gpi"
key_point = 0.5
eval key_height
height = 768 + top
eval page(640, height)
shown(error) = error < 1e-10 ? 1e-10 : error  # ten digits are enough
do for [pass=1:2] {
  eval begin_pass
  set logscale xy
  set format y "10^{%T}"
  set format x "%g"
  set ylabel "relative error of the answer"
  eval area(top, top + 310)
  set xlabel "number of elements N"
  set xtics (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, "10^4" 10000, "2·10^4" 20000, "5·10^4" 50000, "10^5" 1e5)
  eval "set xrange ".x_range
  eval draw_key
  plot wanted with lines linecolor "gray60" dashtype 2, \
       for [k=1:words(names)] timing using (of(k, column("elements"))):(shown(column("answer_error"))) with linespoints linecolor rgb colour_of(word(names, k)) pointtype 7 pointsize 0.5
  eval end_panel
  eval without_key
  eval area(top + 390, top + 700)
  set xlabel "measured time [s]"
  set xtics autofreq
  set xrange [*:*]
  set format x "10^{%T}"
  plot wanted with lines linecolor "gray60" dashtype 2, \
       for [k=1:words(names)] timing using (of(k, column("time"))):(shown(column("answer_error"))) with linespoints linecolor rgb colour_of(word(names, k)) pointtype 7 pointsize 0.5
  eval end_panel
  unset multiplot
}
