# Which part of a creepage-force curve depends on the kernel? Its slope, by which creepages are divided. C_a = 2 (1 - nu) a/G.
curves = tables."/curves.tsv"
slopes = tables."/slopes.tsv"
cases = system(sprintf("grep -v '^#' \"%s\" | tail -n +2 | cut -f2", slopes))
titled(k) = word(cases, k) eq "inf" ? "springs alone (brush)" : word(cases, k) + 0 == 0 ? "half-space (Carter)" : sprintf("layer, C/C_a = %.3g", word(cases, k) + 0)
of(k) = strcol("softness") eq word(cases, k) ? column("force_ratio") : NaN
eval page(960, 430)
set multiplot layout 1,2 margins 0.075,0.98,0.16,0.95 spacing 0.1
set xlabel "creepage w |dF/dw|_0 over full sliding [1]" offset 0,0.2
set ylabel "force over full sliding [1]"
set xrange [0:4]
set yrange [0:1.05]
set key bottom right
plot for [k=1:words(cases)] curves using "creepage":(of(k)) with lines linetype k title titled(k)
set ylabel "the same less the half-space's [1]"
set yrange [*:*]
carter(x) = x < 2 ? x - x * x / 4 : 1
unset key
plot for [k=1:words(cases)] curves using "creepage":(of(k) - carter(column("creepage"))) with lines linetype k
unset multiplot
