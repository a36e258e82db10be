#!/usr/bin/env bash
# The coupling example in one language: it balances energy, over steps far below an element and of
# some, and its table is that in C; in Octave, after a test of
# what else its functions do. Status 77 where the language is not installed.
# Usage: examples.sh c|python|octave C_PROGRAM LIBRARY SOURCE_FOLDER WORK_FOLDER PYTHON_FOLDER
set -euo pipefail
source "$(dirname "$0")/example.bash"
prepare "$@"
[ "$language" != octave ] || octave_with octave_test

"$c_program" >"$work/c.tsv"
[ "$language" = c ] || run_example wheel_drive >"$work/$language.tsv"

diff <(grep -v '^[0-9]' "$work/c.tsv") <(grep -v '^[0-9]' "$work/$language.tsv")
grep -v '^#' "$work/c.tsv" >"$work/c.rows"
grep -v '^#' "$work/$language.tsv" >"$work/$language.rows"
# Differences are relative to the largest value of a column, and what energy misses to the kinetic.
awk -F '\t' -v accepted=1e-12 '
  function size(x) { return x < 0 ? -x : x }
  FNR == 1 { for (i = 1; i <= NF; i++) column[$i] = i; next }
  FNR == NR { for (i = 1; i <= NF; i++) { value[FNR, i] = $i; if (size($i) > most[i]) most[i] = size($i) }
              rows = FNR; ratio = $column["step_ratio"]; if (FNR == 2 || ratio < least) least = ratio; next }
  { for (i = 1; i <= NF; i++) {
      if (i == column["missing"]) continue
      if (size($i - value[FNR, i]) > worst * most[i]) worst = size($i - value[FNR, i]) / most[i] }
    if (size($column["missing"]) > missing) missing = size($column["missing"])
    last = FNR }
  END {
    missing /= most[column["kinetic"]]
    printf "%d steps of %.2g to %.2g elements; energy misses %.1g, differences to C %.1g\n",
           last - 1, least, most[column["step_ratio"]], missing, worst
    exit !(last == rows && last > 100 && least < 0.02 && most[column["step_ratio"]] > 2 &&
           missing < accepted && worst < accepted)
  }' "$work/c.rows" "$work/$language.rows"
