# Errors of the creep coefficients of the contact ellipse, against Galin's theorem, by the number of cells: joined rows
# are of second order, and have at most 4e-4 on 100 cells; equal rectangles are of first order, with steps where cells
# enter the ellipse.
errors = tables."/errors.tsv"
names = "C11 C22 C23 C33"
of(scheme, aspect) = strcol("scheme") eq scheme && abs(column("aspect") / aspect - 1) < 1e-6 ? column("cells") : NaN
aspect_at(i) = real(by_awk(errors, sprintf("!seen[$at[\"aspect\"]]++ { if (++n == %d) print $at[\"aspect\"] }'", i)))
count = int(by_awk(errors, "!seen[$at[\"aspect\"]]++ { n++ } END { print n }'"))

eval page(800, 640)
set multiplot layout 2,2 margins 0.105,0.98,0.115,0.93 spacing 0.115,0.14
set logscale xy
set format y "10^{%T}"
set xrange [18:900]
set yrange [2e-7:3]
set xtics (25, 50, 100, 200, 400, 800)
do for [panel=1:4] {
  name = word(names, panel)
  set title name
  if (panel > 2) { set xlabel "number of cells [1]" } else { unset xlabel }
  if (panel % 2 == 1) { set ylabel "relative error [1]" } else { unset ylabel }
  if (panel < 3) { set key at graph 0.98,0.62 } else { unset key }
  plot for [i=1:count] errors using (of("standard", aspect_at(i))):(column(name)) with linespoints \
         linecolor rgb colour_of("standard") dashtype i pointtype 4+i pointsize 0.6 \
         title panel == 1 && i == 1 ? "equal rectangles" : "", \
       for [i=1:count] errors using (of("joined", aspect_at(i))):(column(name)) with linespoints \
         linecolor rgb colour_of("calibrated") dashtype i pointtype 4+i pointsize 0.6 \
         title panel == 2 ? sprintf("a/b = %.3g", aspect_at(i)) : i == 1 ? "joined rows" : ""
}
unset multiplot
