# How much of each of Kalker's coefficients is left if creepage or spin oscillates: its size over that of long waves,
# against the wavelength. Forces fall with the wavelength, in the end like a flat punch that shifts to and fro. The moment
# of spin rises first, on long ellipses to many times that of steady spin.
curves = tables."/curves.tsv"
limits = tables."/limits.tsv"
names = "C11 C22 C23 C33"
is(name, aspect) = strcol("coefficient") eq name && same(column("aspect"), real(aspect))
aspects = by_awk(limits, "$at[\"coefficient\"] == \"C11\" { printf(\"%s \", $at[\"aspect\"]) }'")

eval page(800, 620)
set multiplot layout 2,2 margins 0.12,0.98,0.125,0.95 spacing 0.085,0.11
set logscale xy
set xrange [0.7:300]
set format x "10^{%T}"
set xtics (1, 10, 100)
set format x "%g"
do for [k=1:4] {
  name = word(names, k)
  if (k > 2) { set xlabel "wavelength over the half-width, L/a [1]" } else { unset xlabel }
  if (k % 2 == 1) { set ylabel "size over the steady one [1]" } else { unset ylabel }
  set title k == 1 ? "C_{11}: longitudinal" : k == 2 ? "C_{22}: lateral" : k == 3 ? "C_{23}: lateral force of spin" : "C_{33}: moment of spin"
  set yrange [k == 3 ? 0.01 : k == 4 ? 0.2 : 0.04 : k == 4 ? 30 : 1.5]
  if (k == 1) { set key bottom right } else { unset key }
  plot for [i=1:words(aspects)] curves using (is(name, word(aspects, i)) ? column("wavelength") : NaN): \
         (sqrt(column("real")**2 + column("imaginary")**2)) \
         with lines linetype i title "a/b = ".word(aspects, i)
}
unset multiplot
