# Errors of forces on ellipses, each point one load: with rows and cells that fit a/b, some hundred cells in joined rows
# have at most two thousandths of full sliding without spin, and one percent with any spin. Crosses are of the
# standard scheme on equal rectangles.
ellipses = tables."/ellipses.tsv"
aspect_at(i) = real(by_awk(ellipses, sprintf("!seen[$at[\"aspect\"]]++ { if (++n == %d) print $at[\"aspect\"] }'", i)))
count = int(by_awk(ellipses, "!seen[$at[\"aspect\"]]++ { n++ } END { print n }'"))
# Points of one number of cells stand side by side.
of(scheme, kind, i) = strcol("scheme") eq scheme && strcol("kind") eq kind && abs(column("aspect") / aspect_at(i) - 1) < 1e-6 ? column("cells") * 1.04**(i - 0.5 * (count + 1)) : NaN

eval page(800, 400)
set multiplot layout 1,2 margins 0.105,0.98,0.17,0.89 spacing 0.115,0.14
set logscale xy
set format y "10^{%T}"
set xrange [35:2000]
set yrange [3e-7:1e-1]
set xtics (50, 100, 200, 400, 800)
set xlabel "number of cells [1]"
kinds = "creepage spin"
do for [panel=1:2] {
  kind = word(kinds, panel)
  set title panel == 1 ? "without spin" : "with spin"
  if (panel == 1) { set ylabel "error of the force, over full sliding [1]" } else { unset ylabel }
  if (panel == 2) { set key right bottom at graph 0.97,0.03 samplen 0.5 } else { unset key }
  plot for [i=1:count] ellipses using (of("joined", kind, i)):"force_error" with points linetype i pointtype 7 \
         pointsize 0.45 title sprintf("a/b = %.3g", aspect_at(i)), \
       for [i=1:count] ellipses using (of("standard", kind, i)):"force_error" with points linetype i pointtype 2 \
         pointsize 0.45 notitle
}
unset multiplot
