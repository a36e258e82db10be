# The shorter a small wave of the normal load, the less and the later the force follows it than Carter's solution of
# each moment; springs (FASTSIM) follow too fast. Drawn lines are exact, points are by the remembered scheme.
curves = tables."/curves.tsv"
measured = tables."/measured.tsv"
stats measured using "elements" name "n" nooutput
states = "0.3 0.6 0.9"
of(name, k) = strcol("case") eq name && same(column("stick_ratio"), word(states, k) + 0) ? column("wavelength_ratio") : NaN
at(k) = same(column("stick_ratio"), word(states, k) + 0) && column("step_ratio") == 1 && column("elements") == n_max \
  ? column("wavelength_ratio") : NaN
angle(n) = column("phase") * 180 / pi
eval page(640, 620)
set multiplot layout 2,1 margins 0.13,0.97,0.1,0.97 spacing 0.04
set logscale x
set xrange [0.4:250]
set format x ""
set ylabel "|dF / μdP| [1]"
set yrange [0:1.15]
set key top left maxrows 3
plot for [k=1:3] curves using (of("exact", k)):"size" with lines linetype k title "a' = ".word(states, k)." a", \
     for [k=1:3] measured using (at(k)):"size" with points linetype k pointtype 7 pointsize 0.5 notitle, \
     for [k=1:3] curves using (of("quasi_steady", k)):"size" with lines linetype k dashtype 3 notitle, \
     for [k=1:3] curves using (of("springs", k)):"size" with lines linecolor rgb colour_of("springs") dashtype 2 linewidth 0.8 notitle, \
     keyentry with points linecolor "gray40" pointtype 7 pointsize 0.5 title "remembered, c = 1", \
     keyentry with lines linecolor "gray40" dashtype 3 title "Carter of each moment", \
     keyentry with lines linecolor rgb colour_of("springs") dashtype 2 title "springs (FASTSIM)"
set format x "10^{%T}"
set xlabel "wavelength of the normal load over the half-width, L/a [1]"
set ylabel "phase of the force [degrees]"
set autoscale y
unset key
plot for [k=1:3] curves using (of("exact", k)):(angle(0)) with lines linetype k, \
     for [k=1:3] measured using (at(k)):(angle(0)) with points linetype k pointtype 7 pointsize 0.5, \
     for [k=1:3] curves using (of("springs", k)):(angle(0)) with lines linecolor rgb colour_of("springs") dashtype 2 linewidth 0.8
unset multiplot
