# Thesis Figs. 6.1 and 6.2: the matrix M = A - A' and its inverse for the first two step ratios.
matrix = tables."/matrix.tsv"
stats matrix using "row" nooutput
n = int(STATS_max)
stats matrix using "step_ratio" every ::0::0 nooutput
first = STATS_max
stats matrix using "step_ratio" every ::(n*n)::(n*n) nooutput
second = STATS_max

set terminal svg size 640,600
set multiplot layout 2,2 margins 0.09,0.9,0.1,0.94 spacing 0.19,0.14
set palette defined (-1 "#0072b2", 0 "white", 1 "#d55e00")
set size ratio -1
set border 15
unset grid
unset key
set tics in front
set xlabel "column"
set ylabel "row"
set format cb "%g"
do for [k=0:1] {
  do for [name in "difference inverse"] {
    c = k == 0 ? first : second
    set title sprintf(name eq "inverse" ? "(A - A')^{-1} [G/2(1-ν)dx], c = %g" : "A - A' [2(1-ν)dx/G], c = %g", c)
    set xrange [*:*]
    set yrange [*:*]
    stats matrix using name every ::(k*n*n)::(k*n*n + n*n - 1) nooutput
    largest = STATS_max > -STATS_min ? STATS_max : -STATS_min
    set cbrange [-largest:largest]
    set xrange [0.5:n+0.5]
    set yrange [n+0.5:0.5]
    plot matrix using "column":"row":name every ::(k*n*n)::(k*n*n + n*n - 1) with image pixels
  }
}
unset multiplot
