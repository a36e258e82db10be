# A quantity follows the key of a sweep, with a line for each combination of the other keys. Carter's exact solution is
# there where it holds.
load scripts."/microslip.gpi"
cases = tables."/cases.tsv"
tics = said(cases, "x_tics")
below = 62 + said(cases, "x_tic_height")
heading = said(cases, "key_heading")
if (strlen(heading)) { key_top = key_top + 21 }
key_point = 0.45
eval key_height
height = 320 + below + top
eval page(640, height)
do for [pass=1:2] {
  eval begin_pass
  eval area(top, height - below)
  set format x "%g"
  set xlabel said(cases, "x_label") noenhanced
  set ylabel said(cases, "y_label") noenhanced
  if (said(cases, "x_log") eq "1") { set logscale x; set autoscale xfix }
  if (said(cases, "y_log") eq "1") { set logscale y; set format y "10^{%T}" }
  if (said(cases, "x_log") ne "1") { set offsets graph 0.02, graph 0.02, 0, 0 }
  if (below > 62) { set xlabel ""; set label 2 said(cases, "x_label") at graph 0.5, screen 16. / height center noenhanced }
  if (strlen(tics) > 0) { set offsets 0.5, 0.5, 0, 0; eval "set xtics noenhanced ".tics }
  eval "set xrange ".x_range
  ends = extent_within(cases, "x", x_range, "x")
  only = real(word(ends, 1))
  if (only == real(word(ends, 2)) && strlen(tics) == 0) { set xrange [only - (only == 0 ? 1 : 0.1 * abs(only)):only + (only == 0 ? 1 : 0.1 * abs(only))] }
  eval flat_axis(cases, "x", x_range, "y", "nothing but 0")
  eval draw_key
  if (strlen(heading)) { set label 3 heading at screen 0.02, screen 1 - 14. / height left noenhanced }
  plot for [k=1:lines] cases using (of(k, column("x"))):"y" with linespoints linecolor rgb color(k) dashtype dash(k) linewidth width(k) pointtype 7 pointsize (is_exact(k) ? 0 : 0.45)
  eval end_panel
  unset multiplot
}
