# The force grows ever more slowly with the creepage, until the whole contact slides. Steady rolling; FASTSIM has dashed
# lines where it was asked for, and Carter's exact solution is there where it holds.
load scripts."/microslip.gpi"
cases = tables."/cases.tsv"
tics = said(cases, "x_tics")
below = 62 + said(cases, "x_tic_height")
heading = said(cases, "key_heading")
if (strlen(heading)) { key_top = key_top + 21 }
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
  if (strlen(tics) > 0) { eval "set xtics noenhanced ".tics }
  eval "set xrange ".x_range
  eval flat_axis(cases, "x", x_range, "y", "nothing but 0")
  eval draw_key
  if (strlen(heading)) { set label 3 heading at screen 0.02, screen 1 - 14. / height left noenhanced }
  plot for [k=1:lines] cases using (of(k, column("x"))):"y" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
  eval end_panel
  unset multiplot
}
