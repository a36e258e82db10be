# With the zero frequency, as in the thesis (dashed), the approximate inverse does not converge; without it (drawn),
# it does. Errors are taken away from the boundary.
errors = tables."/errors.tsv"
ratios = ""
first = NaN
set table $ratios
plot errors using (column(0) == 0 ? first = column("elements") : 0, strcol("basis") eq "constant" && column("elements") == first ? (ratios = ratios.sprintf(" %g", column("step_ratio")), 0) : 0) with table
unset table
of(name, c) = strcol("basis") eq name && same(column("step_ratio"), real(c)) ? column("elements") : NaN

eval page(640, 420)
set logscale xy
set format y "10^{%T}"
set xlabel "size of B [1]"
set ylabel "largest error away from the boundary, relative [1]"
set key bottom left
set title "Fourier inverse of A - A'; dashed: with the zero frequency, as in the thesis"
names = "constant linear"
plot for [b=1:2] for [i=1:words(ratios)] errors using (of(word(names, b), word(ratios, i))):"without_mean" \
       with linespoints linetype 2*i-2+b pointtype 7 pointsize 0.3 title word(names, b).", c = ".word(ratios, i), \
     for [b=1:2] for [i=1:words(ratios)] errors using (of(word(names, b), word(ratios, i))):"without_boundary" \
       with lines linetype 2*i-2+b dashtype 2 notitle, \
     0.15 * 16 / x with lines linecolor "gray60" dashtype 3 title "first order"
