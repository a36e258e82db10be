# Peaks of traction form at the leading edge and travel through the contact, here at six places on the way of a rolling
# cylinder.
snapshots = tables."/snapshots.tsv"
places = ""
set table $places
plot snapshots using (p = sprintf(" %.17g", column("X")), places = strstrt(places, p) ? places : places.p, 0) with table
unset table
at(p) = same(column("X"), real(p)) ? column("x") : NaN

set xrange [-1:1]
set xlabel "x [mm], rolling to the right"
set ylabel "traction -p [N/mm^2]"
set yrange [-0.1:0.55]
set key top right maxrows 3
set title "rolling cylinder: tractions on the way"
plot for [i=1:words(places)] snapshots using (at(word(places, i))):(-column("traction")) \
       with lines linetype i title sprintf("X = %.2g mm", real(word(places, i)))
