# The inversion is exact where it finds the zones of stick. Elements that resolve the bound replace it under the noisy
# bound from half of full sliding on, and under bounds of more than 400 rows, in the last two panels. Calibrated elements
# are the better elements of a given number, except for gaps that are shorter than elements (last panel).
bounds = tables."/bounds.tsv"
of(scheme, kind) = sprintf("< awk -F'	' '/^#/ || !head++ || ($1 == \"%s\" && $2 == %d)' \"%s\"", scheme, kind, bounds)
# Where the labels stand.
heights = "6.0e-2 4.0e-6 1.0e-14"
names = "standard calibrated inversion"
titles = "'noisy, 30 %' 'finite at both edges' 'a jump' 'two stick zones' 'rough at all scales, 50 %' 'the same, 150 %'"

eval page(640, 860)
set logscale xy
set format "10^{%T}"
set xrange [5e-7:1.5]
set yrange [1e-16:10]
unset key
do for [i=1:words(names)] { set label i word(names, i) at 1e-6, real(word(heights, i)) textcolor rgb label_colour_of(word(names, i)) }
set multiplot layout 3,2 margins 0.13,0.97,0.07,0.965 spacing 0.1,0.09
do for [kind=1:6] {
  set title word(titles, kind) offset 0,-0.5
  set ylabel kind % 2 == 1 ? "error of the creepage" : ""
  if (kind == 6) {
    set label 1 "standard" at 1e-6, 2e-5
    set label 2 "calibrated" at 1e-6, 2
    set label 3 "inversion" at 1e-6, 2e-7
  }
  set xlabel kind > 4 ? "force over full sliding" : ""
  plot for [i=1:words(names)] of(word(names, i), kind) using "load":(column("error") == column("error") ? shown(column("error")) : NaN) with linespoints linecolor rgb colour_of(word(names, i)) pointtype 7 pointsize 0.5
}
unset multiplot
