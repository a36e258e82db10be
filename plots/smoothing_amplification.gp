# A step that is not as long as an element damps short waves (above), and most such steps carry them with a wrong speed
# (below): so travelling peaks become smooth.
amplification = tables."/amplification.tsv"
ratios = ""
set table $ratios
plot tables."/pulse_summary.tsv" using \
  (ratios = strcol("basis") eq "constant" && column("distance") < 2 ? ratios.sprintf(" %g", column("step_ratio")) : ratios, 0) \
  with table
unset table
at(basis, c) = strcol("basis") eq basis && same(column("step_ratio"), real(c)) ? column("frequency") : NaN

eval page(860, 600)
set multiplot layout 2,2 margins 0.09,0.98,0.1,0.93 spacing 0.09,0.11
set xrange [0:1]
do for [quantity in "damping speed"] {
  do for [basis in "constant linear"] {
    set ylabel quantity eq "damping" ? "damping |g|^{1/c}  per dx [1]" : "speed arg g / (cθ) [1]"
    set yrange [0:(quantity eq "damping" ? 1.05 : 1.35)]
    set xlabel quantity eq "speed" ? "frequency θ/π; 1: node to node" : ""
    set title quantity eq "damping" ? basis." functions" : ""
    if (quantity eq "damping" && basis eq "constant") { set key bottom left } else { unset key }
    plot for [i=1:words(ratios)] amplification using (at(basis, word(ratios, i))):(column(quantity)) \
      with lines linetype i title "c = ".word(ratios, i)
  }
}
unset multiplot
