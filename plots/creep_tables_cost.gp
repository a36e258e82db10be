# Errors of creep forces against the time of an evaluation on one core, over all motions: a point is the root of the mean
# square, a circle bounds 99 %. A table is faster than FASTSIM, and has the errors of a direct solution. CONTACT's
# results are printed ones, without a time; USETAB's layout is measured at a/b = 1.
load scripts."/creep_tables.gpi"
times = tables."/cost_timing.tsv"
methods = methods_in(times)
measured(method, name) = last_value(times, sprintf("$1 == \"%s\"", method), name)
eval page(640, 440)
set logscale xy
set format x "10^{%T}"
set format y "10^{%T}"
set xlabel "time of an evaluation [s]"
set ylabel "error of a force, over full sliding [1]"
set xrange [8e-9:1]
set yrange [4e-4:3]
unset key
set label 1 name_of("contact").": 99 %" at 0.7,measured("contact", "of_99_percent") right offset 0,0.6 textcolor rgb label_colour_of("contact")
set label 2 "root of the mean square" at 0.7,measured("contact", "rms") right offset 0,0.6 textcolor rgb label_colour_of("contact")
do for [i=1:words(methods)] {
  m = word(methods, i)
  if (m ne "contact") {
    if (m eq "vermeulen_johnson" || m eq "polach") {
      set label 10+i name_of(m) at measured(m, "time"),measured(m, m eq "polach" ? "rms" : "of_99_percent") left \
          offset (m eq "polach" ? 1 : -2),(m eq "polach" ? 0 : 1) textcolor rgb label_colour(hue(m))
    } else { if (is_few(m)) {
      set label 10+i name_of(m) at measured(m, "time"),measured(m, dash_of(m) == 2 ? "of_99_percent" : "rms") left \
          offset 1,0 textcolor rgb label_colour(hue(m))
    } else {
      set label 10+i name_of(m) at measured(m, "time"),measured(m, m eq "fastsim_three" ? "rms" : "of_99_percent") \
          left offset 1,0 textcolor rgb label_colour(hue(m))
    } }
  }
}
plot for [m in methods] times using (of(m) * column("time")):"rms":"rms":"of_99_percent" with yerrorbars \
       linecolor rgb hue(m) pointtype 7 pointsize 0.7 linewidth 1.2, \
     for [m in methods] times using (of(m) * column("time")):"of_99_percent" with points \
       linecolor rgb hue(m) pointtype 6 pointsize 0.9, \
     measured("contact", "rms") with lines linecolor rgb hue("contact") dashtype 1, \
     measured("contact", "of_99_percent") with lines linecolor rgb hue("contact") dashtype 2
