#!/usr/bin/env bash
# Figures from damaged tables, without gnuplot, and on a full disk: one message that names figure and
# table, exit status 1, and no figure, not even that of before.
# Usage: draw.sh CARTER PLOTS_FOLDER WORK_FOLDER
set -euo pipefail
carter=$1 plots=$2 work=$3
figure=$plots/carter_traction.gp svg=$work/figures/traction.svg
rm -rf "$work"
"$carter" --quick --out "$work/good"
mkdir "$work/bin"

# expect_refused CASE WHAT_THE_MESSAGE_SAYS: draws from $work/tables, in the place of an older figure
expect_refused() {
  mkdir -p "$work/figures"
  echo older >"$svg"
  local status=0 message
  message=$("$plots/draw.sh" "$figure" "$work/tables" "$svg" 2>&1) || status=$?
  if [ $status -ne 1 ] || [[ $message != *"draw: $figure: "*"$2"* ]] || [ -n "$(ls -A "$work/figures")" ]; then
    echo "$1: status $status, left '$(ls -A "$work/figures")', message:"$'\n'"$message" >&2
    exit 1
  fi
}
# Tables to be damaged.
afresh() {
  rm -rf "$work/tables"
  cp -r "$work/good" "$work/tables"
}
damaged() {
  afresh
  "${@:2}" <"$work/good/$1.tsv" >"$work/tables/$1.tsv"
}

afresh
"$plots/draw.sh" "$figure" "$work/tables" "$svg"
grep -q '<title>The smaller the step, .*of the Carter-Fromm problem.* Thesis Fig. 1.1.</title>' "$svg"
for format in png pdf; do "$plots/draw.sh" "$figure" "$work/tables" "$work/figures/traction.$format"; done
[[ $(head -c 4 "$work/figures/traction.png") == *PNG && $(head -c 4 "$work/figures/traction.pdf") == %PDF ]]
rm "$work/figures"/traction.p*
status=0
message=$("$plots/draw.sh" "$figure" "$work/tables" "$work/figures/traction.jpg" 2>&1) || status=$?
[[ $status = 1 && $message = *'traction.jpg: expected a name that ends in .svg, .png, .pdf or .gif' ]]

grep -v '^#' "$plots/carter_traction.gp" >"$work/silent.gp"
figure=$work/silent.gp expect_refused 'no caption' 'does not begin with a comment'
rm "$work/tables/exact.tsv"
expect_refused 'missing table' 'exact.tsv: no such table'
rm -rf "$work/tables"
expect_refused 'missing folder' 'exact.tsv: no such table'
damaged traction true
expect_refused 'nothing in a table' 'traction.tsv: no rows'
damaged traction grep -e '^#' -e '^step_ratio'
expect_refused 'header only' 'traction.tsv: no rows'
damaged summary sed -E '/^#|^step_ratio/! s/[^\t]+/nan/g'
expect_refused 'nothing but nan' 'summary.tsv: nothing but nan'
damaged traction head -c 5000
expect_refused 'cut off in a row' 'traction.tsv: cut off, its last line has no end'
damaged traction sed '$ s/\t.*//'
expect_refused 'short row' 'traction.tsv: cut off, a row has 1 cells, not'
damaged traction sed 's/\tbound/\tbond/'
expect_refused 'renamed column' 'gnuplot failed'

afresh
printf '%s\n' '#!/bin/sh' 'echo "<svg></svg>"' 'echo "warning: something" >&2' >"$work/bin/gnuplot"
chmod +x "$work/bin/gnuplot"
PATH=$work/bin:$PATH expect_refused 'a warning' 'gnuplot failed'
# As gnuplot does when its output is full: the begin of a figure, and no complaint.
printf '%s\n' '#!/bin/sh' 'echo "<svg>"' >"$work/bin/gnuplot"
PATH=$work/bin:$PATH expect_refused 'half a figure' 'gnuplot failed'
rm "$work/bin/gnuplot"
for tool in bash dirname rm; do ln -s "$(command -v $tool)" "$work/bin/$tool"; done
status=0
message=$(PATH=$work/bin bash "$plots/draw.sh" "$figure" "$work/tables" "$svg" 2>&1) || status=$?
[ $status -eq 1 ] && [ "$message" = "draw: $figure: gnuplot is not installed" ] && [ ! -e "$svg" ]
