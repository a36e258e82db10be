#!/usr/bin/env bash
# The wheelset of the example runs into a curve as it did when the reference was made, in each language: differences
# are below 1e-6 of the largest value of a column. At the end it holds its balance, and it is displaced nearly as in
# pure rolling. In Octave, after a test of what else its functions do. Status 77 where the language is not installed.
# Usage: wheelset.sh c|python|octave C_PROGRAM LIBRARY SOURCE_FOLDER WORK_FOLDER PYTHON_FOLDER
set -euo pipefail
source "$(dirname "$0")/example.bash"
prepare "$@"
[ "$language" != octave ] || octave_with octave_ellipse_test
reference=$source/tests/capi/wheelset.tsv
run_example wheelset >"$work/wheelset.tsv"
diff <(grep -v '^[0-9]' "$work/wheelset.tsv") <(grep -v '^[0-9]' "$reference")
awk -F '\t' '
  function size(x) { return x < 0 ? -x : x }
  /^#/ { next }
  $1 == "t" { for (i = 1; i <= NF; i++) column[$i] = i; row = 0; next }
  FNR == NR { row++; for (i = 1; i <= NF; i++) { value[row, i] = $i; if (size($i) > most[i]) most[i] = size($i) }
              rows = row; next }
  { row++; for (i = 1; i <= NF; i++) {
      if (size($i - value[row, i]) > worst * most[i]) worst = size($i - value[row, i]) / most[i]
      last[i] = $i } }
  END {
    pure = -750 * 460 * last[column["curvature"]] / 0.1
    across = last[column["lateral_left"]] + last[column["lateral_right"]] - 2000 * last[column["y"]]
    printf "%d rows, differences %.1g; y = %s, %.3g of pure rolling; lateral forces miss %.2g N\n",
           row, worst, last[column["y"]], last[column["y"]] / pure, across
    exit !(row == rows && row == 100 && worst < 1e-6 && size(last[column["y"]] / pure - 1) < 0.12 &&
           size(across) < 20)
  }' "$reference" "$work/wheelset.tsv"
