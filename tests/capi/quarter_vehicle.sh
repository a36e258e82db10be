#!/usr/bin/env bash
# The quarter of a wagon of the example brakes to a halt as it did when the reference was made, in each language: numbers of
# its result differ by less than 1e-6 of theirs. Energy is balanced to rounding, but for shifts and turns; the contact and
# the brake lose energy, and the brake holds no more than it can. The wheel rolls back, and is shifted on the spot. The distance is
# that of a mass with a rolling wheel, and the wheel rocks nearly as fast as on Mindlin's contact of its stiffness.
# Status 77 where the language is not installed.
# Usage: quarter_vehicle.sh c|python C_PROGRAM LIBRARY SOURCE_FOLDER WORK_FOLDER PYTHON_FOLDER
set -euo pipefail
source "$(dirname "$0")/example.bash"
prepare "$@"
run_example quarter_vehicle >"$work/quarter_vehicle.tsv"
awk -F '\t' '
  function size(x) { return x < 0 ? -x : x }
  function larger(x, y) { return x > y ? x : y }
  /^#.* = / { split($0, word, " "); result[word[2]] = word[length(word)] }
  /^#/ { next }
  FNR == NR { reference[$1] = $2; next }
  $1 == "t" { for (i = 1; i <= NF; i++) column[$i] = i; next }
  {
    rows++
    force[2] = force[1]; force[1] = force[0]; force[0] = $column["force"]
    dq = $column["dq"]; brake = $column["brake"]; missing = $column["missing"]
    if (dq < 0) back++
    if (dq == 0) shifts++
    if (dq * dq_before > 0) jump = larger(jump, size(missing - missing_before))
    gain = larger(gain, loss - $column["contact_loss"])
    brake_gain = larger(brake_gain, brake_loss - $column["brake_loss"])
    most_missing = larger(most_missing, size(missing)); missing_before = missing
    dq_before = dq
    loss = $column["contact_loss"]; brake_loss = $column["brake_loss"]
    most_brake = larger(most_brake, size(brake))
    # Half a rocking between extreme forces, with the secant of Mindlin from one to the other
    if ($1 > 0.755 && (force[1] - force[2]) * (force[0] - force[1]) < 0) {
      if (halves++) {
        part = size(force[1] - extreme) / 2 / (0.3 * $column["load"])
        softer += sqrt(1.5 * (1 - (1 - part) ^ (2 / 3)) / part)
      }
      extreme = force[1]
    }
  }
  END {
    for (name in reference) { names++; worst = larger(worst, size(result[name] / reference[name] - 1)) }
    torque = 0.55 * 0.3 * 60000 * 460; at_start = 1000 ^ 2 / 2 * (6.1 + 6e4 / 460 ^ 2)
    slowing = torque / 460 / (6.1 + 6e4 / 460 ^ 2)
    distance = 1000 * 0.2 - slowing * 0.2 ^ 2 / 6 + (1000 - slowing * 0.2 / 2) ^ 2 / (2 * slowing)
    mindlin = result["closed_form"] * (halves - 1) / softer
    printf "%d steps, %d back, %d shifts; result differs by %.1g; distance %.5g, %.5g of a mass\n", rows, back, shifts,
           worst, result["distance"], distance
    printf "energy misses %.2g of that at the start, %.2g in a step that rolls on; the contact gains %.2g at most\n",
           most_missing / at_start, jump / at_start, gain
    printf "rocking %.5g Hz, by Mindlin %.5g Hz, without slip %.5g Hz\n", result["rocking"], mindlin,
           result["closed_form"]
    exit !(names == 10 && rows > 1000 && worst < 1e-6 && back > 500 && shifts > 0 && most_missing < 1e-7 * at_start &&
           jump < 1e-13 * at_start && gain < 0.2 && brake_gain < 1e-9 * at_start && most_brake < torque * (1 + 1e-9) &&
           size(result["distance"] / distance - 1) < 2e-3 && size(result["rocking"] / mindlin - 1) < 2e-3)
  }' "$source/tests/capi/quarter_vehicle.tsv" "$work/quarter_vehicle.tsv"
