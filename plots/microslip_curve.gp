# The force grows ever more slowly with the creepage, until the whole contact slides. Steady rolling; FASTSIM has dashed
# lines where it was asked for, and Carter's exact solution is there where it holds.
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
tics = said(cases, "x_tics")
if (strlen(tics) > 0) { eval "set xtics noenhanced ".tics }
eval "set xrange ".x_range
eval above(height)
plot for [k=1:lines] cases using (of(k, column("x"))):"y" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k) title label(k)
