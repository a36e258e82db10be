# Thesis chapter 9: a cylinder that starts to roll swings on its contact, until velocity, rotation and traction
# settle.
motion = tables."/motion.tsv"
eval page(700, 560)
set multiplot layout 2,1 margins 0.125,0.89,0.11,0.95 spacing 0.05
set format x ""
set ylabel "velocity [mm/s]"
set key bottom right
plot motion using "X":"v" with lines linetype 1 title "v", \
     motion using "X":"omega_R" with lines linetype 2 title "ωR"
set format x
set xlabel "distance rolled X [mm]; the contact is 2 mm wide"
set ylabel "force F [N/mm]"
set y2label "v times the period 2π(m'/k)^{1/2} [mm]"
set ytics nomirror
set y2tics
set y2range [0:*]
set key bottom right
plot motion using "X":"force" with lines linetype 3 title "force of the contact", \
     motion using "X":"predicted_wavelength" axes x1y2 with lines linetype 4 dashtype 2 title "predicted wavelength, right axis"
unset multiplot
