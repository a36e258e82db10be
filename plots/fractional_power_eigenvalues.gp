# With an even number of elements one eigenvalue lies on the negative real axis, where a fractional power is complex;
# with an odd number none does. All lie inside the unit circle.
eigenvalues = tables."/eigenvalues.tsv"
stats eigenvalues using "elements" nooutput
odd = STATS_max
even = STATS_min
of(n) = column("elements") == n ? column("real") : NaN

eval page(560, 520)
set size ratio -1
set xrange [-1.1:1.1]
set yrange [-1.1:1.1]
set xlabel "real part [1]"
set ylabel "imaginary part [1]"
set key at graph 0.68, 0.64
least = last_value(eigenvalues, sprintf("$at[\"elements\"] == %d && $at[\"real\"] < least { least = $at[\"real\"] } $at[\"real\"] == least", even), "real")
set arrow from -0.5, -0.13 to least + 0.04, -0.01 linecolor "gray40" linewidth 0.8 filled
set label sprintf("N = %d: one on the\nnegative real axis", even) at -0.5, -0.18
set title "eigenvalues of A^{-1}A*"
set parametric
set trange [0:2*pi]
plot cos(t), sin(t) with lines linecolor "gray60" dashtype 2 title "unit circle", \
     eigenvalues using (of(odd)):"imaginary" with points linetype 1 pointtype 7 pointsize 0.4 title sprintf("N = %d", odd), \
     eigenvalues using (of(even)):"imaginary" with points linetype 2 pointtype 6 pointsize 0.6 title sprintf("N = %d", even)
