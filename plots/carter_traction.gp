# The smaller the step, the more the traction wiggles where the contact sticks. Above are the tractions of the
# Carter-Fromm problem, below their differences from the exact solution. Thesis Fig. 1.1.
traction = tables."/traction.tsv"
ratios = ""
set table $ratios
plot tables."/summary.tsv" using (ratios = ratios.sprintf(" %g", column("step_ratio")), 0) with table
unset table
at(c) = same(column("step_ratio"), real(c)) ? column("x") : NaN

eval page(640, 560)
set multiplot layout 2,1 margins 0.13,0.98,0.11,0.93 spacing 0.07
set xrange [-1:1]
set format x ""
set ylabel "traction p [N/mm^2]"
unset key
set label 1 "bound" at 0.75, -0.78 textcolor "gray40"
set label 2 "exact, black" at 0.1, -0.2 right
set title "Carter-Fromm problem: a small step c = dq/dx makes the traction wiggle"
plot traction using (at(word(ratios, 1))):(-column("bound")) with @bound_line title "bound -g", \
     for [i=1:words(ratios)] traction using (at(word(ratios, i))):"traction" \
       with linespoints linetype i pointtype 7 pointsize 0.25 notitle, \
     tables."/exact.tsv" using "x":"traction" with @exact_line title "exact (10.1)"
unset title
unset label
set format x
set xlabel "x [mm], rolling to the right"
set ylabel "p - exact [N/mm^2]"
set yrange [-0.36:0.15]
set key bottom left
plot for [i=1:words(ratios)] traction using (at(word(ratios, i))):(column("traction") - column("exact")) \
       with linespoints linetype i pointtype 7 pointsize 0.25 title "c = ".word(ratios, i)
unset multiplot
