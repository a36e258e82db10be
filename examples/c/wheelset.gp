# The wheelset of wheelset.c in a curve: gnuplot -c wheelset.gp wheelset.tsv wheelset.svg
set terminal svg size 640,640 font ",12"
set output ARG2
set key autotitle columnhead noenhanced top right
set multiplot layout 2,1
set xlabel "time [s]"
set ylabel "y [mm]"
plot ARG1 using "t":"y" with lines linewidth 2 title "lateral displacement, to the left", \
     ARG1 using "t":(-750. * 460 * column("curvature") / 0.1) with lines dashtype 2 linecolor "black" title "pure rolling"
set key top right
set ylabel "force [N]"
plot for [name in "force_left force_right lateral_left lateral_right"] ARG1 using "t":name with lines linewidth 2 title name
unset multiplot
