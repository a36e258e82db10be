# Each shift without rolling leads to the next point: the force at its end, over the rigid shift so far. Between two
# points the way is no straight line; more values of start.force show it.
shifts = tables."/shifts.tsv"
eval page(640, 420)
set xlabel "rigid shift [mm]"
set ylabel "force F [N/mm]"
set xzeroaxis linecolor "gray60"
set yzeroaxis linecolor "gray60"
set key off
set xtics format "%g"
eval "set xrange ".x_range
plot shifts using "total_shift":"force" with linespoints linetype 1 pointtype 7 pointsize 0.6
