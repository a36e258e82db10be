# Steady rolling of bodies of different material by N = 51 elements: calibrated elements are right to 3 % up to 0.9 of
# full sliding. Next to it a zone may be shorter than an element; a scene warns where the creepage is wrong by more. The parts above the panels are the largest
# errors of blue tiles.
map = "bodies"
across = "beta_over_mu"
up = "load"
names = "standard calibrated"
label_across = "β/μ"
label_up = "force over full sliding"
across_tics = "1e-12 1e-3 0.3 1 3 1e4"
up_tics = "-0.97 -0.5 -0.01 0 0.01 0.5 0.97"
sentence(k) = sprintf("up to %.2g %% off", 100 * most_error(scheme))
load scripts."/extremes.gpi"
