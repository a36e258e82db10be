# Forces, moment and motions of an ellipse, or of another contact in three dimensions, as it rolls on. What is across the
# rolling is dashed. For one or more results.
load scripts."/microslip.gpi"
history = tables."/history.tsv"
# One result has a colour for each direction; several have colours of their own, and grey lines say what dashes mean.
alone = lines == 1
entries = alone ? 2 : lines + 2
entry_label(i) = i == entries - 1 ? "along the rolling, x" : i == entries ? "across it, y" : label(i)
entry_colour(i) = i > entries - 2 ? (alone ? word(line_colours, i) : "#666666") : color(i)
entry_dash(i) = i == entries ? 2 : 1
entry_width(i) = 1.4
colour_along(k) = alone ? word(line_colours, 1) : color(k)
colour_across(k) = alone ? word(line_colours, 2) : color(k)
# An axis from 0 on, or about it, with room beside the lines; without a number other than 0 where there is nothing else.
extent_of(quantity) = quantity eq "none" ? "0 0" : extent_within(history, "over", history_range, quantity)
smaller(a, b) = a < b ? a : b
axis_of(one, other, nothing) = sprintf("ends = extent_of(\"%s\").\" \".extent_of(\"%s\"); \
least = smaller(0, smaller(real(word(ends, 1)), real(word(ends, 3)))); \
most = -smaller(0, smaller(-real(word(ends, 2)), -real(word(ends, 4)))); \
if (least == 0 && most == 0) { set yrange [-1:1]; set ytics (\"       0\" 0); set label 1 \"%s\" at graph 0.5, graph 0.62 center } else { \
set yrange [least - 0.05 * (most - least):most + 0.05 * (most - least)] }", one, other, nothing)
eval key_height
panel = 145
height = top + 4 * panel + 3 * 18 + 62
eval page(640, height)
panel_top(i) = top + i * (panel + 18)
do for [pass=1:2] {
  eval begin_pass
  set autoscale xfix
  eval "set xrange ".history_range
  set format x ""
  do for [i=0:3] {
    eval ordinary_axis
    along = word("force spin_moment creepage spin", i + 1)
    across = word("lateral_force none lateral_creepage none", i + 1)
    eval area(panel_top(i), panel_top(i) + panel)
    if (i == 0) { set ylabel "force F [N]"; eval draw_key }
    if (i == 1) { eval without_key; set ylabel "moment M_z [N mm]" }
    if (i == 2) { set ylabel "creepage ξ, η" }
    if (i == 3) { set ylabel "spin φ [1/mm]"; set format x "%g"; set xlabel said(history, "over") }
    eval axis_of(along, across, "no ".word("force moment creepage spin", i + 1))
    if (across eq "none") {
      plot for [k=1:lines] history using (of(k, column("over"))):along with lines linecolor rgb colour_along(k) linewidth 1.4
    } else {
      plot for [k=1:lines] history using (of(k, column("over"))):along with lines linecolor rgb colour_along(k) linewidth 1.4, \
           for [k=1:lines] history using (of(k, column("over"))):across with lines linecolor rgb colour_across(k) dashtype 2 linewidth 1.4
    }
    eval end_panel
  }
  unset multiplot
}
