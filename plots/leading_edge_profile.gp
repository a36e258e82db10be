# With the displacement at the edge known the tractions meet the exact ones (left); with the last hat trimmed they do
# not (right). The Carter-Fromm problem near the leading edge, thesis Figs. 10.1 and 10.3.
profile = tables."/profile.tsv"
offset = 0.0
set table $offset
plot profile using (same(column("leading_offset"), 0.5) ? 0 : (offset = column("leading_offset"))) with table
unset table
of(name, leading) = strcol("scheme") eq name && same(column("leading_offset"), leading) ? column("x") : NaN

eval page(800, 400)
set multiplot layout 1,2 margins 0.105,0.98,0.16,0.9 spacing 0.12
# The stick zone and a part of the slip zone.
half_width = parameter(profile, "contact.half_width")
set xrange [half_width * (0.9 - 2 * parameter(profile, "profile.stick_ratio")):half_width]
set yrange [*:0]
set xlabel "x [mm], rolling to the right"
set ylabel "traction p [N/mm^2]"
set key bottom right
set title "displacement at the edge known, δ₊ = 0.5"
plot tables."/exact.tsv" using "x":"traction" with @exact_line title "exact (10.1)", \
     profile using (of("standard constant", 0.5)):"traction" with linespoints linecolor rgb colour_of("standard") pointtype 6 pointsize 0.5 title "standard", \
     profile using (of("known edge constant", 0.5)):"traction" with linespoints linecolor rgb colour_of("known_edge") pointtype 7 pointsize 0.4 title "displacement known"
set title sprintf("last hat trimmed, δ₊ = %g", offset)
plot tables."/exact.tsv" using "x":"traction" with @exact_line title "exact (10.1)", \
     profile using (of("standard linear", offset)):"traction" with linespoints linecolor rgb colour_of("standard") pointtype 6 pointsize 0.5 title "standard", \
     profile using (of("trimmed linear", offset)):"traction" with linespoints linecolor rgb colour_of("trimmed") pointtype 7 pointsize 0.4 title "trimmed"
unset multiplot
