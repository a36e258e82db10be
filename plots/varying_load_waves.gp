# The shorter a wave of the normal load, the less the force swings, and the lower is its mean (right); Carter's solution
# of each moment and springs (FASTSIM) swing too much (left). The wave is large: half of the mean load.
waves = tables."/waves.tsv"
means = tables."/means.tsv"
lengths = "2 10 50"
of(k) = same(column("wavelength_ratio"), word(lengths, k) + 0) ? column("part") : NaN
eval page(960, 430)
set multiplot layout 1,2 margins 0.085,0.98,0.14,0.93 spacing 0.09
set xlabel "part of the wave that has been rolled [1]"
set ylabel "-F / μP_0 [1]"
set xrange [0:1]
set yrange [0.3:1.05]
set key top right
plot waves using (of(3)):(-column("quasi_steady")) with lines linecolor "gray40" dashtype 3 title "Carter of each moment", \
     for [k=1:3] waves using (of(k)):(-column("force")) with lines linetype k title "L = ".word(lengths, k)." a", \
     for [k=1:3] waves using (of(k)):(-column("springs")) with lines linetype k dashtype 2 notitle, \
     keyentry with lines linecolor "gray40" dashtype 2 title "springs (FASTSIM)"
set logscale x
set format x "10^{%T}"
set xlabel "wavelength over the half-width, L/a [1]"
set ylabel "over Carter of each moment [1]"
set xrange [0.4:125]
set yrange [0:1.2]
set key bottom right
plot means using "wavelength_ratio":"force" with linespoints linetype 1 pointtype 7 pointsize 0.5 title "mean force, energy lost", \
     means using "wavelength_ratio":"springs" with linespoints linetype 1 dashtype 2 pointtype 6 pointsize 0.6 title "the same by springs", \
     means using "wavelength_ratio":"swing" with linespoints linetype 2 pointtype 7 pointsize 0.5 title "swing of the force"
unset multiplot
