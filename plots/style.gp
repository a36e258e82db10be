# Style of every figure: half a page wide, colour-blind safe (Okabe and Ito), columns by name.
# draw.sh defines `tables`, the folder of the study's tables, `scripts`, the folder of this file, and `format`.
# The command that sets the size of a figure, in pixels of 1/96 inch; pixels of a PNG are a third, and those of
# a GIF four fifths. A phone shows a figure,
# or each of its panels side by side, 390 pixels wide: a panel wider than 640 pixels has texts of less than 8 there.
page(width, height) = format eq "png" ? \
    sprintf("set terminal pngcairo size %d,%d enhanced font 'Helvetica,10.5' background 'white' ", 3 * width, 3 * height) . \
    "fontscale 3 linewidth 3.9 pointscale 3" : format eq "pdf" ? \
    sprintf("set terminal pdfcairo size %.4fin,%.4fin enhanced font 'Helvetica,7.9' background 'white' ", \
            width / 96., height / 96.) . "fontscale 1 linewidth 2" : format eq "gif" ? \
    sprintf("set terminal gif animate delay %d loop 0 size %d,%d enhanced font 'Sans,13' background 'white' ", \
            exists("delay") ? delay : 50, 1.25 * width, 1.25 * height) . "linewidth 1.6" : \
    sprintf("set terminal svg size %d,%d enhanced font 'Helvetica,14' background 'white' linewidth 1.3", width, height)
eval page(640, 420)
set datafile separator tab
set datafile missing "nan"
set encoding utf8
set border 3 linecolor "gray30"
set tics nomirror out scale 0.6
set xtics offset 0,0.25
set title offset 0,-0.4
set grid linecolor "gray85" linewidth 0.6
set xlabel offset 0,0.75
set ylabel offset (format eq "svg" ? 0.9 : 0),0
set key samplen 2.2 spacing 1.15

line_colours = "#0072b2 #d55e00 #009e73 #cc79a7 #e69f00 #56b4e9 #000000"
do for [k=1:7] { set linetype k linecolor rgb word(line_colours, k) }
set linetype cycle 7
# A scheme has the same colour in every figure: vermilion the thesis's and CONTACT's, blue what feels the edges where
# they are, on the grid of the contact or of the material. The first colour is of all others.
colours = "'#000000' \
  standard #d55e00 'standard linear' #8c3a00 'standard quadratic' #f4a582 known_edge #009e73 trimmed #8a8a2b \
  calibrated #0072b2 aligned #56b4e9 inversion #cc79a7 chebyshev #7a4fa3 \
  direct #d55e00 remembered #0072b2 relaxed #009e73 relaxed_traction #8a6d00 fractional #cc79a7 springs #e69f00 \
  'direct verlet' #d55e00 'direct midpoint' #cc79a7 'remembered verlet' #0072b2 'remembered midpoint' #009e73 \
  at_node #cc79a7 cell_mean #009e73 cut #8a8a2b \
  table #009e73 usetab #8a8a2b fastsim_three #7a4fa3 fastsim_one #cc79a7 vermeulen_johnson #e69f00 polach #8c3a00 \
  contact #d55e00 few #0072b2"
colour_of(scheme) = word(colours, 1 + int(sum [i=1:words(colours)] (word(colours, i) eq scheme ? i : 0)))

# Texts beside a line have its hue, and a contrast on white of at least 4.5, where the line is paler: its luminance
# (of WCAG 2) falls to 0.178.
channel(colour, k) = (16 * (strstrt("0123456789abcdef", colour[2*k:2*k]) - 1) + strstrt("0123456789abcdef", colour[2*k+1:2*k+1]) - 1) / 255.
of_light(c) = c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055)**2.4
of_screen(l) = l <= 0.00304 ? 12.92 * l : 1.055 * l**(1 / 2.4) - 0.055
luminance(colour) = 0.2126 * of_light(channel(colour, 1)) + 0.7152 * of_light(channel(colour, 2)) + 0.0722 * of_light(channel(colour, 3))
dimmed(colour, k, part) = int(255 * of_screen(part * of_light(channel(colour, k))))
label_colour(colour) = luminance(colour) <= 0.178 ? colour : (part = 0.178 / luminance(colour), \
  sprintf("#%02x%02x%02x", dimmed(colour, 1, part), dimmed(colour, 2, part), dimmed(colour, 3, part)))
label_colour_of(scheme) = label_colour(colour_of(scheme))
label_colour_of_line(k) = label_colour(word(line_colours, 1 + (k - 1) % 7))

exact_line = "lines linecolor 'black' linewidth 1.2"
bound_line = "lines linecolor 'gray60' linewidth 1 dashtype 2"

# A number in the comment of a table; gnuplot reads no 1e-4 without a point.
parameter(table, key) = real(system(sprintf("sed -n 's/^#   %s = //p' \"%s\" | sed 's/^\\(-*[0-9]*\\)e/\\1.0e/'", key, table)))

# The output of awk, given a table without its comments; at["NAME"] is the number of a column.
by_awk(table, actions) = system(sprintf("grep -v '^#' \"%s\" | awk -F'\t' 'NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next } %s", table, actions))

# The last value of a column, of the rows for which a condition of awk holds; for a label at the end of a line.
last_value(table, condition, name) = real(by_awk(table, sprintf("%s { last = sprintf(\"%%.9e\", $at[\"%s\"]) } END { print last }'", condition, name)))

# Values that differ by less than rounding of a printed number.
same(a, b) = abs(a - b) <= 1e-9 * abs(b)

# On logarithmic axes, what is nothing but rounding.
shown(error) = error < 1e-16 ? 1e-16 : error

# These are the visible ranges of the horizontal axis and of the axis of a history, and a name; draw.sh may have set them.
if (!exists("x_range")) x_range = "[*:*]"
if (!exists("x_label")) x_label = "x [mm], rolling to the right"
if (!exists("history_range")) history_range = "[*:*]"
