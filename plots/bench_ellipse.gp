# Times of a circle under both creepages and spin: its response, the first solution, and a solution from a neighbour's. With
# 100 cells the first one takes a tenth of the time that CONTACT takes with 316.
load scripts."/bench.gpi"
set key maxrows 2
set xlabel "number of cells [1]"
set title "contact ellipse, steady rolling\n{/*0.8 ".machines."}"
named(text, quantity, method) = text.": ".power(quantity, "half_space", method)
plot peer using (of("ellipse_first", "half_space", "CONTACT")):"time" with linespoints linetype 7 pointtype 5 pointsize 0.6 title named("CONTACT", "ellipse_first", "CONTACT"), \
     times using (of("ellipse_response", "half_space", "joined")):"time" with linespoints linecolor rgb colour_of("known_edge") pointtype 7 pointsize 0.5 title named("response", "ellipse_response", "joined"), \
     times using (of("ellipse_first", "half_space", "joined")):"time" with linespoints linecolor rgb colour_of("calibrated") pointtype 7 pointsize 0.5 title named("first solution", "ellipse_first", "joined"), \
     times using (of("ellipse_neighbour", "half_space", "joined")):"time" with linespoints linecolor rgb colour_of("aligned") pointtype 7 pointsize 0.5 title named("from a neighbour", "ellipse_neighbour", "joined")
