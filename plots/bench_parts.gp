# A product by FFT takes a time that grows little faster than N, a dense product one that grows as the square of N. The
# other lines are influence coefficients, and points of the creepage-force curve.
load scripts."/bench.gpi"
set xlabel "number N of elements, or of unknowns of Chebyshev collocation [1]"
set title "parts of a solution\n{/*0.8 one core of ".processor."}"
named(text, quantity, kernel, method) = text.": ".power(quantity, kernel, method)
plot times using (of("influence", "strip", "difference")):"time" with linespoints linetype 3 pointtype 7 pointsize 0.5 title named("coefficients of A - A', strip", "influence", "strip", "difference"), \
     times using (of("influence", "plane", "difference")):"time" with linespoints linetype 3 dashtype 2 pointtype 6 pointsize 0.5 title named("the same, plane strain", "influence", "plane", "difference"), \
     times using (of("product", "strip", "dense")):"time" with linespoints linetype 7 pointtype 5 pointsize 0.5 title named("product, dense", "product", "strip", "dense"), \
     times using (of("product", "strip", "fft")):"time" with linespoints linetype 5 pointtype 7 pointsize 0.5 title named("product, FFT", "product", "strip", "fft"), \
     times using (of("point", "strip", "chebyshev")):"time" with linespoints linetype 4 pointtype 7 pointsize 0.5 title named("Chebyshev point, strip", "point", "strip", "chebyshev"), \
     times using (of("point", "plane", "chebyshev")):"time" with linespoints linetype 4 dashtype 2 pointtype 6 pointsize 0.5 title named("the same, plane strain", "point", "plane", "chebyshev")
