# The error of the force falls with first order by the thesis's scheme, with order 3/2 if the displacement at the edge
# is known, with second order if edges are calibrated, and is nothing but rounding by inversion. Lines are medians over
# 50 random stick ratios and alignments of the grid in steady rolling; bands go from the least error to the largest.
errors = tables."/errors.tsv"
orders = tables."/orders.tsv"
names = "standard known_edge calibrated inversion"
titles = "'thesis and CONTACT' 'edge known' 'calibrated edges' 'inversion: rounding'"
# Where the labels stand, as factors above the ends of the lines.
above = "1 1.2 0.7 1"
of(scheme) = strcol("scheme") eq scheme ? column("elements") : NaN
least = 1e-17
seen(name) = column(name) > least ? column(name) : least  # a logarithm has no zero
order_of = ""
set table $orders
plot orders using (order_of = order_of.sprintf(" %s %.2f", strcol("scheme"), column("force_order")), 0) with table
unset table
order(scheme) = word(order_of, 1 + int(sum [i=1:words(order_of)] (word(order_of, i) eq scheme ? i : 0)))

stats errors using "elements" name "n" nooutput
eval page(640, 440)
set logscale xy
set format y "10^{%T}"
set xtics (15, 30, 60, 120, 240, 480)
set xrange [13:560]
set rmargin at screen 0.6
set xlabel "elements N [1]"
set ylabel "relative error of the force [1]"
set yrange [least:1]
unset key
label(k) = word(titles, k).(order(word(names, k)) eq "nan" ? "" : ": order ".order(word(names, k)))
set style fill solid 0.15 noborder
plot for [k=1:4] errors using (of(word(names, k))):(seen("force_least")):(seen("force_largest")) with filledcurves linecolor rgb colour_of(word(names, k)) notitle, \
     for [k=1:4] errors using (of(word(names, k))):(seen("force_median")) with linespoints linecolor rgb colour_of(word(names, k)) pointtype 7 pointsize 0.6, \
     for [k=1:4] errors using (of(word(names, k)) == n_max ? n_max : NaN):(seen("force_median") * real(word(above, k))):(label(k)) with labels left offset 0.8,0 \
       textcolor rgb label_colour_of(word(names, k))
