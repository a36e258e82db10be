# Without rolling, points of the remembered scheme lie on the exact loops of force and displacement (left); their errors
# jump up and down as one element after another begins to slip (right). Loops show what slip adds to the displacement of
# a contact that sticks everywhere.
loops = tables."/loops.tsv"
of(way, amplitude) = strcol("way") eq way && same(column("amplitude"), amplitude) ? column("displacement") - column("adhesion") : NaN
error(amplitude) = same(column("amplitude"), amplitude) && strcol("way") ne "out" ? column("error") : NaN
amplitudes = system("awk -F'\t' '!/^#/ && $1 != \"amplitude\" && !seen[$1]++ { printf \"%s \", $1 }' \"".loops."\"")

eval page(860, 420)
set multiplot layout 1,2 margins 0.09,0.98,0.14,0.9 spacing 0.13
set xlabel "displacement that slip adds [mm]"
set ylabel "force / full sliding [1]"
set title "loops"
set yrange [-1:1.5]
set key top left samplen 1
plot for [i=1:words(amplitudes)] for [way in "out back forth"] loops using (of(way, real(word(amplitudes, i)))):"force" \
       with points linetype i pointtype 7 pointsize 0.3 notitle, \
     for [i=1:words(amplitudes)] NaN with points linetype i pointtype 7 pointsize 0.6 title sprintf("amplitude %.2g", real(word(amplitudes, i))), \
     for [i=1:words(amplitudes)] for [way in "out back forth"] loops using \
       (strcol("way") eq way && same(column("amplitude"), real(word(amplitudes, i))) ? column("exact") - column("adhesion") : NaN):"force" with @exact_line notitle, \
     NaN with @exact_line title "exact"
set xlabel "force / full sliding [1]"
set ylabel "error / displacement at the amplitude [1]"
set title "their errors"
set format y "%.0e"
set key top right
set yrange [*:8e-5]
plot for [i=1:words(amplitudes)] loops using "force":(error(real(word(amplitudes, i)))) \
       with lines linetype i title sprintf("amplitude %.2g", real(word(amplitudes, i)))
unset multiplot
