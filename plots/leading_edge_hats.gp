# The trimmed hat ends at the leading edge, which the general hat of the last node reaches beyond (thesis Fig. 10.2).
hats = tables."/hats.tsv"
eval page(640, 280)
set multiplot layout 1,2 margins 0.12,0.98,0.22,0.86 spacing 0.12
set xrange [-1.5:1.5]
set yrange [0:1.1]
set xlabel "distance from the last node [dx]"
set ylabel "traction function [1]"
unset key
set title "general"
plot hats using "s":"general" with lines linecolor rgb colour_of("standard")
set title "trimmed at the leading edge"
plot hats using "s":"trimmed" with lines linecolor rgb colour_of("trimmed")
unset multiplot
