#!/usr/bin/env bash
# `make quick`, interrupted and called again: a study is there whole or not at all, and only what had
# not finished is done again. Runs the project's Makefile on built programs, without CMake.
# Usage: make.sh PROGRAMS_FOLDER SOURCE_FOLDER WORK_FOLDER
set -euo pipefail
programs=$1 source=$2 work=$3
studies=(carter smoothing under_relaxation world_fixed)  # 4 ms, then 0.5 s and more
held=under_relaxation                                    # waits while a file is there: no make ends before its signal

fail() {
  echo "make.sh: $1" >&2
  cat "$work/log" >&2
  exit 1
}
wait_for() {
  for _ in {1..600}; do
    [ ! -e "$1" ] || return 0
    sleep 0.05
  done
  fail "no $1 after half a minute"
}

rm -rf "$work"
mkdir -p "$work/project/build/release/bin" "$work/bin"
for study in "${studies[@]}"; do
  mkdir -p "$work/project/studies/$study"
  ln -s "$source/studies/$study/study.info" "$work/project/studies/$study"
  ln -s "$programs/$study" "$work/project/build/release/bin"
done
rm "$work/project/build/release/bin/$held"
printf '#!/bin/sh\nwhile [ -e "%s" ]; do sleep 0.02; done\nexec "%s" "$@"\n' \
  "$work/hold" "$programs/$held" >"$work/project/build/release/bin/$held"
chmod +x "$work/project/build/release/bin/$held"
ln -s "$source/Makefile" "$source/plots" "$work/project"
touch "$work/project/build/release/CMakeCache.txt"
for tool in cmake deps.sh; do
  printf '#!/bin/sh\n' >"$work/bin/$tool"
  chmod +x "$work/bin/$tool"
done
ln -s "$work/bin" "$work/project/tools"
export PATH=$work/bin:$PATH
unset MAKEFLAGS MAKELEVEL
cd "$work/project"
quick=results/quick

set -m  # a group of processes of its own for make, which does not ignore SIGINT
for signal in INT TERM; do
  rm -rf results
  touch "$work/hold"
  make quick JOBS=2 >"$work/log" 2>&1 &
  wait_for $quick/carter/provenance.txt
  sleep 0.1
  kill -s "$signal" -- -$!
  status=0
  wait $! || status=$?
  rm "$work/hold"
  [ $status -ne 0 ] || fail "status 0 after SIG$signal"

  left=$(find . -name '.*.part')
  [ -z "$left" ] || fail "left behind: $left"
  finished=()
  for study in "${studies[@]}"; do
    [ ! -e "$quick/$study" ] || [ -e "$quick/$study/provenance.txt" ] || fail "half of $study is there"
    [ ! -e "$quick/$study" ] || finished+=("$study")
  done
  case ${#finished[@]} in
    [123]) ;;
    *) fail "finished: ${finished[*]}" ;;
  esac
  for study in "${finished[@]}"; do cp "$quick/$study/provenance.txt" "$work/$study.txt"; done

  make quick JOBS=2 >"$work/log" 2>&1 || fail "the second make failed"
  for study in "${studies[@]}"; do [ -e "$quick/$study/provenance.txt" ] || fail "no $study"; done
  for study in "${finished[@]}"; do
    cmp "$quick/$study/provenance.txt" "$work/$study.txt" || fail "$study ran again"
  done
  for script in plots/{carter,smoothing,under_relaxation,world_fixed}_*.gp; do
    [ -s $quick/figures/"$(basename "$script" .gp)".svg ] || fail "no figure of $script"
  done
  touch "$work/third"
  make quick JOBS=2 >"$work/log" 2>&1
  [ -z "$(find results -newer "$work/third")" ] || fail "the third make did something"
done

# Results that make has made go, and results that a user has made stay.
mkdir -p results/mine
cp -r $quick/carter results/carter
echo kept >results/mine/traction.tsv
make clean >"$work/log" 2>&1 || fail "make clean failed"
[ "$(ls results)" = mine ] || fail "left in results: $(ls results)"
[ "$(cat results/mine/traction.tsv)" = kept ] || fail "a user's result is gone"
[ ! -e build ] || fail "the build is still there"
