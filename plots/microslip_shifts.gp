# Each shift without rolling leads to the next point: the force at its end, over the rigid shift so far. Between two
# points the way is no straight line; more values of start.force show it.
load scripts."/microslip_margins.gpi"
shifts = tables."/shifts.tsv"
height = 420
eval page(640, height)
do for [pass=1:2] {
  eval begin_pass
  eval area(20, height - 62)
  set xlabel "rigid shift [mm]"
  set ylabel "force F [N/mm]"
  set xzeroaxis linecolor "gray60"
  set yzeroaxis linecolor "gray60"
  eval "set xrange ".x_range
  plot shifts using "total_shift":"force" with linespoints linetype 1 pointtype 7 pointsize 0.6
  eval end_panel
  unset multiplot
}
