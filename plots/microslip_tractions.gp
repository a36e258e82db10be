# Tractions stay within their bounds; where a line touches its bound, the contact slips. Results of different kinds,
# transients at their end.
load scripts."/microslip.gpi"
traction = tables."/traction.tsv"
eval add_bound
eval key_height
height = 350 + top
eval page(640, height)
do for [pass=1:2] {
  eval begin_pass
  eval area(top, height - 62)
  eval "set xrange ".x_range
  set xlabel x_label
  set ylabel "traction p [N/mm^2]"
  eval draw_key
  eval drawn_tractions
  eval end_panel
  unset multiplot
}
