# Steady rolling with the edges of the contact anywhere within an element.
map = "offsets"
across = "leading_offset"
up = "trailing_offset"
names = "standard 'standard linear' 'standard quadratic' known_edge trimmed inversion"
label_across = "leading offset β [dx]"
label_up = "trailing offset α [dx]"
error = "error of force or creepage [1]"
set xrange [-0.06:1.06]
set yrange [-0.06:1.06]
load scripts."/extremes.gpi"
