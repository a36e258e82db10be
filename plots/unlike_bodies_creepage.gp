# Bodies of different material creep without a force (left), the more the larger β/μ is (left and right).
free = tables."/free.tsv"
tractive = tables."/tractive.tsv"
ratios = system(sprintf("grep -v '^#' \"%s\" | tail -n +2 | cut -f1 | uniq", tractive))
of(k) = same(column("ratio"), word(ratios, k) + 0) ? column("creepage") : NaN
eval page(900, 410)
set multiplot layout 1,2 margins 0.1,0.98,0.16,0.95 spacing 0.12
set logscale x
set xlabel "β/μ [1]" offset 0,0.2
set ylabel "w over βa/R, free rolling [1]"
set yrange [0.6:0.95]
unset key
set label "no slip: 2/π" at graph 0.6, first 0.6366 offset 0,-0.7
set label "no friction: 0.9148" at graph 0.03, first 0.9148 offset 0,0.6
plot free using "ratio":(2 / pi) with lines linecolor "gray60" dashtype 2, \
     free using "ratio":(0.914771) with lines linecolor "gray60" dashtype 2, \
     free using "ratio":"creepage" with lines linetype 1
unset label
unset logscale x
set xlabel "force over full sliding [1]"
set ylabel "w over μa/R [1]"
set xrange [-1:1]
set yrange [*:*]
set key at graph 0.06, 0.78 left top Left reverse
plot tractive using "force_ratio":(of(1) == of(1) ? column("alike") : NaN) with lines linecolor "gray40" dashtype 3 title "one material (Carter)", \
     for [k=1:words(ratios)] tractive using "force_ratio":(of(k)) with lines linetype k title sprintf("β/μ = %.3g", word(ratios, k) + 0)
unset multiplot
