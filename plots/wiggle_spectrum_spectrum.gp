# As c falls, the condition number of B = A - A' grows without bound if N is odd, and stays bounded if N is even (left).
# Right are the symbol, which explains it, and the real against the imaginary parts of the eigenvalues. Thesis,
# introduction.
spectrum = tables."/spectrum.tsv"
of(name) = strcol("basis") eq name ? column("step_ratio") : NaN
stats tables."/matrix.tsv" using "row" nooutput
n = int(STATS_max)

eval page(800, 400)
set multiplot layout 1,2 margins 0.1,0.98,0.16,0.9 spacing 0.12
set logscale xy
set format xy "10^{%T}"
set xlabel "step ratio c = dq/dx"
set ylabel "condition number [1]"
set title "condition number of B"
set key top right
plot spectrum using (of("constant")):"condition" with lines linetype 1 title sprintf("constant, N = %d", n), \
     spectrum using (of("linear")):"condition" with lines linetype 2 title sprintf("linear, N = %d", n), \
     spectrum using (of("constant")):"condition_next" with lines linetype 1 dashtype 2 title sprintf("constant, N = %d", n + 1), \
     spectrum using (of("linear")):"condition_next" with lines linetype 2 dashtype 2 title sprintf("linear, N = %d", n + 1)
set title "least |symbol|; real to imaginary parts"
set ylabel "least |symbol| [2(1-ν)/G], Σ|Re λ| / Σ|Im λ| [1]"
set yrange [1e-9:2]
set key bottom right
plot spectrum using (of("constant")):"least_symbol" with lines linetype 1 title "least |symbol|, constant", \
     spectrum using (of("linear")):"least_symbol" with lines linetype 2 title "least |symbol|, linear", \
     spectrum using (of("constant")):(1 / column("imaginary_to_real")) with lines linetype 1 dashtype 2 title "Σ|Re λ| / Σ|Im λ|, constant", \
     spectrum using (of("linear")):(1 / column("imaginary_to_real")) with lines linetype 2 dashtype 2 title "Σ|Re λ| / Σ|Im λ|, linear"
unset multiplot
