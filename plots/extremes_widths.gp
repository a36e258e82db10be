# Steady rolling on strips of any width, for three Poisson ratios.
widths = tables."/widths.tsv"
of(name, nu) = strcol("scheme") eq name && same(column("poisson_ratio"), nu) && strcol("verdict") eq "ok" ? column("width") : NaN

eval page(640, 400)
set logscale xy
set format "10^{%T}"
set xlabel "strip width Δy/dx [1]"
set ylabel "error of force or creepage [1]"
set xrange [5e-4:2e8]
set yrange [1e-16:1]
set title "strips of any width, N = 51; open to full points: ν = 0, 0.28, 0.5"
set key outside right center
names = "standard 'standard linear' calibrated inversion chebyshev"
ratios = "0 0.28 0.5"
plot for [i=1:words(names)] for [k=1:3] widths using (of(word(names, i), real(word(ratios, k)))):(shown(column("error"))) with linespoints linetype i pointtype (k == 1 ? 6 : k == 2 ? 1 : 7) pointsize 0.5 title (k == 3 ? word(names, i) : "")
