# After a shift the creepage under a force swings about its steady value on each kernel, the further and longer the
# softer the layer is. C is the compliance of the layer, C_a = 2 (1 - nu) a/G.
transients = tables."/transients.tsv"
load scripts."/kernels.gpi"
of(k) = strcol("softness") eq softness(k) ? column("creepage") : NaN
set xlabel "distance rolled over the contact's width [1]"
set ylabel "creepage over the steady creepage [1]"
set xrange [0:2]
set key bottom right
plot for [k=1:words(cases)] transients using "distance":(of(k)) with lines linecolor rgb kernel_colour(k) title kernel_name(k)
