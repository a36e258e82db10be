# As c falls, the diagonal of B = A - A' vanishes faster than the entries next to it (thesis Figs. 6.3 and 6.6). Drawn
# lines are linear functions, dashed ones constant functions.
diagonals = tables."/diagonals.tsv"
of(name) = strcol("basis") eq name ? column("step_ratio") : NaN
crossing = 0.0
set table $crossing
plot tables."/crossing.tsv" using (strcol("basis") eq "constant" && strcol("kernel") eq "scene" ? crossing = column("step_ratio") : 0) with table
unset table

eval page(800, 380)
set multiplot layout 1,2 margins 0.105,0.98,0.17,0.9 spacing 0.11
set xlabel "step ratio c = dq/dx"
set xrange [0:1]
set arrow from crossing, graph 0 to crossing, graph 1 nohead linecolor "gray60" dashtype 2
set label sprintf("B_{11} = B_{21} (constant)\nat c = %.6f", crossing) at crossing, graph 0.48 offset 1,0 textcolor "gray40"
set key top left
set title "entries of B = A - A'"
set ylabel "entry [2(1-ν)dx/G]"
names = "b11 b21 b12"
titles = "B_{11} B_{21} B_{12}"
plot for [i=1:3] diagonals using (of("linear")):(column(word(names, i))) with lines linetype i title word(titles, i), \
     for [i=1:3] diagonals using (of("constant")):(column(word(names, i))) with lines linetype i dashtype 2 notitle
set title "over the largest"
set ylabel "|entry| / largest [1]"
set logscale y
set format y "10^{%T}"
set key bottom right at graph 1, 0.1
plot for [i=1:3] diagonals using (of("linear")):(column(word(names, i)."_scaled")) with lines linetype i title word(titles, i), \
     for [i=1:3] diagonals using (of("constant")):(column(word(names, i)."_scaled")) with lines linetype i dashtype 2 notitle
unset multiplot
