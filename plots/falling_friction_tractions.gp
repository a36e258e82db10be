# Tractions of a wheel whose friction falls with slip at once, after 4.9 mm by steps of three lengths, in the solutions with fast
# slip: peaks travel through the contact, and their places depend on the step. With a memory of 5 micrometres all steps
# have the same tractions. Grey: the bound at rest.
tractions = tables."/tractions.tsv"
ratios = by_awk(tractions, "!($at[\"step_ratio\"] in seen) { seen[$at[\"step_ratio\"]] = 1; printf(\"%s \", $at[\"step_ratio\"]) }'")
memories = by_awk(tractions, "!($at[\"memory\"] in seen) { seen[$at[\"memory\"]] = 1; printf(\"%s \", $at[\"memory\"]) }'")
longest = word(memories, words(memories))
of(memory, branch, c) = same(column("memory"), real(memory)) && strcol("branch") eq branch && same(column("step_ratio"), real(c)) ? column("x") : NaN

eval page(800, 420)
set multiplot layout 1,2 margins 0.105,0.98,0.155,0.9 spacing 0.115,0.1
set xlabel "position over the half-width, x/a [1]"
set ylabel "traction over {/Symbol m}p_0 [1]"
set xrange [-1:1]
set yrange [0:1.05]
set samples 400
set title "at once, fast slip"
set key bottom left
plot sqrt(1 - x**2) with lines linecolor "gray50" title "bound at rest", \
     for [k=1:words(ratios)] tractions using (of("0", "most", word(ratios, k))):"traction" with lines linetype k \
       title sprintf("c = %g", real(word(ratios, k)))
unset ylabel
set title sprintf("over %g {/Symbol m}m of slip", 1000*real(longest))
plot sqrt(1 - x**2) with lines linecolor "gray50" notitle, \
     for [k=1:words(ratios)] tractions using (of(longest, "least", word(ratios, k))):"traction" with lines linetype k dashtype k \
       notitle
unset multiplot
