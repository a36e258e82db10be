# Steady rolling from full sliding to full stick.
loads = tables."/loads.tsv"
of(name, coordinate, limit) = strcol("scheme") eq name && strcol("verdict") eq "ok" && column(coordinate) > 0 && column(coordinate) <= limit ? column(coordinate) : NaN
names = "standard 'standard linear' known_edge calibrated inversion chebyshev"
labels = "standard 'standard linear' 'known edge' calibrated inversion chebyshev"

eval page(860, 420)
set logscale xy
set format "10^{%T}"
set yrange [1e-16:1]
set multiplot
set bmargin at screen 0.15
set tmargin at screen 0.9
set lmargin at screen 0.105
set rmargin at screen 0.42
set ylabel "error of force or creepage [1]"
set xlabel "part that sticks a' [1]"
set title "to full sliding" offset 0,-0.5
unset key
plot for [i=1:words(names)] loads using (of(word(names, i), "stuck", 0.5)):(shown(column("error"))) with linespoints linetype i pointtype 7 pointsize 0.5 notitle
set lmargin at screen 0.48
set rmargin at screen 0.81
unset ylabel
set xrange [1:5e-13]
set xlabel "part that slides 1 - a' [1]"
set title "to full stick" offset 0,-0.5
set key at screen 0.83, 0.9 left top Left reverse samplen 1
plot for [i=1:words(names)] loads using (of(word(names, i), "sliding", 0.5)):(shown(column("error"))) with linespoints linetype i pointtype 7 pointsize 0.5 title word(labels, i), \
     2e-16 / x with lines linecolor "gray50" dashtype 2 title "2·10^{-16}/(1 - a')"
unset multiplot
