# Doubling N halves the error of the traction, and divides it by nearly 2.8 where the displacement at the edge is
# known, which is less than second order. Boxes are the interquartile range over all alignments and stick ratios,
# lines in them medians. The thesis gives one mean and one best factor for two schemes.
summary = tables."/summary.tsv"
eval page(640, 420)
set logscale y
set ylabel "factor per doubling of N [1]"
set yrange [0.9:12]
set ytics (1, 1.5, 2, 3, 4, 6, 8, 10)
set bmargin 4.6
set xrange [-0.6:6.1]
set xtics ("standard\nconstant" 0, "standard\nlinear" 1, "edge\nknown,\nconstant" 2, "edge\nknown,\nlinear" 3, "trimmed\nlinear" 4, "edge\nfunction" 5)
set boxwidth 0.45
set key top right
set arrow from -0.6, 2 to 6.1, 2 nohead linecolor "gray60" dashtype 2
set arrow from -0.6, 4 to 6.1, 4 nohead linecolor "gray60" dashtype 2
set label "second order" at 6.1, 4 offset 0,0.6 right textcolor "gray40"
set label "first order" at 6.1, 2 offset 0,-0.6 right textcolor "gray40"
set arrow from -0.6, 2**1.5 to 6.1, 2**1.5 nohead linecolor "gray60" dashtype 2
set label "order 3/2" at 6.1, 2**1.5 offset 0,0.6 right textcolor "gray40"
set title "Reduction of the traction error (1-norm), N = 15 to 240"
$thesis << EOD
0.5	1.83	2.09
2.5	2.89	4.96
EOD
plot summary using 0:"lower_quartile":"lower_quartile":"upper_quartile":"upper_quartile" with candlesticks linetype 1 fillstyle solid 0.3 title "interquartile range", \
     summary using 0:"median":"median":"median":"median" with candlesticks linetype 1 linewidth 2 notitle, \
     $thesis using 1:2 with points pointtype 7 pointsize 0.7 linetype 2 title "thesis: mean", \
     $thesis using 1:3 with points pointtype 9 pointsize 0.7 linetype 2 title "thesis: best"
