# Schemes that take differences are right in a narrow band about c = 1; the others, which have no step, are right
# everywhere except for the coarsest grids. Steady rolling for tiny to huge steps and grids; the ranges above the panels
# are the ranges of N = 51.
map = "steps"
across = "step_ratio"
up = "elements"
names = "standard known_edge trimmed calibrated inversion chebyshev"
label_across = "step ratio c = dq/dx"
label_up = "elements N"
across_tics = "1e-12 1e-3 1 100"
up_tics = "1 5 51 401 100001"
sentence(k) = no_role ? (safe(scheme, "elements", "least") > 1 ? sprintf("right from N = %g on", safe(scheme, "elements", "least")) : "right for any N") : \
  safe(scheme, "step_ratio", "least") < 1e-9 && safe(scheme, "step_ratio", "most") >= 100 ? "right for any c" : \
  safe(scheme, "step_ratio", "least") < 1e-9 ? sprintf("right for c ≤ %g", safe(scheme, "step_ratio", "most")) : \
  sprintf("right for %g ≤ c ≤ %g", safe(scheme, "step_ratio", "least"), safe(scheme, "step_ratio", "most"))
load scripts."/extremes.gpi"
