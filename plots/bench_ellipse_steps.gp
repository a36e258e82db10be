# Times of a step of a circle under both creepages and spin, where the same cells slip as before, and of a contact length
# from rest, in which they begin to slip. CONTACT's times are means over steps from rest.
load scripts."/bench.gpi"
set key maxrows 2
set xlabel "number of cells [1]"
set title "contact ellipse, steps of an element\n{/*0.8 ".machines."}"
named(text, quantity, method) = text.": ".power(quantity, "half_space", method)
plot peer using (of("ellipse_step", "half_space", "CONTACT")):"time" with linespoints linetype 7 pointtype 5 pointsize 0.6 title named("CONTACT", "ellipse_step", "CONTACT"), \
     times using (of("ellipse_step", "half_space", "direct")):"time" with linespoints linecolor rgb colour_of("direct") pointtype 7 pointsize 0.5 title named("direct", "ellipse_step", "direct"), \
     times using (of("ellipse_step", "half_space", "remembered")):"time" with linespoints linecolor rgb colour_of("remembered") pointtype 7 pointsize 0.5 title named("remembered", "ellipse_step", "remembered"), \
     times using (of("ellipse_rolling", "half_space", "remembered")):"time" with linespoints dashtype 2 linecolor rgb colour_of("remembered") pointtype 6 pointsize 0.6 title named("2 a, remembered", "ellipse_rolling", "remembered")
