# Errors of creep forces against the time of an evaluation on one core, over all motions: a point is the root of the mean
# square, a circle bounds 99 %. A table is faster than FASTSIM, and has the errors of a direct solution. CONTACT's
# results are printed ones, without a time (lines); USETAB's layout is measured at a/b = 1.
load scripts."/creep_tables.gpi"
times = tables."/cost_timing.tsv"
methods = methods_in(times)
measured(method, name) = last_value(times, sprintf("$1 == \"%s\"", method), name)
point_of(method) = is_few(method) && dash_of(method) == 2 ? 5 : 7
eval page(640, 480)
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "time of an evaluation [s]"
set ylabel "error of a force, over full sliding [1]"
set xrange [8e-9:0.1]
set yrange [1e-4:300]
set ytics 1e-3,10,1
set key top left Left reverse maxrows 5 at graph 0.01,0.99 samplen 1.5
plot for [m in methods] times using (of(m) * column("time")):"rms":"rms":"of_99_percent" with yerrorbars \
       linecolor rgb hue(m) pointtype point_of(m) pointsize 0.7 linewidth 1.2 title m eq "contact" ? "" : name_of(m), \
     for [m in methods] times using (of(m) * column("time")):"of_99_percent" with points \
       linecolor rgb hue(m) pointtype (point_of(m) - 1) pointsize 0.9 notitle, \
     measured("contact", "rms") with lines linecolor rgb hue("contact") title name_of("contact"), \
     measured("contact", "of_99_percent") with lines linecolor rgb hue("contact") dashtype 2 notitle
