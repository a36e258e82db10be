# The quarter of a wagon of quarter_vehicle.c: gnuplot -c quarter_vehicle.gp quarter_vehicle.tsv tractions.tsv quarter_vehicle.svg
set terminal svg size 640,820 font ",12" background "white"
set output ARG3
set datafile separator tab
set encoding utf8
maps = 4
stats ARG2 using (column("bound")) nooutput
peak = STATS_max
stats ARG2 using (column("x")) nooutput
wide = 1.35 * STATS_max
stats ARG2 using (column("y")) nooutput
high = 1.25 * STATS_max
# The colour of a cell: |p| over its bound; what slips is beyond 1.
of_bound(x, y, g, slips) = slips > 0 ? 1.2 : sqrt(x**2 + y**2) / g
array time[maps]
do for [k=1:maps] {
  stats ARG2 using (column("t")) every :::k - 1::k - 1 nooutput
  time[k] = STATS_max
}
stats ARG1 using (column("q")) nooutput
most = STATS_max
set multiplot
set lmargin at screen 0.12
set rmargin at screen 0.97
set grid linecolor "gray85"
set tmargin at screen 0.98
set bmargin at screen 0.81
set ylabel "speed [mm/s]"
set xrange [0:0.905]
plot ARG1 using "t":"v" with lines linewidth 2 title "of the body", \
     ARG1 using "t":(460 * column("turning")) with lines linewidth 2 dashtype 2 title "of the wheel's tread in the brake"
set tmargin at screen 0.77
set bmargin at screen 0.60
set ylabel "force [kN]"
set key top right
set yrange [-10.5:9.5]
plot ARG1 using "t":(column("force") / 1000) with lines linewidth 2 title "on the wheel", \
     ARG1 using "t":(-column("brake") / 460000) with lines linewidth 1.5 dashtype 2 title "of the brake, at the tread"
set tmargin at screen 0.56
set bmargin at screen 0.37
set xrange [0.735:0.905]
set yrange [-1.7:0.6]
set xlabel "time [s]"
set ylabel "way [mm]"
set key top right
shifted = 0
plot ARG1 using "t":(column("q") - most) with lines linewidth 2 title "that the contact has rolled, less the largest", \
     ARG1 using "t":(shifted = column("t") < 0.735 ? 0 : shifted + 100 * column("shift")) with lines linewidth 2 title "100 times the shift"
unset key
set xlabel "x [mm]"
set size ratio -1
set xrange [-wide:wide]
set yrange [-high:high]
set palette defined (0 "#ffffff", 0.8333 "#3b82b8", 0.8334 "#e69f00", 1 "#e69f00")
set cbrange [0:1.2]
unset colorbox
unset grid
set xtics 5
set label 1 "blue sticks, the darker the nearer to the bound; orange slips" at screen 0.54, 0.245 center
do for [k=0:maps - 1] {
  set tmargin at screen 0.21
  set bmargin at screen 0.06
  set lmargin at screen 0.08 + 0.23 * k
  set rmargin at screen 0.28 + 0.23 * k
  set ylabel k == 0 ? "y [mm]" : ""
  set format y k == 0 ? "%g" : ""
  set title sprintf("t = %.4f s", time[k + 1]) offset 0,-0.5
  plot ARG2 using "x":"y":(of_bound(column("traction_x"), column("traction_y"), column("bound"), column("slips"))) \
         every :::k::k with points pointtype 7 pointsize 1.2 linecolor palette, \
       ARG2 using "x":"y":(4 * column("traction_x") / peak):(4 * column("traction_y") / peak) every :::k::k \
         with vectors head filled size screen 0.006, 20 linecolor "black"
  unset label 1
}
unset multiplot
