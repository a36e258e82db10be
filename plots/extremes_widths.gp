# On strips of any width the inversion and Chebyshev collocation are exact where they solve, calibrated elements are
# right to 0.02 to 0.5 %, and the standard scheme to 1 to 2 %. Steady rolling, N = 51; points at the same width are
# Poisson ratios.
widths = tables."/widths.tsv"
names = "standard calibrated inversion chebyshev"
ratios = by_awk(widths, "{ print $at[\"poisson_ratio\"] }' | sort -gu")
of(scheme, nu) = sprintf("< awk -F'\t' '/^#/ || !head++ || ($1 == \"%s\" && $3 + 0 == %s)' \"%s\"", scheme, nu, widths)
good(error) = strcol("verdict") eq "ok" ? shown(error) : NaN
# Where the labels stand, on the widest strip.
place(scheme, error) = column("width") > 5e7 ? shown(error) * (scheme eq "inversion" ? 300 : scheme eq "chebyshev" ? 8 : 1) : NaN

eval page(640, 400)
set logscale xy
set format "10^{%T}"
set lmargin at screen 0.13
set rmargin at screen 0.82
set xlabel "width of the strip over the element, Δy/dx"
set ylabel "error of force or creepage"
set xrange [5e-4:2e8]
set yrange [1e-16:1]
unset key
plot for [i=1:words(names)] for [k=1:words(ratios)] of(word(names, i), word(ratios, k)) using "width":(good(column("error"))) with linespoints linecolor rgb colour_of(word(names, i)) pointtype (k == 1 ? 6 : k == 2 ? 1 : 7) pointsize 0.5, \
     for [i=1:words(names)] of(word(names, i), word(ratios, 1)) using "width":(place(word(names, i), column("error"))):(word(names, i)) with labels left offset 0.8,0 textcolor rgb label_colour_of(word(names, i))
