# A transient step by FFT takes a time that grows little faster than N; N steps under a force take a time that grows
# about as its square. Left, a step that leaves the partition as it is; right, N steps from a Cattaneo shift.
load scripts."/bench.gpi"
eval page(980, 600)
set multiplot layout 1,2 margins 0.08,0.98,0.36,0.84 spacing 0.09 title "transient rolling, steps of one element, strip\n{/*0.8 ".machines."}"
set key maxrows 5
named(text, quantity, method) = text.": ".power(quantity, "strip", method)
do for [quantity in "step rolling_by_force"] {
  set title quantity eq "step" ? "a step, partition unchanged" : "N steps, under a force"
  plot peer using (of(quantity, "strip", "CONTACT")):"time" with linespoints linetype 7 pointtype 5 pointsize 0.6 \
         title named("CONTACT", quantity, "CONTACT"), \
       times using (of(quantity, "strip", "direct_dense")):"time" with linespoints linecolor rgb colour_of("direct") dashtype 2 pointtype 6 pointsize 0.5 \
         title named("direct, dense", quantity, "direct_dense"), \
       times using (of(quantity, "strip", "direct_fft")):"time" with linespoints linecolor rgb colour_of("direct") pointtype 7 pointsize 0.5 \
         title named("direct, FFT", quantity, "direct_fft"), \
       times using (of(quantity, "strip", "remembered_dense")):"time" with linespoints linecolor rgb colour_of("remembered") dashtype 2 pointtype 6 pointsize 0.5 \
         title named("remembered, dense", quantity, "remembered_dense"), \
       times using (of(quantity, "strip", "remembered_fft")):"time" with linespoints linecolor rgb colour_of("remembered") pointtype 7 pointsize 0.5 \
         title named("remembered, FFT", quantity, "remembered_fft")
}
unset multiplot
