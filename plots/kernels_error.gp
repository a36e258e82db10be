# With calibrated edges the force is of second order on each kernel, and by the standard scheme of first order (right).
# Left, the edge that differences feel moves from 0.825 to 1 element as the layer gets softer, as Wiener-Hopf theory
# predicts.
edges = tables."/edges.tsv"
errors = tables."/errors.tsv"
load scripts."/kernels.gpi"
of(scheme, k) = strcol("scheme") eq scheme && strcol("softness") eq softness(k) ? shown(abs(column("error"))) : NaN
eval page(900, 410)
set multiplot layout 1,2 margins 0.1,0.98,0.16,0.95 spacing 0.12
set logscale x
set format x "10^{%T}"
set xlabel "compliance of the layer over the element's [1]" offset 0,0.2
set ylabel "elements from the last node to the edge [1]"
set yrange [0.8:1.02]
set key bottom right
plot edges using "element_softness":"offset" with @exact_line title "Wiener and Hopf", \
     edges using "element_softness":"measured" with points linecolor rgb colour_of("standard") pointtype 6 pointsize 0.7 title "measured with 40 elements"
set logscale y
set format x "%g"
set format y "10^{%T}"
set xlabel "number of elements N"
set ylabel "error of the force over full sliding [1]"
set xtics (50, 100, 200, 400, 800)
set xrange [40:1000]
set yrange [1e-9:3e-2]
set key bottom left Left reverse
set label 1 "standard, as CONTACT:\nfirst order" at 950, 0.013 right textcolor rgb label_colour_of("standard")
set label 2 "calibrated:\nsecond order" at 300, 5e-5 textcolor rgb label_colour_of("calibrated")
plot for [scheme in "standard calibrated"] for [k=1:words(cases)] errors using "elements":(of(scheme, k)) with linespoints linecolor rgb colour_of(scheme) pointtype (k == 1 ? 7 : softness(k) eq "inf" ? 6 : 1) pointsize 0.5 notitle, \
     keyentry with points linecolor "gray40" pointtype 7 pointsize 0.5 title "half-space", \
     keyentry with points linecolor "gray40" pointtype 1 pointsize 0.5 title "layers", \
     keyentry with points linecolor "gray40" pointtype 6 pointsize 0.5 title "springs (brush)"
unset multiplot
