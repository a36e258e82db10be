# Fractional steps make a shape with jumps ring, and leave a smooth one as it is: the largest undershoot stands above each
# shape. Grey is where the start should have gone. Thesis Figs. 8.1 and 8.2.
shapes = tables."/shapes.tsv"
summary = tables."/shapes_summary.tsv"
steps = by_awk(summary, "$1 == \"pulse\" && $2 > 0 { print $2 }'")
c = real(by_awk(summary, "$1 == \"pulse\" && $2 > 0 { print $3 / $2; exit }'"))
of(shape, n) = strcol("shape") eq shape && column("steps") == real(n) ? column("position") : NaN
undershoot(shape, n) = last_value(summary, sprintf("$1 == \"%s\" && $2 == %s", shape, n), "below")

eval page(900, 600)
set multiplot layout 2,3 margins 0.085,0.985,0.095,0.91 spacing 0.08,0.15
set xrange [-150:0]
set yrange [-1.2:1.6]
set xtics 50
unset key
names = "pulse plateau ramp_up pulse ramp_down pyramid"
titles = "'one node' plateau 'ramp up' 'one node' 'ramp down' pyramid"
do for [k=1:6] {
  shape = word(names, k)
  n = word(steps, k == 4 ? 3 : 2)
  set title sprintf("%s, %s steps\n{/:Bold undershoot %.2g}", word(titles, k), n, undershoot(shape, n))
  set ylabel k % 3 == 1 ? "traction [1]" : ""
  set xlabel k > 3 ? "from the leading edge [dx]" : ""
  plot shapes using (column("steps") == 0 ? of(shape, "0") - c * n : NaN):"traction" with lines linecolor "gray70" linewidth 4, \
       shapes using (of(shape, n)):"traction" with lines linecolor rgb colour_of("fractional") linewidth 0.8
}
unset multiplot
