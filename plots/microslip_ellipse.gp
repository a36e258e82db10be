# A contact sticks where it is blue, the darker the nearer its tractions are to their bound, and slips where it is orange.
# Arrows are tractions, and the grey line is the edge of the contact. Below: both components along the middle row and along a row halfway to the side; of several lobes
# along the middle rows of the first two. The name of the axis says where it rolls.
load scripts."/microslip_margins.gpi"
outline = "linecolor rgb '#777777' linewidth 1"
traction = tables."/traction.tsv"
edges = tables."/edges.tsv"
summary = tables."/summary.tsv"
quantity(name) = real(by_awk(summary, sprintf("$at[\"quantity\"] == \"%s\" { print $at[\"value\"] }'", name)))
rows = int(quantity("rows"))
elements = int(quantity("elements"))
cells = rows * elements
# Equal rectangles of the scheme direct, which are fewer than those around the contact.
is_direct = by_awk(summary, "$at[\"quantity\"] == \"method\" { print $at[\"value\"] }'") eq "direct"
dx = 2 * quantity("half_width") / elements
dy = 2 * quantity("lateral_half_width") / rows
least = 1e-9 * quantity("lateral_half_width")
# The colour of a cell, its tractions over their bound; what slips is beyond 1.
array part[cells]
array py[cells]
peak = 0
stats traction using (i = int($0) + 1, py[i] = abs(column("y")) < least ? 0 : column("y"), r = sqrt(column("traction_x")**2 + column("traction_y")**2), \
  g = column("bound"), peak = g > peak ? g : peak, part[i] = strcol("zone") eq "S" ? 1.2 : r / g, 0) nooutput
# The places of rows of rectangles.
array y_of_rectangles[rows]
last_y = -1e300
row_count = 0
if (is_direct) {
  stats traction using (y = column("y"), y > last_y ? (row_count = row_count + 1, y_of_rectangles[row_count] = abs(y) < least ? 0 : y, last_y = y) : 0, 0) nooutput
}
y_of(k) = is_direct ? y_of_rectangles[k + 1] : py[k * elements + 1]
# The edges at the sides of rows, and at some places between them.
stats edges using (column("y")) nooutput
sides_of_rows = int(STATS_records)
array lobe[sides_of_rows + 1]
array row[sides_of_rows]
array y_side[sides_of_rows]
array trailing[sides_of_rows]
array leading[sides_of_rows]
stats edges using (i = int($0) + 1, lobe[i] = int(column("lobe")), row[i] = int(column("row")), y_side[i] = column("y"), trailing[i] = column("trailing"), \
  leading[i] = column("leading"), 0) nooutput
