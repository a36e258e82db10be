# Errors of forces and moment on a circle, root mean squares over all levels of creepage or spin, against the number of
# cells: joined rows are of second order, and the standard scheme of first order. CONTACT's results lie on it.
summary = tables."/summary.tsv"
of(scheme, kind) = strcol("scheme") eq scheme && strcol("kind") eq kind ? column("cells") : NaN

eval page(800, 400)
set multiplot layout 1,2 margins 0.105,0.98,0.17,0.89 spacing 0.115,0.14
set logscale xy
set format y "10^{%T}"
set xrange [40:1600]
set yrange [1e-5:20]
set xtics (50, 100, 200, 400, 800)
set xlabel "number of cells [1]"
kinds = "creepage spin"
do for [panel=1:2] {
  set title panel == 1 ? "force, over full sliding" : "moment, over full sliding and a"
  name = panel == 1 ? "force_error" : "moment_error"
  if (panel == 1) { set ylabel "error [1]" } else { unset ylabel }
  if (panel == 1) { set key at graph 0.98,0.97 } else { unset key }
  plot for [i=1:2] summary using (of("standard", word(kinds, i))):(column(name)) with lines \
         linecolor rgb colour_of("standard") dashtype i title "standard scheme, ".word(kinds, i), \
       for [i=1:2] summary using (of("contact", word(kinds, i))):(column(name)) with points \
         linecolor rgb colour_of("standard") pointtype 4+i pointsize 0.6 title "CONTACT, ".word(kinds, i), \
       for [i=1:2] summary using (of("joined", word(kinds, i))):(column(name)) with linespoints \
         linecolor rgb colour_of("calibrated") dashtype i pointtype 4+i pointsize 0.6 title "joined rows, ".word(kinds, i)
}
unset multiplot
