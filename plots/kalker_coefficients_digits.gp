# The last digit of the coefficients that Kalker printed in 1990: right to a unit (grey) where the ellipse is nearly a
# circle, up to eight units off where it is slender. A single point far below its neighbours may be a misprint.
coefficients = tables."/coefficients.tsv"
names = "C11 C22 C23 C33"
ratios = "0 0.25 0.5"
of(name, nu) = strcol("coefficient") eq name && abs(column("poisson_ratio") - nu) < 1e-9 ? column("aspect") : NaN

eval page(800, 640)
set multiplot layout 2,2 margins 0.105,0.98,0.115,0.93 spacing 0.115,0.14
set logscale x
set xrange [0.09:11]
set yrange [-9:9]
set xtics (0.1, 0.2, 0.5, 1, 2, 5, 10)
do for [panel=1:4] {
  name = word(names, panel)
  set title name
  if (panel > 2) { set xlabel "a/b [1]" } else { unset xlabel }
  if (panel % 2 == 1) { set ylabel "units of the last digit [1]" } else { unset ylabel }
  if (panel == 1) { set key top right } else { unset key }
  set object 1 rectangle from graph 0, first -1 to graph 1, first 1 behind fillcolor rgb "gray90" fillstyle solid noborder
  plot for [i=1:3] coefficients using (of(name, real(word(ratios, i)))):(column("units")) \
         with points linetype i pointtype 4+i pointsize 0.6 \
         title sprintf("nu = %s", word(ratios, i)), \
       0 with lines linecolor "gray60" notitle
}
unset multiplot
