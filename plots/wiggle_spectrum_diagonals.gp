# Thesis Fig. 6.3: the entries of A - A' on and next to the diagonal against the step ratio.
diagonals = tables."/diagonals.tsv"
crossing = 0.0
set table $crossing
plot tables."/crossing.tsv" using (strcol("kernel") eq "scene" ? crossing = column("step_ratio") : 0) with table
unset table

set terminal svg size 800,380
set multiplot layout 1,2 margins 0.09,0.98,0.17,0.9 spacing 0.11
set xlabel "step ratio c = dq/dx"
set xrange [0:1]
set arrow from crossing, graph 0 to crossing, graph 1 nohead linecolor "gray60" dashtype 2
set label sprintf("M_{11} = M_{21}\nat c = %.6f", crossing) at crossing, graph 0.48 offset 1,0 textcolor "gray40"
set key top left
set title "entries of M = A - A'"
set ylabel "entry [2(1-ν)dx/G]"
plot diagonals using "step_ratio":"m11" with lines title "M_{11}", \
     diagonals using "step_ratio":"m21" with lines title "M_{21}", \
     diagonals using "step_ratio":"m12" with lines title "M_{12}"
set title "their size, relative to the largest"
set ylabel "|entry| / largest [1]"
set logscale y
set format y "10^{%T}"
set key bottom right at graph 1, 0.1
plot diagonals using "step_ratio":"m11_scaled" with lines title "M_{11}", \
     diagonals using "step_ratio":"m21_scaled" with lines title "M_{21}", \
     diagonals using "step_ratio":"m12_scaled" with lines title "M_{12}"
unset multiplot
