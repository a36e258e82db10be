# The shorter a small wave of the creepage, the less the force follows it, and the later; springs (FASTSIM) answer too
# much and too early. Lines are exact, where everything adheres and about a state with slip; points are transient
# schemes.
curves = tables."/curves.tsv"
measured = tables."/measured.tsv"
slips = 0.6
of(name, ratio) = strcol("case") eq name && same(column("stick_ratio"), ratio) ? column("wavelength_ratio") : NaN
at(kernel, ratio, scheme) = strcol("kernel") eq kernel && same(column("stick_ratio"), ratio) && strcol("scheme") eq scheme \
  && column("step_ratio") == 1 ? column("wavelength_ratio") : NaN
angle(n) = column("phase") * 180 / pi
# The schemes: remembered, drawn last and listed first, and direct.
names = "remembered direct"
point(k) = k == 1 ? 7 : 6
size(k) = k == 1 ? 0.45 : 1.2
kernel(i) = i == 2 ? "strip" : "plane"
ratio(i) = i == 3 ? slips : 1
eval page(640, 620)
set multiplot layout 2,1 margins 0.13,0.97,0.1,0.97 spacing 0.04
set logscale x
set format x ""
set logscale y
set ylabel "|H|"
set yrange [0.005:1.5]
set key bottom right
plot curves using (of("plane", 1)):"size" with @exact_line title "plane strain, all adheres", \
     curves using (of("strip", 1)):"size" with lines linecolor "black" dashtype 4 title "strip, all adheres", \
     curves using (of("plane", slips)):"size" with lines linetype 3 title "plane strain, a' = 0.6", \
     curves using (of("winkler", 1)):"size" with lines linecolor rgb colour_of("springs") dashtype 2 title "springs (FASTSIM)", \
     measured using (at("plane", 1, "direct")):"size" with points linecolor rgb colour_of("direct") pointtype point(2) pointsize size(2) notitle, \
     for [i=1:3] measured using (at(kernel(i), ratio(i), "remembered")):"size" \
       with points linecolor rgb colour_of("remembered") pointtype point(1) pointsize size(1) notitle, \
     for [k=1:2] keyentry with points linecolor rgb colour_of(word(names, k)) pointtype point(k) pointsize size(k) title word(names, k)
set format x "10^{%T}"
unset logscale y
set xlabel "wavelength of the creepage over the half-width, L/a [1]"
set ylabel "phase of H [degrees]"
set yrange [-100:5]
set ytics 30
unset key
plot curves using (of("plane", 1)):(angle(0)) with @exact_line, \
     curves using (of("strip", 1)):(angle(0)) with lines linecolor "black" dashtype 4, \
     curves using (of("plane", slips)):(angle(0)) with lines linetype 3, \
     curves using (of("winkler", 1)):(angle(0)) with lines linecolor rgb colour_of("springs") dashtype 2, \
     measured using (at("plane", 1, "direct")):(angle(0)) with points linecolor rgb colour_of("direct") pointtype point(2) pointsize size(2) notitle, \
     for [i=1:3] measured using (at(kernel(i), ratio(i), "remembered")):(angle(0)) \
       with points linecolor rgb colour_of("remembered") pointtype point(1) pointsize size(1) notitle
unset multiplot
