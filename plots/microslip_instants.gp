# Tractions at instants of a run, one panel an instant, or one after the other in an animation. A contact sticks where it is
# blue, and slips where it is orange. In a map, blue is the darker the nearer tractions are to their bound, and arrows are
# tractions. All have the same scales.
load scripts."/microslip_margins.gpi"
panels_table = tables."/panels.tsv"
given(key) = parameter(panels_table, key)
is_map = int(given("map")); animated = int(given("animated")); instants = int(given("instants")); turns = int(given("turns"))
left_end = given("left"); right_end = given("right"); low_end = given("low"); high_end = given("high")
bound = given("bound")
stats panels_table using (column("panel")) nooutput
panels = int(STATS_records)
array titles[panels]
array touches[panels]
stats panels_table using (k = int($0) + 1, titles[k] = strcol("title"), touches[k] = int(column("contact")), 0) nooutput
if (turns) { x_label = "x [mm]" }

# Sizes in pixels. A map has room for its contact in both directions, with equal scales.
longest_title = 0
do for [k=1:panels] { longest_title = strlen(titles[k]) > longest_title ? strlen(titles[k]) : longest_title }
columns = animated || panels == 1 ? 1 : panels == 2 || panels == 4 || longest_title > 19 ? 2 : 3
rows = animated ? 1 : (panels + columns - 1) / columns
left_margin = 84.
right_margin = 16.
gap = 16.
above = 28.  # the title
panel_width = (640 - left_margin - right_margin - (columns - 1) * gap) / columns
wide = 1.08 * (right_end - left_end) / 2
high = is_map ? 1.08 * (high_end - low_end) / 2 : 1.08 * bound
fitting = is_map ? panel_width * high / wide : 0.72 * panel_width
most = columns == 1 ? 400. : 280.
least = columns == 1 ? 160. : 70.
panel_height = fitting > most ? most : fitting < least ? least : fitting
if (is_map && fitting > most) { wide = high * panel_width / panel_height }
if (is_map && fitting < least) { high = wide * panel_height / panel_width }
x_middle = (left_end + right_end) / 2
y_middle = is_map ? (low_end + high_end) / 2 : 0
entries = 3
entry_label(i) = i == 1 ? "bound ±g" : i == 2 ? "sticks" : "slips"
entry_colour(i) = i == 1 ? "#999999" : i == 2 ? "#0072b2" : "#e69f00"
entry_dash(i) = i == 1 ? 2 : 1
entry_width(i) = i == 1 ? 1 : 1.8
eval key_height
top = is_map ? 42. : 30.
some = panels < instants ? sprintf("%d of %d instants", panels, instants) : ""
height = top + rows * (above + panel_height) + (rows - 1) * 12 + 58 + (strlen(some) ? 20 : 0)
eval page(640, height)
panel_left(k) = left_margin + ((k - 1) % columns) * (panel_width + gap)
panel_top(k) = top + above + ((k - 1) / columns) * (above + panel_height + 12)
place = "set lmargin at screen panel_left(p) / 640; set rmargin at screen (panel_left(p) + panel_width) / 640; \
  eval area(panel_top(p), panel_top(p) + panel_height)"
file_of(kind, k) = sprintf("%s/%s_%d.tsv", tables, kind, k)
set palette defined (0 "#ffffff", 0.8333 "#3b82b8", 0.8334 "#e69f00", 1 "#e69f00")
set cbrange [0:1.2]
set view map
set pm3d corners2color c1
set xrange [x_middle - wide:x_middle + wide]
set yrange [y_middle - high:y_middle + high]
set xtics autofreq
set ytics autofreq
spacing(range, most_tics) = (rough = range / most_tics, ten = 10**floor(log10(rough)), rough <= ten ? ten : rough <= 2 * ten ? 2 * ten : rough <= 5 * ten ? 5 * ten : 10 * ten)
# The distance of numbers, of which there are two at least.
spaced(half, most) = (step = spacing(2 * half, most), step > half ? step / 2 : step)
set xtics spaced(wide, panel_width / 45)
set ytics spaced(high, panel_height / (animated ? 40 : 28))
if (is_map) { set border 15; unset grid }
do for [frame=1:animated ? panels : 1] {
  set multiplot
  do for [p=1:animated ? 1 : panels] {
    k = animated ? frame : p
    eval place
    unset label
    unset arrow
    unset key
    unset colorbox
    set title titles[k] noenhanced offset 0, -0.5
    set format x (animated || p + columns > panels ? "%g" : "")
    set format y ((p - 1) % columns ? "" : "%g")
    if (p == 1) {
      set label 1 (is_map ? "y [mm]" : "traction p [N/mm^2]") at screen 16. / 640, screen 0.5 + (58. - top - above) / 2 / height rotate by 90 center
      set label 2 x_label at screen (640 + left_margin - right_margin) / 2 / 640, screen (strlen(some) ? 32. : 14.) / height center
      if (strlen(some)) { set label 3 some at screen (640 + left_margin - right_margin) / 2 / 640, screen 12. / height center }
      if (is_map) {
        set label 4 "sticks, |p|/g" at screen 0.12, screen 1 - 13. / height left
        set label 5 "slips" at screen 0.60, screen 1 - 13. / height left
        set colorbox user horizontal origin screen 0.30, screen 1 - 18. / height size screen 0.28, screen 10. / height
        set cbtics ("0" 0, "0.5" 0.5, "1" 1) offset 0, 0.4 scale 0
      } else {
        eval draw_key
      }
    }
    if (!touches[k]) { set label 6 "no contact" at graph 0.5, graph 0.5 center }
    if (touches[k] && is_map) {
      splot file_of("cells", k) using 1:2:(0):3 with pm3d, \
            file_of("outline", k) using 1:2:(0) with lines linecolor "gray40" linewidth 0.8, \
            file_of("arrows", k) using 1:2:(0):3:4:(0) with vectors head filled size screen (animated ? 0.01 : 0.006), 20 linecolor rgb "black" linewidth (animated ? 1.1 : 0.8)
    } else { if (touches[k]) {
      plot file_of("line", k) using "x":"bound" with @bound_line, \
           file_of("line", k) using "x":(-column("bound")) with @bound_line, \
           file_of("line", k) using "x":"traction":(column("slips") > 0 ? 0xe69f00 : 0x0072b2) with lines linecolor rgb variable linewidth 1.8
    } else {
      plot 2 * high + y_middle with lines
    } }
  }
  unset multiplot
}
