# Scaled by its slope at no creepage, the curve of creepage and force hardly depends on the kernel: all curves agree to
# 8 % of full sliding. C is the compliance of the layer, C_a = 2 (1 - nu) a/G.
curves = tables."/curves.tsv"
load scripts."/kernels.gpi"
of(k) = strcol("softness") eq softness(k) ? column("force_ratio") : NaN
eval page(900, 410)
set multiplot layout 1,2 margins 0.085,0.98,0.16,0.95 spacing 0.1
set xlabel "creepage w, times |dF/dw| at w = 0, over full sliding"
set ylabel "force over full sliding [1]"
set xrange [0:4]
set yrange [0:1.05]
set key bottom right
plot for [k=1:words(cases)] curves using "creepage":(of(k)) with lines linecolor rgb kernel_colour(k) title kernel_name(k)
set ylabel "the same less the half-space's [1]"
set yrange [*:*]
carter(x) = x < 2 ? x - x * x / 4 : 1
unset key
plot for [k=1:words(cases)] curves using "creepage":(of(k) - carter(column("creepage"))) with lines linecolor rgb kernel_colour(k)
unset multiplot
