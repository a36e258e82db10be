# A wheel rolls towards +x, so that material enters the contact at its leading edge, x = +a. Here the wheel brakes: it
# turns slower than it rolls, the creepage is positive, and the tractions and the force on the wheel are negative. Below,
# the contact is drawn larger than the wheel.
eval page(640, 590)
half_width = 1.
stick = 0.62  # half-length of the stick zone, of Carter's solution in plane strain
middle = half_width - stick
bound(x) = abs(x) < half_width ? sqrt(1 - x**2) : 0
relieved(x) = abs(x - middle) < stick ? stick * sqrt(1 - ((x - middle) / stick)**2) : 0
traction(x) = relieved(x) - bound(x)
blue = word(line_colours, 1)
red = word(line_colours, 2)
dark_red = label_colour(red)
unset grid
unset border
unset tics
unset key
set multiplot

# The wheel on the rail: 200 pixels for its radius of 1.
set lmargin at screen 0; set rmargin at screen 1; set bmargin at screen 310./590; set tmargin at screen 1
set xrange [-3.2:3.2]
set yrange [-1.35:1.45]
set size noratio
set object 1 circle at 0, 0 size 1 fillstyle solid 0.08 border linecolor "gray30" fillcolor rgb blue
set object 2 circle at 0, 0 size 0.03 fillstyle solid fillcolor "gray20"
set arrow 1 from -3, -1 to 3, -1 nohead linewidth 2 linecolor "gray30"
set label 1 "rail" at -2.95, -1.2 left textcolor "gray30"
set arrow 2 from 0, 0 to 1.75, 0 linewidth 2.5 linecolor rgb blue front
set label 2 "velocity v" at 1.85, 0 left textcolor rgb label_colour(blue)
set object 3 circle at 0, 0 size 0.55 arc [30:150] nowedge fillstyle empty border linecolor rgb blue linewidth 2.5
set arrow 3 from 0.55 * cos(0.75), 0.55 * sin(0.75) to 0.58 * cos(0.25), 0.58 * sin(0.25) linewidth 2.5 linecolor rgb blue front
set label 3 "ω" at 0, 0.72 center textcolor rgb label_colour(blue)
set arrow 4 from 0, 0 to -cos(0.9), -sin(0.9) linecolor "gray30" nohead
set label 4 "R" at -0.42, -0.28 right textcolor "gray20"
set arrow 5 from 0, -0.93 to -1.5, -0.93 linewidth 4 linecolor rgb red front
set label 5 "force F < 0" at -1.6, -0.8 right textcolor rgb dark_red
set label 6 "creepage" at 1.25, 1.25 left
set label 7 "w = (v - ωR)/v > 0" at 1.25, 1.0 left
set label 8 "rolling is towards +x" at -2.95, 1.25 left
set label 9 "the wheel brakes" at -2.95, 1.0 left
set arrow 6 from -0.16, -1.02 to -1.62, -1.35 nohead linecolor "gray60" dashtype 2
set arrow 7 from 0.16, -1.02 to 1.62, -1.35 nohead linecolor "gray60" dashtype 2
plot NaN notitle
unset object
unset arrow
unset label

# Its contact.
set tmargin at screen 310./590; set bmargin at screen 0
set xrange [-1.95:1.95]
set yrange [-1.25:1.75]
set samples 161
set label 1 "trailing edge" at -1, 1.22 center
set label 2 "x = -a" at -1, 1.46 center
set label 3 "leading edge" at 1, 1.22 center
set label 4 "x = +a" at 1, 1.46 center
set arrow 1 from -1, 1.08 to -1, -0.06 nohead linecolor "gray60"
set arrow 2 from 1, 1.08 to 1, -0.06 nohead linecolor "gray60"
set arrow 3 from -1.8, 0 to 1.6, 0 linecolor "gray20"
set label 5 "x" at 1.66, 0 left
set arrow 4 from 0.42, 1.22 to -0.42, 1.22 linecolor "gray40"
set label 6 "material" at 0, 1.42 center textcolor "gray30"
set label 7 "traction p < 0" at -1.08, -0.62 right textcolor rgb dark_red
set label 8 "bound ±g" at 1.06, 0.6 left textcolor "gray30"
set label 9 "slips" at -0.62, 0.14 center
set label 10 "sticks" at middle, 0.14 center
set arrow 10 from middle - stick, 0.3 to middle - stick, -0.06 nohead linecolor "gray60"
set label 11 "F = ∫ p dx" at 0.95, -0.62 left textcolor rgb dark_red
do for [k=0:6] {
  x = -0.85 + 0.25 * k
  set arrow 20 + k from x + 0.09, traction(x) / 2. to x - 0.09, traction(x) / 2. size screen 0.012, 20 filled linecolor rgb red front
}
# Places that are dense where a root begins: at the edges and at both ends of the stick zone.
place(t) = t < 0 ? -stick - (1 - stick) * cos(pi * (t + 1)) : middle - stick * cos(pi * t)
plot sample [-1:1] '+' using (place($1)):(traction(place($1))):(0) with filledcurves fillcolor rgb red fillstyle solid 0.15 noborder, \
     [-1:1] '+' using (place($1)):(traction(place($1))) with lines linecolor rgb red linewidth 2, \
     [-1:1] '+' using (-cos(pi * ($1 + 1) / 2)):(bound(-cos(pi * ($1 + 1) / 2))) with @bound_line, \
     [-1:1] '+' using (-cos(pi * ($1 + 1) / 2)):(-bound(-cos(pi * ($1 + 1) / 2))) with @bound_line
unset multiplot
