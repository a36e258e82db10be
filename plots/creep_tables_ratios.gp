# Errors of the force over a/b, a along the rolling, roots of mean squares: lines are of CONTACT's cases, and circles of random
# motions of a random a/b. Fast laws are worst on long ellipses, where spin counts most.
load scripts."/creep_tables.gpi"
ratios = tables."/ratios.tsv"
methods = methods_in(ratios)
eval page(640, 460)
set logscale xy
set format y "10^{%T}"
set xlabel "a/b [1]"
set ytics 1e-4,10,1
set ylabel "error of the force, over full sliding [1]"
set xrange [0.09:11]
set yrange [1e-4:200]
set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10)
set key top left Left reverse maxrows 5 at graph 0.01,0.99 samplen 1.5
of_set(m, set) = of(m) * (strcol("set") eq set ? column("ratio") : NaN)
plot for [m in methods] ratios using (of_set(m, "contact")):"force" with linespoints \
       linecolor rgb hue(m) pointtype (m eq "usetab" ? 2 : 7) pointsize 0.5 dashtype dash_of(m) title name_of(m), \
     for [m in methods] ratios using (of_set(m, "random")):"force" with points \
       linecolor rgb hue(m) pointtype (dash_of(m) == 2 ? 4 : 6) pointsize 0.6 notitle
