# Error of the force in steady rolling against N, median and spread over all parts of adhesion and
# alignments of the grid.
errors = tables."/errors.tsv"
orders = tables."/orders.tsv"
names = "standard known_edge calibrated inversion"
titles = "'thesis and CONTACT' 'thesis, displacement at the edge known' 'calibrated edges' inversion"
of(scheme) = strcol("scheme") eq scheme ? column("elements") : NaN
least = 1e-17
seen(name) = column(name) > least ? column(name) : least  # a logarithm has no zero
order_of = ""
set table $orders
plot orders using (order_of = order_of.sprintf(" %s %.2f", strcol("scheme"), column("force_order")), 0) with table
unset table
order(scheme) = word(order_of, 1 + int(sum [i=1:words(order_of)] (word(order_of, i) eq scheme ? i : 0)))

eval page(720, 460)
set logscale xy
set format y "10^{%T}"
set xtics (15, 30, 60, 120, 240, 480)
set xrange [13:560]
set xlabel "elements N [1]"
set ylabel "relative error of the force [1]"
set yrange [least:1]
set key at graph 0.62, 0.52 invert
set style fill solid 0.15 noborder
slope(n, order, from) = from * (15 / n)**order
plot for [k=1:4] errors using (of(word(names, k))):(seen("force_least")):(seen("force_largest")) with filledcurves linetype k notitle, \
     for [k=1:4] errors using (of(word(names, k))):(seen("force_median")) with linespoints linetype k pointtype 7 pointsize 0.6 \
       title word(titles, k).(order(word(names, k)) eq "nan" ? "" : ", order ".order(word(names, k))), \
     slope(x, 1, 0.1) with lines linecolor "gray50" dashtype 3 title "orders 1 and 2", \
     slope(x, 2, 2e-5) with lines linecolor "gray50" dashtype 3 notitle
