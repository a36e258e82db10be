# The shorter a small wave of the creepage, the less the force follows it, and the later. From above: size and phase
# against the wavelength, and both in one curve. One line for each result.
load scripts."/microslip.gpi"
response = tables."/response.tsv"
eval key_height
if (lines == 1) { top = 20 }
height = 850 + top
eval page(640, height)
do for [pass=1:2] {
  eval begin_pass
  eval area(top, top + 200)
  set logscale xy
  set format x ""
  set ylabel "|H|"
  if (lines > 1) { eval draw_key }
  eval "set xrange ".x_range
  plot for [k=1:lines] response using (of(k, column("wavelength_ratio"))):"size" with lines linecolor rgb color(k) linewidth width(k)
  eval end_panel
  eval without_key
  set format x "10^{%T}"
  unset logscale y
  set xlabel "wavelength of the creepage over the half-width, L/a [1]"
  set ylabel "phase of H [degrees]"
  set yrange [*:0]
  set ytics 30
  eval area(top + 220, top + 420)
  plot for [k=1:lines] response using (of(k, column("wavelength_ratio"))):(column("phase") * 180 / pi) with lines linecolor rgb color(k) linewidth width(k)
  eval end_panel
  unset logscale x
  set format x "%g"
  eval area(top + 495, top + 795)
  set xlabel "real part of H"
  set ylabel "imaginary part of H"
  set xrange [0:1]
  set yrange [*:0]
  set ytics autofreq
  set size ratio -1
  plot for [k=1:lines] response using (of(k, column("size") * cos(column("phase")))):(column("size") * sin(column("phase"))) with linespoints linecolor rgb color(k) pointtype 7 pointsize 0.3
  set size noratio
  unset multiplot
}
