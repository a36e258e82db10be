# In the half-space the force comes at most a quarter of a wave after the creepage: the frequency response goes from
# slow waves at 1 to fast ones at 0 in one quarter of the complex plane.
curves = tables."/curves.tsv"
measured = tables."/measured.tsv"
slips = 0.6
of(name, ratio) = strcol("case") eq name && same(column("stick_ratio"), ratio) ? column("size") * cos(column("phase")) : NaN
at(kernel, ratio, scheme) = strcol("kernel") eq kernel && same(column("stick_ratio"), ratio) && strcol("scheme") eq scheme \
  && column("step_ratio") == 1 ? column("size") * cos(column("phase")) : NaN
imaginary(n) = column("size") * sin(column("phase"))
kernel(i) = i == 2 ? "strip" : "plane"
ratio(i) = i == 3 ? slips : 1
eval page(640, 460)
set xlabel "real part of H [1]"
set ylabel "imaginary part of H [1]"
set size ratio -1
set xrange [-0.05:1.05]
set yrange [-0.72:0.05]
set key at graph 0.68, 0.9
plot curves using (of("plane", 1)):(imaginary(0)) with @exact_line title "plane strain, all adheres", \
     curves using (of("strip", 1)):(imaginary(0)) with lines linecolor "black" dashtype 4 title "strip, all adheres", \
     curves using (of("plane", slips)):(imaginary(0)) with lines linetype 3 title "plane strain, a' = 0.6", \
     curves using (of("winkler", 1)):(imaginary(0)) with lines linecolor rgb colour_of("springs") dashtype 2 title "springs (FASTSIM)", \
     for [i=1:3] measured using (at(kernel(i), ratio(i), "remembered")):(imaginary(0)) \
       with points linecolor rgb colour_of("remembered") pointtype 7 pointsize 0.45 notitle, \
     keyentry with points linecolor rgb colour_of("remembered") pointtype 7 pointsize 0.45 title "remembered"
