#!/usr/bin/env bash
# Runs the benchmarks, as short as they go: every table must have rows, times must be positive, and
# every figure must draw.
# Usage: bench.sh PROGRAM PLOTS_FOLDER WORK_FOLDER
set -euo pipefail
program=$1 plots=$2 work=$3
rm -rf "$work"
"$program" --quick --out "$work/tables"
for table in machine times peer exponents crossovers memory targets; do
  [ "$(grep -vc '^#' "$work/tables/$table.tsv")" -gt 1 ] || { echo "no rows in $table" >&2; exit 1; }
done
grep -v '^#' "$work/tables/times.tsv" | awk -F '\t' '
  NR == 1 { for (i = 1; i <= NF; i++) if ($i == "time") time = i; if (!time) exit 1; next }
  !($time > 0) { print "a time that is not positive: " $0 > "/dev/stderr"; exit 1 }'
for script in "$plots"/bench_*.gp; do
  "$plots/draw.sh" "$script" "$work/tables" "$work/$(basename "$script" .gp).svg"
done
