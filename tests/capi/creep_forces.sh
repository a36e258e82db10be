#!/usr/bin/env bash
# The example of the table in C: forces grow with the creepage to nearly full sliding, their slopes are the differences of
# the rows, and a file that is no table is named. Usage: creep_forces.sh PROGRAM TABLE
set -euo pipefail
program=$1 table=$2
"$program" "$table" | awk -F '\t' -v full=24000 '
  function size(x) { return x < 0 ? -x : x }
  /^#/ { next }
  $1 == "creepage" { next }
  { rows++; total = sqrt($2 * $2 + $3 * $3)
    if (total > full * 1.005 || total < before) bad = 1
    # The trapezium rule over the slope.
    if (rows > 1) { missing = size($2 - last[2] - ($5 + last[5]) / 2 * ($1 - last[1])) / full; if (missing > worst) worst = missing }
    before = total * 0.999; for (i = 1; i <= NF; i++) last[i] = $i }
  END { printf "%d rows, up to %.3g of full sliding; slopes miss %.1g\n", rows, total / full, worst
        exit !(rows == 41 && !bad && total > 0.95 * full && worst < 2e-3) }'
status=0
message=$("$program" "$0" 2>&1) || status=$?
[ $status -eq 1 ] && [[ $message == "creep_forces: $0: not a table"* ]] || { echo "$status: $message" >&2; exit 1; }
