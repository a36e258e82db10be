# The rougher the bound, the more stick zones there are (their number stands at the ends of the lines), and the more elements an
# accuracy takes. Error of the creepage under bounds that are rough at all scales.
rough = tables."/rough.tsv"
of(h, value) = same(column("hurst"), h) ? value : NaN
hursts = system(sprintf("awk -F'\\t' '!/^#/ && $1 + 0 > 0 {print $1}' \"%s\" | uniq", rough))
set logscale xy
set format y "10^{%T}"
set xlabel "number of elements N"
set ylabel "relative error of the creepage [1]"
unset key
set rmargin 18
set xrange [25:20000]
do for [i=1:words(hursts)] {
  last = system(sprintf("awk -F'\\t' '$1 == \"%s\" {e = $3} END {print e}' \"%s\"", word(hursts, i), rough)) + 0
  n = system(sprintf("awk -F'\\t' '$1 == \"%s\" {e = $2} END {print e}' \"%s\"", word(hursts, i), rough)) + 0
  zones = by_awk(rough, sprintf("$at[\"hurst\"] == \"%s\" { last = $at[\"zones\"] } END { print last }'", word(hursts, i)))
  set label i sprintf("  H = %g: %s", real(word(hursts, i)), zones) at n, shown(last) left textcolor rgb label_colour_of_line(i)
}
plot for [i=1:words(hursts)] rough using "elements":(of(real(word(hursts, i)), shown(column("creepage_error")))) \
         with linespoints linetype i pointtype 7 pointsize 0.6
