# Force and creepage change as the contact rolls on (below); the tractions at the end stay within their bounds (above).
# A transient, for one or more results.
load scripts."/microslip.gpi"
traction = tables."/traction.tsv"
history = tables."/history.tsv"
eval add_bound
eval key_height
height = 695 + top
eval page(640, height)
do for [pass=1:2] {
  eval begin_pass
  eval area(top, top + 250)
  eval "set xrange ".x_range
  set xlabel x_label
  set ylabel "traction p at the end [N/mm^2]"
  eval draw_key
  eval drawn_tractions
  eval end_panel
  eval without_key
  set autoscale xfix
  eval "set xrange ".history_range
  set yrange [*<0:0<*]
  set xlabel ""
  set format x ""
  eval area(top + 320, top + 465)
  set ylabel "force F [N/mm]"
  eval flat_axis(history, "over", history_range, "force", "no force")
  plot for [k=1:lines] history using (of(k, column("over"))):"force" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
  eval end_panel
  eval ordinary_axis
  set yrange [*<0:0<*]
  set format x "%g"
  set xlabel said(history, "over")
  set ylabel "creepage w"
  eval flat_axis(history, "over", history_range, "creepage", "no creepage")
  eval area(top + 483, top + 628)
  plot for [k=1:lines] history using (of(k, column("over"))):"creepage" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
  eval end_panel
  unset multiplot
}
