# The energy that a cycle loses without rolling falls like the cube of a small force (left); elements see the loss only
# if a slip zone is about as long as they are (right).
curve = tables."/curve.tsv"
of(scheme, n) = strcol("scheme") eq scheme && (scheme eq "exact" || column("elements") == n)
stats curve using (strcol("scheme") eq "exact" ? NaN : column("elements")) name "n" nooutput
exact(tau) = 2*(1 - tau)*log(1 - tau) + 2*tau - tau**2
ratio(scheme, n) = of(scheme, n) && column("dissipation") > 0 ? column("dissipation")/exact(column("amplitude")) : NaN

eval page(860, 420)
set multiplot layout 1,2 margins 0.11,0.98,0.14,0.9 spacing 0.12
set logscale xy
set format y "10^{%T}"
set xlabel "amplitude of the force / full sliding [1]"
set ylabel "dissipation / k F_{max}^2 [1]"
set title "a cycle loses"
set key bottom right samplen 1
set yrange [1e-12:2]
plot curve using (of("exact", 0) ? column("amplitude") : NaN):"dissipation" with @exact_line title "exact", \
     x**3/3 with lines linecolor "gray60" dashtype 2 title "cube / 3", \
     for [i=1:2] curve using (of("remembered", i == 1 ? n_min : n_max) && column("dissipation") > 0 ? column("amplitude") : NaN):"dissipation" \
       with points linecolor rgb colour_of("remembered") pointtype (i == 1 ? 6 : 7) pointsize (i == 1 ? 0.8 : 0.5) title sprintf("remembered, N = %g", i == 1 ? n_min : n_max), \
     for [i=1:2] curve using (of("direct", i == 1 ? n_min : n_max) && column("dissipation") > 0 ? column("amplitude") : NaN):"dissipation" \
       with points linecolor rgb colour_of("direct") pointtype (i == 1 ? 4 : 5) pointsize (i == 1 ? 0.9 : 0.4) title sprintf("direct, N = %g", i == 1 ? n_min : n_max)
unset logscale y
set format y "%g"
set yrange [0:1.4]
set xrange [0.1:*]
set xlabel "length of a slip zone / element [1]"
set ylabel "dissipation / exact [1]"
set title "where elements see it"
set key bottom right
plot 1 with @exact_line notitle, \
     for [i=1:2] curve using (column("slip_elements")):(ratio("remembered", i == 1 ? n_min : n_max)) \
       with linespoints linecolor rgb colour_of("remembered") pointtype (i == 1 ? 6 : 7) pointsize (i == 1 ? 0.8 : 0.5) title sprintf("remembered, N = %g", i == 1 ? n_min : n_max), \
     for [i=1:2] curve using (column("slip_elements")):(ratio("direct", i == 1 ? n_min : n_max)) \
       with linespoints linecolor rgb colour_of("direct") pointtype (i == 1 ? 4 : 5) pointsize (i == 1 ? 0.9 : 0.4) dashtype 3 title sprintf("direct, N = %g", i == 1 ? n_min : n_max)
unset multiplot
