# The difference of a traction function and the same shifted by a small step is narrow peaks of opposite sign for a
# constant function, and a low step for a linear one (thesis Fig. 5.1).
functions = tables."/functions.tsv"
of(name) = strcol("basis") eq name ? column("s") : NaN

eval page(640, 300)
set multiplot layout 1,2 margins 0.12,0.98,0.2,0.88 spacing 0.12
set xrange [-1.5:1.5]
set yrange [-1.1:2.8]
set xlabel "distance from the node [dx]"
set ylabel "traction function [1]"
set key top left
do for [name in "constant linear"] {
  set title name
  plot functions using (of(name)):"function" with lines linetype 4 title "function", \
       functions using (of(name)):"shifted" with lines linetype 2 title "shifted", \
       functions using (of(name)):"difference" with lines linetype 7 title "difference"
  unset key
}
unset multiplot
