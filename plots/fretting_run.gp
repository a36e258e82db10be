# Dissipated and stored energy add up to the work of the force at every moment of a run that stands still, rolls and
# stands still again (right). Left, the force over the displacement, by the remembered scheme.
run = tables."/run.tsv"
stage(k) = column("stage") == k ? column("displacement") : NaN
names = '"cycle at standstill" "rolling" "cycle at standstill" "rolling" "back to no force"'
kinds = "1 2 3 5 4"

eval page(860, 420)
set multiplot layout 1,2 margins 0.09,0.98,0.14,0.9 spacing 0.12
set xlabel "displacement [mm]"
set ylabel "force / full sliding [1]"
set title "force on the way"
set key bottom right
plot for [k=1:5] run using (stage(k)):"force" with linespoints linetype (word(kinds, k) + 0) pointtype 7 pointsize 0.3 title word(names, k)
set xlabel "row of the table, as time goes by [1]"
set ylabel "energy since the start [N]"
set title "energy"
set key top right
set yrange [0:3.1]
plot run using 0:"work" with lines linetype 1 linewidth 2.5 title "work of the force", \
     run using 0:"dissipated" with lines linetype 2 title "dissipated", \
     run using 0:"stored" with lines linetype 3 title "stored", \
     run using 0:(column("dissipated") + column("stored")) with lines linetype 7 dashtype 2 title "dissipated and stored"
unset multiplot
