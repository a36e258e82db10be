# The wider the strip, the fewer unknowns Chebyshev collocation needs for twelve digits of creepage and force (right).
# Left are the curves of creepage and force. Beyond twelve digits there is nothing but rounding.
curve = tables."/curve.tsv"
digits = tables."/digits.tsv"
widths = ""
set table $widths
plot digits using (w = sprintf(" %g", column("width")), widths = strstrt(widths." ", w." ") ? widths : widths.w, 0) with table
unset table
is(w) = sprintf("%g", column("width")) eq w
label(w) = w eq "inf" ? "plane strain" : "width ".w." a"

eval page(860, 400)
set multiplot layout 1,2 margins 0.09,0.98,0.14,0.96 spacing 0.1
set xlabel "creepage w [1]"
set ylabel "force over full sliding [1]"
set key bottom right
plot for [k=1:words(widths)] curve using (is(word(widths, k)) ? column("creepage") : NaN):(-column("force_ratio")) \
       with lines linetype k title label(word(widths, k))
set xlabel "unknowns [1]"
set ylabel "correct digits of creepage and force [1]"
set yrange [0:12.5]
plot for [k=1:words(widths)] digits using (is(word(widths, k)) ? column("unknowns") : NaN):(-log10(column("largest_error") > 1e-12 ? column("largest_error") : 1e-12)) \
       with linespoints linetype k pointtype 7 pointsize 0.5 title label(word(widths, k))
unset multiplot
