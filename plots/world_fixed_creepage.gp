# Nodes that are switched on and off make the creepage under a constant force jump to more than twice its mean (left);
# mean bounds and cut elements keep it within some percent (right).
creepage = tables."/creepage.tsv"
of(name) = strcol("treatment") eq name ? column("q") : NaN
when(name, event) = column(event) > 0 ? of(name) : NaN
names = '"at_node" "cell_mean" "cut" "direct"'
titles = '"nodes on and off" "mean bounds" "cut elements" "direct scheme"'

eval page(860, 440)
set multiplot layout 1,2 margins 0.095,0.98,0.14,0.92 spacing 0.09
set xlabel "distance rolled q [dx]"
set format x "%g"
set ylabel "creepage / mean [1]"
set key top left Left reverse
do for [panel=1:2] {
  set title panel == 1 ? "all treatments" : "without nodes on and off"
  set yrange [panel == 1 ? 0.6 : 0.96 : panel == 1 ? 3 : 1.06]
  line(i) = panel == 1 ? word(titles, i) : ""
  event(text) = panel == 2 ? text : ""
  plot for [i=panel:4] creepage using (of(word(names, i))):"relative" with lines linecolor rgb colour_of(word(names, i)) title line(i), \
       for [i=panel:3] creepage using (when(word(names, i), "left")):"relative" with points linecolor rgb colour_of(word(names, i)) pointtype 9 pointsize 0.7 notitle, \
       for [i=panel:4] creepage using (when(word(names, i), "released")):"relative" with points linecolor rgb colour_of(word(names, i)) pointtype 7 pointsize 0.6 notitle, \
       for [i=panel:3] creepage using (when(word(names, i), "entered")):"relative" with points linecolor rgb colour_of(word(names, i)) pointtype 4 pointsize 0.6 notitle, \
       NaN with points linecolor "gray30" pointtype 9 pointsize 0.8 title event("element leaves at the trailing edge"), \
       NaN with points linecolor "gray30" pointtype 7 pointsize 0.7 title event("element begins to slip"), \
       NaN with points linecolor "gray30" pointtype 4 pointsize 0.7 title event("element enters at the leading edge")
}
unset multiplot
