# As c falls, the eigenvalues of B/c move to the imaginary axis (thesis, introduction).
eigenvalues = tables."/eigenvalues.tsv"
of(name, c) = strcol("basis") eq name && same(column("step_ratio"), c) ? column("real") : NaN
ratios = "1 0.1 0.01"

eval page(800, 400)
set multiplot layout 1,2 margins 0.105,0.98,0.16,0.9 spacing 0.09
set xlabel "real part of λ/c [2(1-ν)dx/G]"
set ylabel "imaginary part of λ/c [2(1-ν)dx/G]"
set xrange [-0.05:1.3]
set yrange [-1.2:1.2]
set key top right
do for [name in "constant linear"] {
  set title "eigenvalues of B/c, ".name." functions"
  plot for [i=1:3] eigenvalues using (of(name, real(word(ratios, i)))):"imaginary" \
         with points linetype i pointtype 7 pointsize 0.4 title "c = ".word(ratios, i)
}
unset multiplot
