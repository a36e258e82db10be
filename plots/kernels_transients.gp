# How long does a contact remember a shift? The creepage under a force swings about the steady one. C_a = 2 (1 - nu) a/G.
transients = tables."/transients.tsv"
slopes = tables."/slopes.tsv"
cases = system(sprintf("grep -v '^#' \"%s\" | tail -n +2 | cut -f2", slopes))
titled(k) = word(cases, k) eq "inf" ? "springs alone (brush)" : word(cases, k) + 0 == 0 ? "half-space" : sprintf("layer, C/C_a = %.3g", word(cases, k) + 0)
of(k) = strcol("softness") eq word(cases, k) ? column("creepage") : NaN
set xlabel "distance rolled over the contact's width [1]"
set ylabel "creepage over that of steady rolling [1]"
set xrange [0:2]
set key bottom right
plot for [k=1:words(cases)] transients using "distance":(of(k)) with lines linetype k title titled(k)
