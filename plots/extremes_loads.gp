# The inversion keeps its digits from full sliding to full stick; Chebyshev collocation loses 2e-16/(1 - a') of them
# next to full stick (dashed), and elements are off by 0.005 to 7 %. Steady rolling, N = 51.
loads = tables."/loads.tsv"
names = "standard known_edge calibrated chebyshev inversion"
labels = "standard 'known edge' calibrated chebyshev inversion"
# The rows of a scheme alone, or lines would break at the others.
of(scheme) = sprintf("< awk -F'\t' '/^#/ || !head++ || $1 == \"%s\"' \"%s\"", scheme, loads)
good(coordinate) = strcol("verdict") eq "ok" && column(coordinate) > 0 && column(coordinate) <= 0.5 ? column(coordinate) : NaN

eval page(700, 420)
set logscale xy
set format "10^{%T}"
set yrange [1e-16:1]
unset key
set multiplot
set bmargin at screen 0.15
set tmargin at screen 0.9
set lmargin at screen 0.12
set rmargin at screen 0.43
set ylabel "error of force or creepage"
set xrange [5e-7:0.5]
set xlabel "stick ratio a'"
set title "to full sliding" offset 0,-0.5
plot for [i=1:words(names)] of(word(names, i)) using (good("stuck")):(shown(column("error"))) with linespoints linecolor rgb colour_of(word(names, i)) pointtype 7 pointsize 0.5
set lmargin at screen 0.53
set rmargin at screen 0.84
unset ylabel
set xrange [0.5:5e-13]
set xtics 1e3
set xlabel "part that slides, 1 - a'"
set title "to full stick" offset 0,-0.5
plot for [i=1:words(names)] of(word(names, i)) using (good("sliding")):(shown(column("error"))) with linespoints linecolor rgb colour_of(word(names, i)) pointtype 7 pointsize 0.5, \
     2e-16 / x with lines linecolor "gray50" dashtype 2, \
     for [i=1:words(names)] of(word(names, i)) \
       using (column("sliding") > 0 && column("sliding") < 5e-12 ? column("sliding") : NaN):(shown(column("error")) * (word(names, i) eq "known_edge" ? 2.5 : word(names, i) eq "standard" ? 0.5 : 1)):(word(labels, i)) with labels left offset 0.8,0 textcolor rgb label_colour_of(word(names, i))
unset multiplot
