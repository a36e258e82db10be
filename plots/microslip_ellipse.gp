# An ellipse sticks where it is blue, the darker the nearer its tractions are to their bound, and slips where it is orange.
# Arrows are tractions. Below: both components along the middle row and along a row halfway to the side. The contact rolls
# to the right.
load scripts."/microslip_margins.gpi"
traction = tables."/traction.tsv"
summary = tables."/summary.tsv"
quantity(name) = real(by_awk(summary, sprintf("$at[\"quantity\"] == \"%s\" { print $at[\"value\"] }'", name)))
rows = int(quantity("rows"))
elements = int(quantity("elements"))
cells = rows * elements
a = quantity("half_width")
b = quantity("lateral_half_width")
psi(k) = pi * (1. * k / rows - 0.5)
theta(i) = pi * i / elements
# The colour of a cell, its tractions over their bound; what slips is beyond 1.
array part[cells]
array py[cells]
peak = 0
stats traction using (i = int($0) + 1, py[i] = abs(column("y")) < 1e-9 * b ? 0 : column("y"), r = sqrt(column("traction_x")**2 + column("traction_y")**2), \
  g = column("bound"), peak = g > peak ? g : peak, part[i] = strcol("zone") eq "S" ? 1.2 : r / g, 0) nooutput
# The sides of cells, each with the colour of the cell that begins there.
set print $sides
strips = rows < 30 ? 4 : 1  # parts of a row, for the edge of the ellipse
do for [k=0:rows * strips] {
  do for [i=0:elements] {
    print sprintf("%.9g\t%.9g\t%.9g", a * cos(psi(1. * k / strips)) * cos(theta(i)), b * sin(psi(1. * k / strips)), \
                  k < rows * strips && i < elements ? part[(k / strips) * elements + i + 1] : 0)
  }
  print ""
}
unset print
# Arrows: at most some 300, the longest as long as a third of the distance between rows of a coarse grid.
every = int(ceil(sqrt(cells / 300.)))
longest = 0.16 * sqrt(a * b)
is_drawn(n) = (int(n) % elements) % every == every / 2 && int(n / elements) % every == every / 2
# Half the map, which has room for numbers beside a narrow ellipse, too.
wide = 1.15 * (a > 0.5 * b ? a : 0.5 * b)
high = 1.15 * (b > 0.3 * a ? b : 0.3 * a)
map_height = 260. / wide < 200. / high ? 520. / wide * high : 400.
top = 44.
middle_row = rows / 2
side_row = int(rows * (0.5 + asin(0.5) / pi))
last_row = side_row > middle_row ? side_row : side_row - 1
# The key of the lower panel: along the middle row, the bound and both components, and along another row the components.
entries = last_row < side_row ? 3 : 5
entry_label(i) = i == 5 ? "bound ±g" : sprintf("p_%s, y = %.3g mm", i % 2 ? "x" : "y", py[(i < 3 ? middle_row : side_row) * elements + 1])
entry_colour(i) = i == 5 ? "#999999" : word(line_colours, 2 - i % 2)
entry_dash(i) = i < 3 ? 1 : 2
entry_width(i) = 1.4
if (entries == 3) { entry_label(i) = i == 3 ? "bound ±g" : sprintf("p_%s, y = %.3g mm", i % 2 ? "x" : "y", py[middle_row * elements + 1]) }
key_columns = 2
key_top = top + map_height + 78
height = top + map_height + 404
eval page(640, height)
do for [pass=1:2] {
  eval begin_pass
  eval area(top, top + map_height)
  set size ratio -1
  set xrange [-wide:wide]
  set yrange [-high:high]
  set label 3 "x [mm], rolling to the right" at screen 0.55, screen 1 - (top + map_height + 56) / height center
  set ylabel "y [mm]" offset -1.2, 0
  set xtics scale 0
  set ytics scale 0
  set label 1 "sticks, |p|/g" at screen 0.12, screen 1 - 9. / height left
  set label 2 "slips" at screen 0.60, screen 1 - 9. / height left
  set palette defined (0 "#ffffff", 0.8333 "#3b82b8", 0.8334 "#e69f00", 1 "#e69f00")
  set cbrange [0:1.2]
  set colorbox user horizontal origin screen 0.30, screen 1 - 14. / height size screen 0.28, screen 10. / height
  set cbtics ("0" 0, "0.5" 0.5, "1" 1) offset 0, 0.4 scale 0
  set view map
  set pm3d corners2color c1
  splot $sides using 1:2:(0):3 with pm3d, \
        traction using "x":"y":(0):(is_drawn($0) ? longest * column("traction_x") / peak : NaN):(longest * column("traction_y") / peak):(0) \
        with vectors head filled size screen 0.008, 20 linecolor rgb "black" linewidth 1
  unset label
  unset colorbox
  set xtics scale 0.6 autofreq
  set ytics scale 0.6 autofreq
  set xlabel "x [mm], rolling to the right"
  set size noratio
  eval area(top + map_height + 154, height - 55)
  set autoscale
  set xrange [-1.05 * a:1.05 * a]
  set ylabel "traction [N/mm^2]" offset 0, 0
  of_row(k, value) = int($0) / elements == k ? value : NaN
  eval draw_key
  plot traction using (of_row(middle_row, column("x"))):"bound" with @bound_line, \
       traction using (of_row(middle_row, column("x"))):(-column("bound")) with @bound_line, \
       traction using (of_row(middle_row, column("x"))):"traction_x" with linespoints linetype 1 pointtype 7 pointsize 0.3, \
       traction using (of_row(middle_row, column("x"))):"traction_y" with linespoints linetype 2 pointtype 7 pointsize 0.3, \
       for [k=side_row:last_row] traction using (of_row(k, column("x"))):"traction_x" with lines linetype 1 dashtype 2, \
       for [k=side_row:last_row] traction using (of_row(k, column("x"))):"traction_y" with lines linetype 2 dashtype 2
  eval end_panel
  unset multiplot
}
