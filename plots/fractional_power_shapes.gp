# Thesis Figs. 8.1 and 8.2: fractional steps of a single one, and of other shapes. Grey: where the start
# should have gone.
shapes = tables."/shapes.tsv"
c = 0.0
steps = ""
set table $steps
plot tables."/shapes_summary.tsv" using \
  (strcol("shape") eq "pulse" && column("steps") > 0 ? (steps = steps.sprintf(" %g", column("steps")), \
   c = column("distance") / column("steps")) : 0, 0) with table
unset table
middle = word(steps, 2)
of(shape, n) = strcol("shape") eq shape && column("steps") == real(n) ? column("position") : NaN

eval page(900, 640)
set multiplot layout 2,4 margins 0.085,0.985,0.09,0.94 spacing 0.055,0.13
set xrange [-150:0]
set xtics 50
unset key
panel(shape, n) = sprintf("%s, %s step%s", shape eq "pulse" ? "a single one" : shape eq "ramp_up" ? "ramp up" : \
  shape eq "ramp_down" ? "ramp down" : shape, n, n eq "1" ? "" : "s")
do for [i=1:words(steps)] {
  n = word(steps, i)
  set title panel("pulse", n)
  set ylabel i == 1 ? "traction [1]" : ""
  plot shapes using (column("steps") == 0 ? of("pulse", "0") - c * n : NaN):"traction" with lines linecolor "gray60", \
       shapes using (of("pulse", n)):"traction" with lines linetype 1
}
set multiplot next
set yrange [-0.7:1.35]
do for [shape in "plateau ramp_up ramp_down pyramid"] {
  set title panel(shape, middle)
  set xlabel shape eq "ramp_up" ? "distance from the leading edge [dx], rolling to the right" : ""
  set ylabel shape eq "plateau" ? "traction [1]" : ""
  plot shapes using (column("steps") == 0 ? of(shape, "0") - c * middle : NaN):"traction" with lines linecolor "gray60", \
       shapes using (of(shape, middle)):"traction" with lines linetype 1
}
unset multiplot
