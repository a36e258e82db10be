# The mean force of runs against the length of the memory of friction, for steps of several lengths. Right of the grey line
# steady rolling is stable by linear theory: forces there do not depend on the step. At the left they do, and in some runs a
# step has no solution; these have no point.
runs = tables."/runs.tsv"
limits = tables."/limits.tsv"
ratios = by_awk(runs, "!($at[\"step_ratio\"] in seen) { seen[$at[\"step_ratio\"]] = 1; printf(\"%s \", $at[\"step_ratio\"]) }'")
of(c) = strcol("branch") eq "least" && same(column("step_ratio"), real(c)) ? 1000*column("memory") : NaN
critical = by_awk(limits, "$at[\"memory\"] > 0 { if ($at[\"load\"] < 1 && before > 1) { slope = ($at[\"limit\"] - limit) / ($at[\"memory\"] - last); print 1000 * (limit - slope * last) / (1 - slope) } before = $at[\"load\"]; last = $at[\"memory\"]; limit = $at[\"limit\"] }'")

set datafile missing NaN
set xlabel "length of the memory of friction [{/Symbol m}m]"
set ylabel "mean force over full sliding at rest [1]"
set key bottom right
if (strlen(critical)) set arrow 1 from real(critical), graph 0 to real(critical), graph 1 nohead linecolor "gray50"
plot for [k=1:words(ratios)] runs using (of(word(ratios, k))):"mean_ratio" with linespoints linetype k \
       title sprintf("c = %g", real(word(ratios, k)))
