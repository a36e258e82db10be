# Size and phase of the force that answers small waves of the creepage, against their wavelength: exact
# curves where everything adheres and about a state with slip, transient schemes, and a foundation of springs.
curves = tables."/curves.tsv"
measured = tables."/measured.tsv"
slips = 0.6
of(name, ratio) = strcol("case") eq name && same(column("stick_ratio"), ratio) ? column("wavelength_ratio") : NaN
at(kernel, ratio, scheme) = strcol("kernel") eq kernel && same(column("stick_ratio"), ratio) && strcol("scheme") eq scheme \
  && column("step_ratio") == 1 ? column("wavelength_ratio") : NaN
degrees(phase) = phase * 180 / pi
eval page(760, 620)
set multiplot layout 2,1 margins 0.1,0.97,0.1,0.97 spacing 0.04
set logscale x
set format x ""
set logscale y
set ylabel "|H|"
set yrange [0.005:1.5]
set key bottom right
plot curves using (of("plane", 1)):"size" with @exact_line title "plane strain, all adheres", \
     curves using (of("strip", 1)):"size" with lines linetype 1 title "strip, all adheres", \
     curves using (of("plane", slips)):"size" with lines linetype 3 title "plane strain, a' = 0.6", \
     curves using (of("winkler", 1)):"size" with lines linetype 2 dashtype 2 title "springs (FASTSIM)", \
     measured using (at("plane", 1, "material")):"size" with points linetype 7 pointtype 7 pointsize 0.45 title "material", \
     measured using (at("strip", 1, "material")):"size" with points linetype 1 pointtype 7 pointsize 0.45 notitle, \
     measured using (at("plane", slips, "material")):"size" with points linetype 3 pointtype 7 pointsize 0.45 notitle, \
     measured using (at("plane", 1, "direct")):"size" with points linetype 5 pointtype 6 pointsize 0.8 title "direct"
set format x "10^{%T}"
unset logscale y
set xlabel "wavelength of the creepage over the half-width, L/a [1]"
set ylabel "phase of H [degrees]"
set yrange [-100:5]
set ytics 30
unset key
plot curves using (of("plane", 1)):(degrees(column("phase"))) with @exact_line, \
     curves using (of("strip", 1)):(degrees(column("phase"))) with lines linetype 1, \
     curves using (of("plane", slips)):(degrees(column("phase"))) with lines linetype 3, \
     curves using (of("winkler", 1)):(degrees(column("phase"))) with lines linetype 2 dashtype 2, \
     measured using (at("plane", 1, "material")):(degrees(column("phase"))) with points linetype 7 pointtype 7 pointsize 0.45, \
     measured using (at("strip", 1, "material")):(degrees(column("phase"))) with points linetype 1 pointtype 7 pointsize 0.45, \
     measured using (at("plane", slips, "material")):(degrees(column("phase"))) with points linetype 3 pointtype 7 pointsize 0.45, \
     measured using (at("plane", 1, "direct")):(degrees(column("phase"))) with points linetype 5 pointtype 6 pointsize 0.8
unset multiplot
