#!/usr/bin/env bash
# Two clean builds in two folders, with one thread and with two, must give the same bytes in every
# table and figure, and tables that agree with those of tests/reference_tables. So must the tables
# of other instructions, optimisations and compilers.
# Usage: tools/verify.sh WORK_FOLDER JOBS
set -euo pipefail
work=$1 jobs=$2
root=$(cd "$(dirname "$0")/.." && pwd)
rm -rf "$work"
mkdir -p "$work"
work=$(cd "$work" && pwd)

# Sources, programs and tables each have another path in b.
for source in "$work/a" "$work/another/b"; do
  mkdir -p "$source"
  tar -C "$root" --exclude=./.git --exclude=./build --exclude=./results -c . | tar -C "$source" -x
done
# A second build must not come out of a compiler cache.
export CCACHE_DISABLE=1
build_and_run() {
  local source=$1 build=$2 tables=$3 threads=$4
  mkdir -p "$build"
  echo "verify: building in $build"
  if ! { cmake -S "$source" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF &&
         cmake --build "$build" -j "$jobs" --target programs compare_tables; } >"$build/log" 2>&1; then
    tail -n 40 "$build/log" >&2
    return 1
  fi
  echo "verify: running with $threads threads"
  "$source/tools/quick_tables.sh" "$build/bin" "$tables" "$threads"
}
build_and_run "$work/a" "$work/a/build" "$work/a/tables" 1
build_and_run "$work/another/b" "$work/b-build" "$work/b-tables" 2

draw() {
  local source=$1 tables=$2 figures=$3 script study
  for script in "$source"/plots/*_*.gp; do
    for study in "$tables"/*; do
      [[ $(basename "$script") != "$(basename "$study")"_* ]] ||
        "$source/plots/draw.sh" "$script" "$study" "$figures/$(basename "$script" .gp).svg"
    done
  done
}
draw "$work/a" "$work/a/tables" "$work/a/figures"
# Measured times differ from run to run; with those of a, the figures of them are the same, too.
cp -r "$work/b-tables" "$work/b-drawn"
for table in "$work"/a/tables/*/*_timing.tsv; do
  cp "$table" "$work/b-drawn/$(basename "$(dirname "$table")")"
done
draw "$work/another/b" "$work/b-drawn" "$work/b-figures"

status=0
diff -rq -x 'provenance*.txt' -x '*_timing.tsv' "$work/a/tables" "$work/b-tables" || status=1
diff -rq "$work/a/figures" "$work/b-figures" || status=1
[ $status -ne 0 ] ||
  echo "verify: $(find "$work/a/tables" -name '*.tsv' ! -name '*_timing.tsv' | wc -l) tables and" \
    "$(find "$work/a/figures" -name '*.svg' | wc -l) figures are the same bytes in both"
"$work/a/build/bin/compare_tables" "$work/a/tables" "$root/tests/reference_tables" || status=1
"$work/a/tools/elsewhere/elsewhere.sh" "$work/a/build/bin" "$work/elsewhere" "$jobs" || status=1
case $status in
  0) echo "verify: all is the same, or agrees within the tolerances" ;;
  *) echo "verify: there are differences" >&2 ;;
esac
exit $status
