# Only the scheme that remembers the displacement is right for steps of any length. A Cattaneo shift rolls on; the
# ranges above the panels are the ranges of N = 51.
map = "transient"
across = "step_ratio"
up = "elements"
names = "remembered direct relaxed relaxed_traction fractional"
label_across = "step ratio c = dq/dx"
label_up = "elements N"
across_tics = "1e-12 1e-3 1 100"
up_tics = "11 25 51 101"
sentence(k) = no_role ? (safe(scheme, "elements", "least") > 1 ? sprintf("right from N = %g on", safe(scheme, "elements", "least")) : "right for any N") : \
  safe(scheme, "step_ratio", "least") < 1e-9 && safe(scheme, "step_ratio", "most") >= 100 ? "right for any c" : \
  safe(scheme, "step_ratio", "least") < 1e-9 ? sprintf("right for c ≤ %g", safe(scheme, "step_ratio", "most")) : \
  sprintf("right for %g ≤ c ≤ %g", safe(scheme, "step_ratio", "least"), safe(scheme, "step_ratio", "most"))
load scripts."/extremes.gpi"
