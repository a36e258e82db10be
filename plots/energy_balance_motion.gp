# A cylinder that starts to roll swings on its contact: the distance from one swing of the force to the next grows with
# the velocity, a little less than mass and stiffness predict (below). Above, velocity and rotation. Thesis chapter 9.
motion = tables."/motion.tsv"
slope_force = parameter(motion, "cylinder.slope_force")
inertia = parameter(motion, "cylinder.inertia") / parameter(motion, "cylinder.radius")**2
steady = -slope_force * inertia / (inertia + parameter(motion, "cylinder.mass"))
# From each extreme of the force to the next but one, and the place between them.
swings = by_awk(motion, "{ f = $at[\"force\"]; if (NR > 3 && (f - last) * (last - before) < 0) { x[++n] = $at[\"X\"]; \
  if (n > 2) print (x[n] + x[n-2]) / 2, x[n] - x[n-2] } before = last; last = f }'")
set print $swings
do for [k=1:words(swings):2] { print word(swings, k)."\t".word(swings, k + 1) }
set print

eval page(640, 720)
set multiplot layout 3,1 margins 0.13,0.97,0.08,0.98 spacing 0.03
unset key
set xrange [0:last_value(motion, "1", "X")]
set format x ""
set yrange [0:*]
set ylabel "velocity [mm/s]"
set label 1 "v" at graph 0.4, graph 0.77 textcolor rgb label_colour_of_line(1)
set label 2 "ωR" at graph 0.4, graph 0.44 textcolor rgb label_colour_of_line(2)
plot motion using "X":"v" with lines linetype 1, \
     motion using "X":"omega_R" with lines linetype 2
unset label
set yrange [*:0]
set ylabel "force F [N/mm]"
set label 1 "steady rolling" at graph 0.97, first steady offset 0,-0.7 right textcolor "gray40"
plot steady with lines linecolor "gray60" dashtype 2, \
     motion using "X":"force" with lines linetype 3
unset label
set format x
set yrange [0:*]
set xlabel "distance rolled X [mm]; the contact is 2 mm wide"
set ylabel "wavelength [mm]"
set label 1 "predicted: v times the period 2π(m'/k)^{1/2}" at graph 0.97, graph 0.3 right textcolor "gray40"
set label 2 "measured from swing to swing of the force" at graph 0.97, graph 0.17 right textcolor rgb label_colour_of_line(3)
plot motion using "X":"predicted_wavelength" with lines linecolor "gray50" dashtype 2, \
     $swings using 1:2 with points linetype 3 pointtype 7 pointsize 0.9
unset multiplot
