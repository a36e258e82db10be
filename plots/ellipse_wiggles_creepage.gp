# Creepage of a circle that keeps the force of its shift, 0.6 of full sliding, in the middle of each step: small steps of
# the standard scheme are off by a tenth, and under-relaxed ones by a twentieth; what remembers has the same creepage for all
# steps, with jumps as the peak of the traction leaves the adhesion zone row by row.
creepages = tables."/creepages.tsv"
of(scheme, c) = strcol("scheme") eq scheme && (c eq "" || same(column("step_ratio"), real(c))) ? column("q") : NaN
names = "direct relaxed remembered"
labels = "standard under-relaxed remembered"
ratios = "1 0.1"
set xlabel "distance rolled over the half-width, q/a [1]"
set ylabel "creepage [1]"
set xrange [0:3]
set yrange [0.02:0.065]
set key bottom right
plot for [s=1:3] for [k=(s == 2 ? 2 : 1):2] creepages using (of(word(names, s), word(ratios, k))):"creepage" with lines \
       linecolor rgb colour_of(word(names, s)) dashtype k \
       title word(labels, s).", c = ".word(ratios, k), \
     creepages using (of("reference", "")):"creepage" with @exact_line title "reference"
