# In steady rolling the time of each scheme by FFT and of the inversion grows little faster than N, and the time of
# CONTACT and of dense matrices with a power of two or more.
load scripts."/bench.gpi"
set key maxrows 3
set title "steady rolling, 0.64 of full sliding, strip\n{/*0.8 ".machines."}"
named(text, method) = text.": ".power("steady", "strip", method)
plot peer using (of("steady", "strip", "CONTACT")):"time" with linespoints linetype 7 pointtype 5 pointsize 0.6 title named("CONTACT", "CONTACT"), \
     times using (of("steady", "strip", "standard_dense")):"time" with linespoints linecolor rgb colour_of("standard") dashtype 2 pointtype 6 pointsize 0.5 title named("standard, dense", "standard_dense"), \
     times using (of("steady", "strip", "standard_fft")):"time" with linespoints linecolor rgb colour_of("standard") pointtype 7 pointsize 0.5 title named("standard, FFT", "standard_fft"), \
     times using (of("steady", "strip", "calibrated_dense")):"time" with linespoints linecolor rgb colour_of("calibrated") dashtype 2 pointtype 6 pointsize 0.5 title named("calibrated, dense", "calibrated_dense"), \
     times using (of("steady", "strip", "calibrated_fft")):"time" with linespoints linecolor rgb colour_of("calibrated") pointtype 7 pointsize 0.5 title named("calibrated, FFT", "calibrated_fft"), \
     times using (of("steady", "strip", "inversion")):"time" with linespoints linecolor rgb colour_of("inversion") pointtype 7 pointsize 0.5 title named("inversion", "inversion")
