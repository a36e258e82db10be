# A single step from steady rolling, against its length. Above the length of linear theory there is one solution. Below, there are
# two: the bodies stick, or they jump by the same slip in any step, however short, so that the speed of slip has no limit.
steps = tables."/steps.tsv"
limits = tables."/limits.tsv"
of(branch) = strcol("branch") eq branch ? column("length") : NaN
limit = real(by_awk(limits, "$at[\"memory\"] == 0 { print $at[\"limit\"] }'"))

eval page(800, 400)
set multiplot layout 1,2 margins 0.105,0.98,0.17,0.9 spacing 0.115,0.1
set datafile missing NaN
set logscale x
set xlabel "length of the step, dq [mm]"
set xrange [0.008:2.5]
set arrow 1 from limit, graph 0.17 to limit, graph 1 nohead linecolor "gray50"
set title "force over full sliding at rest [1]"
set key bottom right
set yrange [0.54:0.61]
plot steps using (of("least")):"force_ratio" with linespoints linetype 1 title "from bodies that stick", \
     steps using (of("most")):"force_ratio" with linespoints linetype 2 title "from bodies that slide"
set logscale y
set title "largest speed of slip [mm/s]"
set yrange [3:2e4]
plot steps using (of("least")):"fastest" with linespoints linetype 1 notitle, \
     steps using (of("most")):"fastest" with linespoints linetype 2 notitle
unset multiplot
