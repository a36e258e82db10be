# The direct scheme flattens and displaces the travelling peak, if steps are shorter than an element. From a Cattaneo
# shift to Carter's solution, thesis Fig. 4.3.
traction = tables."/traction.tsv"
ratios = ""
set table $ratios
plot tables."/summary.tsv" using (ratios = ratios.sprintf(" %g", column("step_ratio")), 0) with table
unset table
at(c) = same(column("step_ratio"), real(c)) ? column("x") : NaN

set xrange [-1:1]
set xlabel "x [mm], rolling to the right"
set ylabel "traction p [N/mm^2]"
set key at 0.22,0.62
set title "from a Cattaneo shift to Carter's solution, direct scheme"
plot traction using (at(word(ratios, 1))):"bound" with @bound_line title "bound g", \
     for [i=1:words(ratios)] traction using (at(word(ratios, i))):"traction" \
       with linespoints linetype i pointtype 7 pointsize 0.25 title "c = ".word(ratios, i), \
     tables."/reference.tsv" using "x":"traction" with @exact_line title "reference"
