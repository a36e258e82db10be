# A circle under spin from rest: tractions, and in colour how much of the bound they are, after it has rolled some
# half-widths. Rolling is to the right. Dark cells slip. Slip eats the stuck zone from the edges, until little is left at the
# trailing edge, and the tractions of the leading half become the lateral force of spin.
map = tables."/map.tsv"
distances = by_awk(map, "!seen[$at[\"distance\"]]++ { printf(\"%g \", $at[\"distance\"]) }'")
n = words(distances)
at(q) = same(column("distance"), q) ? column("x") : NaN
length = 0.17
eval page(640, 460)
set multiplot layout 2,3 margins 0.01,0.99,0.02,0.92 spacing 0.02,0.07
set size ratio -1
unset border
unset grid
unset tics
unset xlabel
unset ylabel
set xrange [-1.05:1.05]
set yrange [-1.05:1.05]
set cbrange [0:1]
set palette defined (0 "#f7fbff", 0.6 "#c6dbef", 0.97 "#9ecae1", 1 "#4292c6")
unset key
do for [i=1:n] {
  q = word(distances, i)
  set title "q = ".q." a"
  if (i == n) {
    set colorbox user origin 0.8,0.06 size 0.02,0.34
    set cbtics 0.5 format "%g"
  } else { unset colorbox }
  plot map using (at(q)):"y":"x_low":"x_high":"y_low":"y_high":"part" with boxxyerror fillstyle solid noborder linecolor palette, \
       map using (at(q)):"y":(length * column("p_x")):(length * column("p_y")) with vectors head size 0.045,25 filled linecolor "black" linewidth 0.7
}
unset multiplot
