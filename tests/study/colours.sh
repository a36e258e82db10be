#!/usr/bin/env bash
# Each scheme that a scene may name has a colour in plots/style.gp, and no two schemes of a key share one: a figure
# would draw a scheme without a colour in black, as exact solutions. Texts in the hue of a line can be read.
# Usage: colours.sh MICROSLIP SOURCE_FOLDER
set -euo pipefail
microslip=$1 source=$2
listed=$(sed -n '/^colours = /,/"$/p' "$source/plots/style.gp")
for key in leading_edge step.scheme; do
  read -ra schemes < <("$microslip" keys | sed -n "s/^${key/./\\.} .*: \([a-z_, ]*\) \[.*/\1/p" | tr -d ,)
  [ ${#schemes[@]} -ge 5 ] || { echo "$key has ${#schemes[@]} schemes" >&2; exit 1; }
  used=
  for scheme in "${schemes[@]}"; do
    colour=$(grep -oE " $scheme #[0-9a-f]{6}" <<<"$listed" | grep -oE '#.*') ||
      { echo "plots/style.gp: no colour for $scheme" >&2; exit 1; }
    [[ $used != *$colour* ]] || { echo "plots/style.gp: $scheme is $colour, as another scheme of $key" >&2; exit 1; }
    used+=" $colour"
  done
done

# Texts have a contrast of at least 4.5 on white (WCAG 2), whatever the colour of the line that they label.
command -v gnuplot >/dev/null || exit 0
lines=$(grep -oE '#[0-9a-f]{6}' "$source/plots/style.gp" | sort -u)
[ "$(wc -l <<<"$lines")" -ge 10 ] || { echo "plots/style.gp: too few colours" >&2; exit 1; }
labels=$(for colour in $lines; do echo "print '$colour ', label_colour('$colour')"; done |
  gnuplot -e "format = 'svg'" "$source/plots/style.gp" - 2>&1)
awk '
  function light(hex, c) {
    c = (16 * (index("0123456789abcdef", substr(hex, 1, 1)) - 1) + index("0123456789abcdef", substr(hex, 2, 1)) - 1) / 255
    return c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ^ 2.4
  }
  function contrast(colour) {
    return 1.05 / (0.2126 * light(substr(colour, 2, 2)) + 0.7152 * light(substr(colour, 4, 2)) + 0.0722 * light(substr(colour, 6, 2)) + 0.05)
  }
  $2 !~ /^#[0-9a-f]+$/ || contrast($2) < 4.5 { print "plots/style.gp: a label of " $1 " is " $2; bad = 1 }
  contrast($1) >= 4.5 && $1 != $2 { print "plots/style.gp: a label of " $1 " is dark enough, but " $2; bad = 1 }
  END { exit bad || NR < 10 }' <<<"$labels" >&2
