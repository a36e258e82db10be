#!/usr/bin/env bash
# Runs a study, quick: the tables must agree with the references; every figure must draw. `make verify` runs
# all studies twice and compares bytes. Claims name such figures, have a
# rule, and no verdict: a quick run has other parameters than the study.
# Usage: figures.sh PROGRAM COMPARE_TABLES SOURCE_FOLDER WORK_FOLDER
set -euo pipefail
program=$1 compare=$2 source=$3 work=$4
study=$(basename "$program")
rm -rf "$work"
"$program" --quick --out "$work/a/$study"
"$compare" "$work/a" "$source/tests/reference_tables" "$study"
figures=0
for script in "$source/plots/${study}"_*.gp; do
  "$source/plots/draw.sh" "$script" "$work/a/$study" "$work/$(basename "$script" .gp).svg"
  figures=$((figures + 1))
done
for figure in $(grep -v '^#' "$work/a/$study/claims.tsv" | awk -F '\t' 'NR > 1 && $NF != "none" { print $NF }'); do
  [ -s "$work/$figure.svg" ] || { echo "claims.tsv: no figure $figure" >&2; exit 1; }
done
grep -v '^#' "$work/a/$study/claims.tsv" | awk -F '\t' '
  NR == 1 { for (i = 1; i <= NF; ++i) at[$i] = i; next }
  $at["rule"] !~ / if .*; otherwise |^not comparable: ./ { print "claims.tsv: no rule: " $1; bad = 1 }
  $at["verdict"] != "not_judged" { print "claims.tsv: a verdict: " $1; bad = 1 }
  END { exit bad || NR < 2 }' >&2
echo "$study: $figures figures"
[ $figures -gt 0 ]
