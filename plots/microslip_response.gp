# The force that answers a small harmonic creepage: its size and phase against the wavelength, and
# both in one curve.
response = tables."/response.tsv"
eval page(860, 520)
set multiplot
set logscale x
set format x ""
set ylabel "|H|" offset 1.8,0
set logscale y
set lmargin at screen 0.09; set rmargin at screen 0.54
set bmargin at screen 0.56; set tmargin at screen 0.96
unset key
plot response using "wavelength_ratio":"size" with lines linetype 1
set format x "10^{%T}"
unset logscale y
set xlabel "wavelength of the creepage over the half-width, L/a [1]"
set ylabel "phase of H [degrees]"
set yrange [*:0]
set ytics 30
set bmargin at screen 0.11; set tmargin at screen 0.51
plot response using "wavelength_ratio":(column("phase") * 180 / pi) with lines linetype 2
unset logscale x
set format x
set lmargin at screen 0.65; set rmargin at screen 0.98
set bmargin at screen 0.34; set tmargin at screen 0.74
set xlabel "real part of H"
set ylabel "imaginary part of H" offset 1,0
set xrange [0:1]
set yrange [*:0]
set ytics autofreq
set size ratio -1
plot response using (column("size") * cos(column("phase"))):(column("size") * sin(column("phase"))) with linespoints linetype 3 pointtype 7 pointsize 0.3
unset multiplot
