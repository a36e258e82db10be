# The error of the force is least near c = 0.6, and grows on both sides. The thesis says in its introduction: "for c <
# 0.55 the accuracy decreases".
accuracy = tables."/accuracy.tsv"
eval page(640, 380)
set xlabel "step ratio c = dq/dx"
set ylabel "relative error of the force [1]"
set yrange [0:*]
set arrow from 0.55, graph 0 to 0.55, graph 1 nohead linecolor "gray60" dashtype 2
set label "c = 0.55" at 0.55, graph 0.94 offset 1,0 textcolor "gray40"
unset key
set title "Carter-Fromm problem: the force is best near c = 0.6"
plot accuracy using "step_ratio":"relative_force_error" with linespoints linetype 1 pointtype 7 pointsize 0.4
