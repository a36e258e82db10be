# How many of all motions, with and without spin, have a larger error of the force than a given one: one in a hundred at
# the lower third. The table is right to half a percent of full sliding for 99 of 100 motions, fast laws to a tenth and to a half.
load scripts."/creep_tables.gpi"
distribution = tables."/distribution.tsv"
methods = methods_in(distribution)
eval page(640, 460)
set logscale xy
set format x "10^{%T}"
set xlabel "error of the force, over full sliding [1]"
set ylabel "share of motions with a larger one"
set xrange [1e-5:1.5]
set yrange [1e-3:1.05]
set ytics ("1" 1, "1/10" 0.1, "1/100" 0.01, "1/1000" 0.001)
set key bottom left Left reverse at graph 0.02,0.03 maxrows 12
plot for [m in methods] distribution using (of(m) * column("error")):"share" with lines \
       linecolor rgb hue(m) linewidth 1.6 dashtype dash_of(m) title name_of(m)
