# A unit pulse keeps its shape for c = 1 only; smaller steps flatten it, and it sheds waves. Left after one step, right
# after a longer distance. Thesis Figs. 4.1 and 4.2.
pulse = tables."/pulse.tsv"
longest = 0.0
ratios = ""
set table $ratios
plot tables."/pulse_summary.tsv" using \
  (longest = column("distance") > longest ? column("distance") : longest, \
   ratios = strcol("basis") eq "constant" && column("distance") < 2 ? ratios.sprintf(" %g", column("step_ratio")) : ratios, 0) \
  with table
unset table
at(basis, c, long) = strcol("basis") eq basis && same(column("step_ratio"), real(c)) && \
  (column("distance") > 2) == long ? column("position") : NaN

eval page(860, 600)
set multiplot layout 2,2 margins 0.095,0.98,0.1,0.93 spacing 0.09,0.16
set ylabel "traction [1]"
do for [basis in "constant linear"] {
  set xrange [-6:3]
  set yrange [-0.15:1.1]
  set key top left
  set xlabel basis eq "linear" ? "distance from the start [dx], rolling to the right" : ""
  set title basis." functions, one step"
  plot for [i=1:words(ratios)] pulse using (at(basis, word(ratios, i), 0)):"traction" \
    with linespoints linetype i pointtype 7 pointsize 0.35 title "c = ".word(ratios, i)
  set xrange [-1.4*longest:-0.5*longest]
  set yrange [-0.2:0.45]
  unset key
  set arrow 1 from -longest, graph 0 to -longest, graph 1 nohead linecolor "gray60" dashtype 2
  set title sprintf("%s functions, after %g dx", basis, longest)
  plot for [i=1:words(ratios)] pulse using (at(basis, word(ratios, i), 1)):"traction" \
    with lines linetype i notitle
  unset arrow 1
}
unset multiplot
