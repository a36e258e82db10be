# Without rolling the shift is of second order by remembered, and of order 3/2 by the grid of the contact, which has the
# larger errors of the dissipation, too. Root mean squares over the amplitudes, against Mindlin's solution for Hertz's
# bound, and against superposition for the polynomial one.
errors = tables."/errors.tsv"
of(bound, scheme) = strcol("bound") eq bound && strcol("scheme") eq scheme ? column("elements") : NaN
stats errors using "elements" name "n" nooutput

eval page(860, 400)
set multiplot layout 1,2 margins 0.1,0.98,0.15,0.9 spacing 0.12
set logscale xy
set format y "10^{%T}"
set xrange [0.8*n_min:1.25*n_max]
set xtics (36, 50, 72, 100, 144)
set xlabel "number of elements N [1]"
set key top right
do for [what in "dissipation shift"] {
  if (what eq "shift") { set yrange [1e-6:1e-2]; unset key } else { set yrange [1e-4:1] }
  set title what eq "shift" ? "shift" : "dissipation of a cycle"
  set ylabel "relative error [1]"
  stats errors using (strcol("bound") eq "hertz" && strcol("scheme") eq "direct" && column("elements") == n_min ? column(what) : NaN) name "d" nooutput
  stats errors using (strcol("bound") eq "hertz" && strcol("scheme") eq "remembered" && column("elements") == n_min ? column(what) : NaN) name "m" nooutput
  plot errors using (of("hertz", "direct")):what with linespoints linecolor rgb colour_of("direct") pointtype 7 pointsize 0.6 title "Hertz, grid of the contact", \
       errors using (of("polynomial", "direct")):what with linespoints linecolor rgb colour_of("direct") pointtype 6 dashtype 3 title "polynomial, grid of the contact", \
       errors using (of("hertz", "remembered")):what with linespoints linecolor rgb colour_of("remembered") pointtype 7 pointsize 0.6 title "Hertz, remembered", \
       errors using (of("polynomial", "remembered")):what with linespoints linecolor rgb colour_of("remembered") pointtype 6 dashtype 3 title "polynomial, remembered", \
       1.6*d_max*(n_min/x)**1.5 with lines linecolor "gray60" dashtype 2 title "order 3/2", \
       0.6*m_max*(n_min/x)**(what eq "shift" ? 2 : 1) with lines linecolor "gray60" dashtype 4 title "order 1; right, 2"
}
unset multiplot
