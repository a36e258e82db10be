# Every scheme solves steady rolling with the edges of the contact anywhere within an element; schemes that are not told
# the edge have an error that depends on it.
map = "offsets"
across = "leading_offset"
up = "trailing_offset"
names = "standard 'standard linear' 'standard quadratic' known_edge trimmed inversion"
label_across = "leading offset δ₊ [dx]"
label_up = "trailing offset δ₋ [dx]"
across_tics = "0 0.2 0.5 0.8253 1"
up_tics = "0 0.2 0.5 0.8253 1"
sentence(k) = most_error(scheme) < 1e-6 ? "right to rounding" : sprintf("up to %.2g %% off", 100 * most_error(scheme))
load scripts."/extremes.gpi"
