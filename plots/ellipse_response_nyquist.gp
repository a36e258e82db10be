# Kalker's coefficients in the complex plane, over those of long waves at 1: a point for each wavelength, from infinite on
# the right to short ones at 0. A force of creepage comes up to a quarter of a wave late. Short waves of spin turn the
# lateral force round, and their moment is larger than that of steady spin.
curves = tables."/curves.tsv"
limits = tables."/limits.tsv"
names = "C11 C22 C23 C33"
is(name, aspect) = strcol("coefficient") eq name && same(column("aspect"), real(aspect))
aspects = by_awk(limits, "$at[\"coefficient\"] == \"C11\" && $at[\"aspect\"] <= 2 { printf(\"%s \", $at[\"aspect\"]) }'")

eval page(800, 620)
set multiplot layout 2,2 margins 0.12,0.98,0.125,0.95 spacing 0.085,0.11
do for [k=1:4] {
  name = word(names, k)
  if (k > 2) { set xlabel "real part [1]" } else { unset xlabel }
  if (k % 2 == 1) { set ylabel "imaginary part [1]" } else { unset ylabel }
  set title k == 1 ? "C_{11}: longitudinal" : k == 2 ? "C_{22}: lateral" : k == 3 ? "C_{23}: lateral force of spin" : "C_{33}: moment of spin"
  set xrange [k == 3 ? -0.3 : k == 4 ? -0.2 : -0.05 : k == 4 ? 3.2 : 1.05]
  set yrange [k == 4 ? -2.5 : k == 3 ? -0.75 : -0.7 : k == 4 ? 1 : 0.06]
  if (k == 1) { set key at graph 0.95,0.95 } else { unset key }
  plot for [i=1:words(aspects)] curves using \
         (is(name, word(aspects, i)) ? column("real") : NaN): \
         "imaginary" \
         with lines linetype i title "a/b = ".word(aspects, i)
}
unset multiplot
