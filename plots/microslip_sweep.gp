# A quantity follows the key of a sweep, with a line for each combination of the other keys. Carter's exact solution is
# there where it holds.
load scripts."/microslip.gpi"
cases = tables."/cases.tsv"
rows_of_key = rows(lines)
height = 370 + key_height(lines)
eval page(640, height)
set lmargin at screen 0.15; set rmargin at screen 0.96
set bmargin at screen 57./height; set tmargin at screen 1 - key_height(lines) / height
set format x "%g"
set xlabel said(cases, "x_label") noenhanced
set ylabel said(cases, "y_label") noenhanced
if (said(cases, "x_log") eq "1") { set logscale x; set autoscale xfix }
if (said(cases, "y_log") eq "1") { set logscale y; set format y "10^{%T}" }
if (said(cases, "x_log") ne "1") { set offsets graph 0.02, graph 0.02, 0, 0 }
tics = said(cases, "x_tics")
if (strlen(tics) > 0) { eval "set xtics noenhanced ".tics }
eval "set xrange ".x_range
eval above(height)
plot for [k=1:lines] cases using (of(k, column("x"))):"y" with linespoints linecolor rgb color(k) dashtype dash(k) linewidth width(k) pointtype 7 pointsize (is_exact(k) ? 0 : 0.45) title label(k)
