# Markdown as forges and editors take it, into that of Doxygen. Usage: sed -E -f tools/doxygen.sed PAGE
# Formulas: a block ```math, and $...$ within a line.
/^```math$/,/^```$/ {
  s/^```math$/\\f[/
  s/^```$/\\f]/
  b
}
s/\$([^$]+)\$/\\f$\1\\f$/g
# Bold text with formulas is none in Doxygen's Markdown. It begins a line on our pages.
s/^\*\*/<b>/
s/\*\*/<\/b>/
# Links to headings need their names: `## Small motions` is small-motions. Links to other pages are text.
/^##+ / {
  h
  s/^#+ //
  s/.*/\L&/
  s/[^a-z0-9 -]//g
  s/ /-/g
  s/.*/ {#&}/
  H
  x
  s/\n//
}
s/\[([^]]+)\]\(([a-z_]+\.md[^)]*)\)/\1/g
