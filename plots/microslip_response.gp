# The shorter a small wave of the creepage, the less the force follows it, and the later: size and phase against the
# wavelength (left), and both in one curve (right). One line for each result.
load scripts."/microslip.gpi"
response = tables."/response.tsv"
rows_of_key = rows(lines)
over = lines > 1 ? key_height(lines) : 0
height = 520. + over
y(part) = part * 520 / height
eval page(860, height)
set multiplot
set logscale x
set format x ""
set ylabel "|H|" offset 1.8,0
set logscale y
set lmargin at screen 0.09; set rmargin at screen 0.54
set bmargin at screen y(0.56); set tmargin at screen y(0.96)
if (lines > 1) { eval above(height) } else { unset key }
eval "set xrange ".x_range
plot for [k=1:lines] response using (of(k, column("wavelength_ratio"))):"size" with lines linecolor rgb color(k) linewidth width(k) title label(k)
unset key
set format x "10^{%T}"
unset logscale y
set xlabel "wavelength of the creepage over the half-width, L/a [1]"
set ylabel "phase of H [degrees]" offset 0.4,0
set yrange [*:0]
set ytics 30
set bmargin at screen y(0.11); set tmargin at screen y(0.51)
plot for [k=1:lines] response using (of(k, column("wavelength_ratio"))):(column("phase") * 180 / pi) with lines linecolor rgb color(k) linewidth width(k)
unset logscale x
set format x
set lmargin at screen 0.65; set rmargin at screen 0.98
set bmargin at screen y(0.34); set tmargin at screen y(0.74)
set xlabel "real part of H"
set ylabel "imaginary part of H" offset 1,0
set xrange [0:1]
set yrange [*:0]
set ytics autofreq
set size ratio -1
plot for [k=1:lines] response using (of(k, column("size") * cos(column("phase")))):(column("size") * sin(column("phase"))) with linespoints linecolor rgb color(k) pointtype 7 pointsize 0.3
unset multiplot
