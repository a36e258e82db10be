#!/usr/bin/env bash
# Draws one figure. Usage: plots/draw.sh FIGURE.gp TABLES_FOLDER OUTPUT.svg
# A gnuplot warning is a failure, and a failure leaves no figure.
set -euo pipefail
script=$1 tables=$2 output=$3
command -v gnuplot >/dev/null || { echo "draw: gnuplot is not installed" >&2; exit 1; }
mkdir -p "$(dirname "$output")"
partial=$(dirname "$output")/.$(basename "$output").part
trap 'rm -f "$partial" "$partial.log"' EXIT
status=0
gnuplot -e "tables='$tables'; scripts='$(dirname "$0")'" "$(dirname "$0")/style.gp" "$script" \
  >"$partial" 2>"$partial.log" || status=$?
if [ $status -ne 0 ] || [ -s "$partial.log" ] || [ ! -s "$partial" ]; then
  echo "draw: $script failed" >&2
  cat "$partial.log" >&2
  exit 1
fi
mv "$partial" "$output"
