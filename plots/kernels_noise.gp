# Do wiggles at small steps need the half-space? Amplitudes below 1e-5 are drawn there; C is that of the layer over an element's.
noise = tables."/noise.tsv"
slopes = tables."/slopes.tsv"
cases = system(sprintf("grep -v '^#' \"%s\" | tail -n +2 | cut -f2", slopes))
elements = system(sprintf("grep -v '^#' \"%s\" | tail -n +2 | cut -f3 | uniq", noise))
titled(k) = word(cases, k) eq "inf" ? "springs alone (brush)" : word(cases, k) + 0 == 0 ? "half-space" : sprintf("layer, C = %.3g elements", word(elements, k) + 0)
least = 1e-5
of(k) = strcol("softness") eq word(cases, k) ? (column("wiggle") > least ? column("wiggle") : least) : NaN
set logscale xy
set format xy "10^{%T}"
set xlabel "step over element c [1]"
set ylabel "amplitude of wiggles over the peak of the bound [1]"
set yrange [least/2:1]
set key at graph 0.03, 0.55 left Left reverse
plot for [k=1:words(cases)] noise using "step_ratio":(of(k)) with linespoints linetype k pointtype 7 pointsize 0.4 title titled(k)
