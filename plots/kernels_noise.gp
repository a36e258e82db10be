# Small steps make tractions wiggle on the half-space and on stiff layers, and not on soft layers and springs.
# Amplitudes below 1e-5 are drawn there; C is the compliance of the layer over the compliance of an element.
noise = tables."/noise.tsv"
load scripts."/kernels.gpi"
elements = system(sprintf("grep -v '^#' \"%s\" | tail -n +2 | cut -f3 | uniq", noise))
name(k) = kernel_name(k)[1:5] eq "layer" ? sprintf("layer, C = %.3g elements", word(elements, k) + 0) : kernel_name(k)
least = 1e-5
of(k) = strcol("softness") eq softness(k) ? (column("wiggle") > least ? column("wiggle") : least) : NaN
set logscale xy
set format xy "10^{%T}"
set xlabel "step over element c [1]"
set ylabel "amplitude of wiggles over the peak of the bound [1]"
set yrange [least/2:1]
set key at graph 0.03, 0.55 left Left reverse
plot for [k=1:words(cases)] noise using "step_ratio":(of(k)) with linespoints linecolor rgb kernel_colour(k) pointtype 7 pointsize 0.4 title name(k)
