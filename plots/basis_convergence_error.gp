# Constant, linear and quadratic functions all converge with first order; with the limits of (B.30) as printed,
# quadratic functions do not converge. Thesis Fig. 6.9.
errors = tables."/errors.tsv"
bases = '"constant" "linear" "quadratic" "quadratic as printed"'
of(name) = strcol("basis") eq name ? column("elements") : NaN

eval page(800, 400)
set multiplot layout 1,2 margins 0.105,0.98,0.16,0.9 spacing 0.115
set logscale xy
set xrange [12:640]
set format y "10^{%T}"
set xtics (15, 31, 63, 127, 255, 511)
set xlabel "number of nodes N [1]"
do for [panel=1:2] {
  quantity = panel == 1 ? "force_error" : "point_error"
  set title panel == 1 ? "total traction" : "traction at x = 0, in adhesion"
  set ylabel panel == 1 ? "relative error [1]" : "error [N/mm^2]"
  set yrange [panel == 1 ? 1e-6 : 5e-6 : 0.2]
  scale = panel == 1 ? 0.09 : 0.03
  if (panel == 1) { set key bottom left } else { unset key }
  plot for [i=1:4] errors using (of(word(bases, i))):(column(quantity)) \
         with linespoints linetype i pointtype 4+i pointsize 0.5 title word(bases, i), \
       scale / x with lines linecolor "gray60" dashtype 2 title "first order"
}
unset multiplot