lobe[sides_of_rows + 1] = 0
lobes = lobe[sides_of_rows]
array last_of_lobe[lobes]
do for [i=1:sides_of_rows] { last_of_lobe[lobe[i]] = row[i] }
left_end = trailing[1]; right_end = leading[1]; low_end = y_side[1]; high_end = y_side[1]
do for [i=1:sides_of_rows] {
  left_end = trailing[i] < left_end ? trailing[i] : left_end
  right_end = leading[i] > right_end ? leading[i] : right_end
  low_end = y_side[i] < low_end ? y_side[i] : low_end
  high_end = y_side[i] > high_end ? y_side[i] : high_end
}
a = (right_end - left_end) / 2
b = (high_end - low_end) / 2
x_middle = (left_end + right_end) / 2
y_middle = (low_end + high_end) / 2
# The sides of cells, each with the colour of the cell that begins there.
set print $sides
do for [i=1:is_direct ? 0 : sides_of_rows] {
  do for [j=0:elements] {
    is_inside = lobe[i + 1] == lobe[i] && j < elements
    print sprintf("%.9g\t%.9g\t%.9g", (trailing[i] + leading[i]) / 2 + (leading[i] - trailing[i]) / 2 * cos(pi * j / elements), y_side[i], \
                  is_inside ? part[(row[i] - 1) * elements + j + 1] : 0)
  }
  print ""
  if (lobe[i + 1] != lobe[i]) { print "" }
}
unset print
# Arrows: at most some 300, the longest as long as a third of the distance between rows of a coarse grid.
every = int(ceil(sqrt(cells / 300.)))
longest = 0.16 * sqrt(a * b / lobes)
column_of(n) = is_direct ? int((column("x") - left_end) / dx) : int(n) % elements
row_of(n) = is_direct ? int((column("y") - low_end) / dy) : int(n / elements)
is_drawn(n) = column_of(n) % every == every / 2 && row_of(n) % every == every / 2
# Half the map, which has room for numbers beside a narrow contact, too.
wide = 1.15 * (a > 0.5 * b ? a : 0.5 * b)
high = 1.15 * (b > 0.3 * a ? b : 0.3 * a)
map_height = 260. / wide < 200. / high ? 520. / wide * high : 400.
top = 44.
middle_row = last_of_lobe[1] / 2
side_row = lobes > 1 ? (last_of_lobe[1] + last_of_lobe[2]) / 2 : int(rows * (0.5 + asin(0.5) / pi))
if (is_direct) { middle_row = row_count / 2; side_row = int(0.75 * row_count) }
last_row = side_row > middle_row ? side_row : side_row - 1
# The key of the lower panel: along the middle row, the bound and both components, and along another row the components.
entries = last_row < side_row ? 3 : 5
entry_label(i) = i == 5 ? "bound ±g" : sprintf("p_%s, y = %.3g mm", i % 2 ? "x" : "y", y_of(i < 3 ? middle_row : side_row))
entry_colour(i) = i == 5 ? "#999999" : word(line_colours, 2 - i % 2)
entry_dash(i) = i < 3 ? 1 : 2
entry_width(i) = 1.4
if (entries == 3) { entry_label(i) = i == 3 ? "bound ±g" : sprintf("p_%s, y = %.3g mm", i % 2 ? "x" : "y", y_of(middle_row)) }
key_columns = 2
key_top = top + map_height + 78
height = top + map_height + 404
eval page(640, height)
do for [pass=1:2] {
  eval begin_pass
  eval area(top, top + map_height)
  set size ratio -1
  set xrange [x_middle - wide:x_middle + wide]
  set yrange [y_middle - high:y_middle + high]
  set label 3 x_label at screen 0.55, screen 1 - (top + map_height + 56) / height center
  set ylabel "y [mm]" offset -1.2, 0
  set xtics scale 0
  set ytics scale 0
  set label 1 "sticks, |p|/g" at screen 0.12, screen 1 - 9. / height left
  set label 2 "slips" at screen 0.60, screen 1 - 9. / height left
  set label 4 "arrows: tractions" at screen 0.98, screen 1 - 9. / height right
  set palette defined (0 "#ffffff", 0.8333 "#3b82b8", 0.8334 "#e69f00", 1 "#e69f00")
  set cbrange [0:1.2]
  set colorbox user horizontal origin screen 0.30, screen 1 - 14. / height size screen 0.28, screen 10. / height
  set cbtics ("0" 0, "0.5" 0.5, "1" 1) offset 0, 0.4 scale 0
  set view map
  set pm3d corners2color c1
  of_lobe(l, side) = column("lobe") == l ? column(side) : NaN
  arrow_along(n) = is_drawn(n) ? longest * column("traction_x") / peak : NaN
  if (is_direct) {
    plot traction using "x":"y":(dx / 2):(dy / 2):(part[int($0) + 1]) with boxxyerror palette fillstyle solid noborder, \
         for [l=1:lobes] edges using (of_lobe(l, "trailing")):"y" with lines @outline, \
         for [l=1:lobes] edges using (of_lobe(l, "leading")):"y" with lines @outline, \
         traction using "x":"y":(arrow_along($0)):(longest * column("traction_y") / peak) \
         with vectors head filled size screen 0.008, 20 linecolor rgb "black" linewidth 1
  } else {
    set border 10  # left and below, in a map
    splot $sides using 1:2:(0):3 with pm3d, \
          for [l=1:lobes] edges using (of_lobe(l, "trailing")):"y":(0) with lines @outline, \
          for [l=1:lobes] edges using (of_lobe(l, "leading")):"y":(0) with lines @outline, \
          traction using "x":"y":(0):(arrow_along($0)):(longest * column("traction_y") / peak):(0) \
          with vectors head filled size screen 0.008, 20 linecolor rgb "black" linewidth 1
  }
  unset label
  unset colorbox
  set border 3
  set xtics scale 0.6 autofreq
  set ytics scale 0.6 autofreq
  set xlabel x_label
  set size noratio
  eval area(top + map_height + 154, height - 55)
  set autoscale
  lower = map_height < 400 ? wide : 1.05 * a  # below a map that fills the width, places stand below those of the map
  set xrange [x_middle - lower:x_middle + lower]
  set ylabel "traction [N/mm^2]" offset 0, 0
  of_row(k, value) = (is_direct ? abs(column("y") - y_of(k)) < least : int($0) / elements == k) ? value : NaN
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
