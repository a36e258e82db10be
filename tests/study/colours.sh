#!/usr/bin/env bash
# Each scheme that a scene may name has a colour in plots/style.gp, and no two schemes of a key share one:
# a figure would draw a scheme without a colour in black, as exact solutions.
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
