# Bodies of different material slip in both directions within one contact: in free rolling the more the larger β/μ is
# (left), and under a force (right).
zones = tables."/zones.tsv"
place(of, wanted, zone) = strcol("of") eq of && column("zone") == wanted ? column("value") : NaN
eval page(900, 410)
set multiplot layout 1,2 margins 0.085,0.84,0.16,0.95 spacing 0.09
set ylabel "x/a [1]"
set yrange [-1:1]
set logscale x
set xrange [0.045:55]
set xlabel "β/μ, free rolling [1]"
unset grid
unset key
plot zones using (place("free", 0, 0)):"begin":(0):(column("end") - column("begin")) with vectors nohead linewidth 3 linecolor "#0072b2" notitle, \
     zones using (place("free", -1, 0)):"begin":(0):(column("end") - column("begin")) with vectors nohead linewidth 3 linecolor "#e69f00" notitle, \
     zones using (place("free", 1, 0)):"begin":(0):(column("end") - column("begin")) with vectors nohead linewidth 3 linecolor "#d55e00" notitle
unset logscale x
set xlabel "force over full sliding [1]"
set xrange [-1:1]
set ylabel ""
set key at screen 0.85, 0.93 left top Left reverse samplen 1
plot zones using (place("tractive", 0, 0)):"begin":(0):(column("end") - column("begin")) with vectors nohead linewidth 3 linecolor "#0072b2" notitle, \
     zones using (place("tractive", -1, 0)):"begin":(0):(column("end") - column("begin")) with vectors nohead linewidth 3 linecolor "#e69f00" notitle, \
     zones using (place("tractive", 1, 0)):"begin":(0):(column("end") - column("begin")) with vectors nohead linewidth 3 linecolor "#d55e00" notitle, \
     keyentry with lines linewidth 6 linecolor "#0072b2" title "sticks", \
     keyentry with lines linewidth 6 linecolor "#e69f00" title "slips, p < 0", \
     keyentry with lines linewidth 6 linecolor "#d55e00" title "slips, p > 0"
unset multiplot
