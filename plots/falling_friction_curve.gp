# Force of steady rolling against the creepage, for some speeds of rolling, with friction that falls with the speed of slip: the
# faster the wheel, the earlier the force falls.
curve = tables."/curve.tsv"
speeds = by_awk(curve, "!($at[\"speed\"] in seen) { seen[$at[\"speed\"]] = 1; printf(\"%s \", $at[\"speed\"]) }'")
of(speed) = same(column("speed"), real(speed)) ? 100*column("creepage") : NaN
set xlabel "creepage [%]"
set ylabel "force over full sliding at rest [1]"
set yrange [0:1.05]
set key bottom right
plot for [k=1:words(speeds)] curve using (of(word(speeds, k))):"force_ratio" with linespoints linetype k pointsize 0.4 \
       title sprintf("%g m/s", real(word(speeds, k))/1000)
