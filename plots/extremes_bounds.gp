# Steady rolling under bounds that are not smooth, from small forces to full sliding.
bounds = tables."/bounds.tsv"
of(name, kind) = strcol("scheme") eq name && column("bound") == kind && column("error") == column("error") ? column("load") : NaN
names = "standard calibrated inversion"
titles = "'rough, 30 %' 'finite at both edges' 'a jump' 'two stick zones'"

eval page(900, 720)
set logscale xy
set format "10^{%T}"
set xrange [5e-7:1.5]
set yrange [1e-16:2]
set multiplot layout 2,2 margins 0.1,0.86,0.09,0.95 spacing 0.08,0.13
do for [kind=1:4] {
  set title word(titles, kind) offset 0,-0.5
  set ylabel kind % 2 == 1 ? "error of the creepage [1]" : ""
  set xlabel kind > 2 ? "force over full sliding [1]" : ""
  if (kind == 2) { set key at graph 1.05, 0.95 left top Left reverse samplen 1 } else { unset key }
  plot for [i=1:words(names)] bounds using (of(word(names, i), kind)):(column("error") > 1e-16 ? column("error") : 1e-16) with linespoints linetype i pointtype 7 pointsize 0.5 title word(names, i)
}
unset multiplot
