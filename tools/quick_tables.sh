#!/usr/bin/env bash
# All tables that are made in seconds: every study, quick, the examples, and a sweep.
# Usage: tools/quick_tables.sh PROGRAMS_FOLDER OUT THREADS
# A study has one thread, but for creep_tables, which takes all cores; the threads solve the cases of the sweep.
set -euo pipefail
programs=$1 out=$2 threads=$3
root=$(dirname "$0")/..
for scene in "$root"/studies/*/study.info; do
  study=$(basename "$(dirname "$scene")")
  "$programs/$study" --quick --out "$out/$study"
done
for problem in steady line ellipse transient run cylinder; do
  "$programs/microslip" --scene "$root/examples/$problem.info" --out "$out/example_$problem"
done
"$programs/microslip" curve --scene "$root/examples/ellipse.info" --points 11 --beside "fastsim vermeulen_johnson polach" --quiet \
  --out "$out/example_ellipse_curve"
"$programs/microslip" response --scene "$root/examples/steady.info" --out "$out/example_response"
for problem in steady transient; do
  "$programs/microslip" converge --scene "$root/examples/$problem.info" --quiet --out "$out/example_converge_$problem" \
    --set "converge.elements=15 31 63"
done
"$programs/microslip" sweep --quiet --threads "$threads" --scene "$root/examples/sweep.info" --out "$out/example_sweep"
