# Tractions in the row at the centre of a circle that was shifted by 0.6 of full sliding, and has rolled half its length
# under a creepage: the standard scheme, which is CONTACT's, wiggles and smears if steps are small. Under-relaxed steps do not
# wiggle, and smear as much; what remembers does neither.
tractions = tables."/tractions.tsv"
of(scheme, c) = strcol("scheme") eq scheme && (c eq "" || same(column("step_ratio"), real(c))) ? column("x") : NaN
names = "direct relaxed remembered"
labels = "standard under-relaxed remembered"
ratios = by_awk(tractions, "$at[\"scheme\"] == \"direct\" && !seen[$at[\"step_ratio\"]]++ { n++; r[n] = $at[\"step_ratio\"] } END { printf(\"%g %g %g\", r[1], r[n - 1], r[n]) }'")
eval page(900, 380)
set multiplot layout 1,3 margins 0.085,0.985,0.17,0.89 spacing 0.08,0.14
set xrange [-1:1]
set yrange [0:1.1]
set xlabel "x [mm]"
do for [s=1:3] {
  name = word(names, s)
  set title word(labels, s)
  if (s == 1) { set ylabel "traction over μp_0 [1]" } else { unset ylabel }
  if (s == 2) { set key top right samplen 2 } else { unset key }
  plot tractions using (of("reference", "")):"bound" with @bound_line notitle, \
       tractions using (of("reference", "")):"traction" with @exact_line title "reference", \
       for [i=1:words(ratios)] tractions using (of(name, word(ratios, i))):"traction" with linespoints \
         linetype i pointtype 5+i pointsize 0.5 title "c = ".word(ratios, i)
}
unset multiplot
