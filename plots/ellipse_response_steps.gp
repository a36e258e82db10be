# Errors of transient schemes that roll under waves of creepage and of spin, the largest of the four coefficients over the
# steady ones, against the step: shorter steps help what remembers, and harm the standard scheme.
steps = tables."/steps.tsv"
of(scheme, wavelength) = strcol("scheme") eq scheme && same(column("wavelength"), wavelength) ? column("step_ratio") : NaN
names = "direct remembered"
waves = by_awk(steps, "$at[\"scheme\"] == \"direct\" && !seen[$at[\"wavelength\"]]++ { printf(\"%s \", $at[\"wavelength\"]) }'")
set logscale xy
set format y "10^{%T}"
set xlabel "step over the element, c [1]"
set ylabel "largest error over the steady coefficient [1]"
set xrange [0.2:1.2]
set xtics (0.25, 0.5, 1)
set yrange [1e-7:0.5]
set key bottom right
plot for [s=1:2] for [i=1:words(waves)] steps using (of(word(names, s), word(waves, i))):"largest" with linespoints \
       linecolor rgb colour_of(word(names, s)) dashtype i pointtype 5+i pointsize 0.7 \
       title (s == 1 ? "standard scheme" : "remembered").", L/a = ".word(waves, i)
