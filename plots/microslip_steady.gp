# The contact slips where the traction reaches its bound, and sticks elsewhere. Steady rolling: tractions above, slip
# below, for one or more results, and with Carter's exact solution where it holds.
load scripts."/microslip.gpi"
traction = tables."/traction.tsv"
eval add_bound
eval key_height
height = 497 + top
eval page(640, height)
do for [pass=1:2] {
  eval begin_pass
  eval area(top, top + 208)
  eval "set xrange ".x_range
  set format x ""
  set ylabel "traction p [N/mm^2]"
  eval draw_key
  eval drawn_tractions
  eval end_panel
  eval area(top + 226, top + 433)
  set format x
  set xlabel x_label
  set ylabel "relative slip s"
  eval without_key
  eval flat_axis(traction, "x", x_range, "slip", "no slip: all sticks")
  plot for [k=1:lines] traction using (of(k, column("x"))):"slip" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
  eval end_panel
  unset multiplot
}
