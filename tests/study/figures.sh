#!/usr/bin/env bash
# Runs a study twice, quick: the tables must be the same bytes, but for measured times, and every
# figure must draw.
# Usage: figures.sh PROGRAM PLOTS_FOLDER WORK_FOLDER
set -euo pipefail
program=$1 plots=$2 work=$3
study=$(basename "$program")
rm -rf "$work"
"$program" --quick --out "$work/a"
"$program" --quick --out "$work/b"
tables=0
for table in "$work"/a/*.tsv; do
  [[ $table == *_timing.tsv ]] || cmp "$table" "$work/b/$(basename "$table")"
  tables=$((tables + 1))
done
figures=0
for script in "$plots/${study}"_*.gp; do
  "$plots/draw.sh" "$script" "$work/a" "$work/$(basename "$script" .gp).svg"
  figures=$((figures + 1))
done
echo "$study: $tables tables, $figures figures"
[ $tables -gt 0 ] && [ $figures -gt 0 ]
