# Line contacts in the place of ellipses of the same half-width, full sliding and area: differences of the force, over full
# sliding. A strip of the width pi b/2 serves for any a/b; plane strain serves where the ellipse is much wider than long.
lines_table = tables."/lines.tsv"
of(direction, load) = strcol("direction") eq direction && abs(column("load") / load - 1) < 1e-6 ? column("aspect") : NaN

eval page(800, 400)
set multiplot layout 1,2 margins 0.105,0.98,0.17,0.89 spacing 0.115,0.14
set logscale x
set xrange [0.09:11]
set yrange [-0.6:0.1]
set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10)
set xlabel "a/b, along over across the rolling [1]"
loads = "0.3 0.6 1"
do for [panel=1:2] {
  direction = panel == 1 ? "longitudinal" : "lateral"
  set title direction
  if (panel == 1) { set ylabel "difference of the force, over full sliding [1]" } else { unset ylabel }
  if (panel == 1) { set key left bottom at graph 0.02,0.02 Left reverse samplen 1.8 } else { unset key }
  plot for [i=1:3] lines_table using (of(direction, real(word(loads, i)))):"strip_error" with linespoints \
         linecolor rgb colour_of("calibrated") dashtype i pointtype 4+i pointsize 0.5 title sprintf("strip, load %s", word(loads, i)), \
       for [i=1:3] lines_table using (of(direction, real(word(loads, i)))):"plane_error" with linespoints \
         linecolor rgb colour_of("standard") dashtype i pointtype 4+i pointsize 0.5 title sprintf("plane, load %s", word(loads, i))
}
unset multiplot
