# A cylinder that rolls down a slope gains velocity while the force of its contact swings and settles. From above:
# tractions at the end, velocity, force, and what the balance of energy misses with tractions at the end of each step.
load scripts."/microslip.gpi"
traction = tables."/traction.tsv"
history = tables."/history.tsv"
eval add_bound
eval key_height
height = 870 + top
eval page(640, height)
do for [pass=1:2] {
  eval begin_pass
  eval area(top, top + 160)
  eval "set xrange ".x_range
  set xlabel "x [mm], rolling to the right"
  set ylabel "traction p [N/mm^2]"
  eval draw_key
  eval drawn_tractions
  eval end_panel
  eval without_key
  set autoscale xfix
  eval "set xrange ".history_range
  set xlabel ""
  set format x ""
  set ylabel "velocity v [mm/s]"
  eval area(top + 230, top + 410)
  eval flat_axis(history, "over", history_range, "v", "at rest")
  plot for [k=1:lines] history using (of(k, column("over"))):"v" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
  eval end_panel
  eval ordinary_axis
  set ylabel "force F [N/mm]"
  eval area(top + 428, top + 608)
  eval flat_axis(history, "over", history_range, "force", "no force")
  plot for [k=1:lines] history using (of(k, column("over"))):"force" with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
  eval end_panel
  eval ordinary_axis
  set ylabel "energy missing, of F_{cm} X"
  set logscale y
  set format y "10^{%L}"
  set format x "%g"
  set xlabel said(history, "over")
  eval area(top + 626, top + 803)
  plot for [k=1:lines] history using (column("X") > 0 ? of(k, column("over")) : NaN):(shown(abs(column("total") / column("potential")))) with lines linecolor rgb color(k) dashtype dash(k) linewidth width(k)
  eval end_panel
  unset multiplot
}
