# For many unknowns GMRES and Gohberg-Semencul solve a Toeplitz system far faster than LU, and known columns make each
# further solve cheaper still. One system with influence coefficients, from scratch (drawn) and with what is known of
# its matrix (dashed).
load scripts."/bench.gpi"
eval page(980, 600)
set multiplot layout 1,2 margins 0.08,0.98,0.36,0.84 spacing 0.09 title "solve of one Toeplitz system, strip\n{/*0.8 one core of ".processor."}"
set key maxrows 5
named(text, quantity, method) = text.": ".power(quantity, "strip", method)
do for [quantity in "solve_plain solve_difference"] {
  set title quantity eq "solve_plain" ? "A, symmetric" : "A - A', c = 1, not symmetric"
  plot times using (of(quantity, "strip", "lu")):"time" with linespoints linetype 7 pointtype 5 pointsize 0.5 \
         title named("LU", quantity, "lu"), \
       times using (of(quantity, "strip", "gmres_circulant")):"time" with linespoints linetype 2 pointtype 7 pointsize 0.5 \
         title named("GMRES, circulant", quantity, "gmres_circulant"), \
       times using (of(quantity, "strip", "gohberg_semencul")):"time" with linespoints linetype 1 pointtype 7 pointsize 0.5 \
         title named("Gohberg-Semencul", quantity, "gohberg_semencul"), \
       times using (of(quantity, "strip", "lu_apply")):"time" with linespoints linetype 7 dashtype 2 pointtype 4 pointsize 0.5 \
         title named("LU, factors known", quantity, "lu_apply"), \
       times using (of(quantity, "strip", "gohberg_semencul_apply")):"time" with linespoints linetype 1 dashtype 2 pointtype 6 pointsize 0.5 \
         title named("Gohberg-Semencul, known", quantity, "gohberg_semencul_apply")
}
unset multiplot
