#!/usr/bin/env bash
# Installs a build, moves what it installed, and uses it from another project: by CMake, or by
# pkg-config and a C compiler. All programs must print the same force. Status 77 without pkg-config.
# Usage: consumer.sh cmake|pkg_config CMAKE BUILD_FOLDER SOURCE_FOLDER WORK_FOLDER
set -euo pipefail
way=$1 cmake=$2 build=$3 source=$4 work=$5
rm -rf "$work"
mkdir -p "$work"

run_quietly() {
  "$@" >"$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
}
run_quietly "$cmake" --install "$build" --prefix "$work/first"
mv "$work/first" "$work/prefix"
prefix=$work/prefix
for file in include/microslip.h include/microslip_ellipse.h include/microslip/rolling/transient.hpp \
            share/microslip/examples/{c/wheel_drive.c,python/wheel_drive.py,octave/microslip_mex.c}; do
  [ -e "$prefix/$file" ] || { echo "not installed: $file" >&2; exit 1; }
done

case "$way" in
  cmake)
    for project in . only_c; do
      run_quietly "$cmake" -S "$source/tests/consumer/$project" -B "$work/$project/build" \
        -DCMAKE_BUILD_TYPE=Release -DCMAKE_PREFIX_PATH="$prefix"
      run_quietly "$cmake" --build "$work/$project/build"
    done
    programs=("$work"/build/rolls_in_c "$work"/build/rolls_in_cpp "$work"/only_c/build/rolls_in_c)
    ;;
  pkg_config)
    command -v pkg-config >/dev/null || {
      echo "skipped: no pkg-config (tools/deps.sh languages installs it)"
      exit 77
    }
    folder=$(dirname "$(find "$prefix" -name microslip.pc)")
    read -ra flags <<<"$(PKG_CONFIG_PATH=$folder pkg-config --cflags --libs microslip)"
    run_quietly cc "$source/tests/consumer/rolls.c" "${flags[@]}" -o "$work/rolls_in_c"
    run_quietly cc "$prefix/share/microslip/examples/c/wheel_drive.c" "${flags[@]}" -lm -o "$work/wheel"
    export LD_LIBRARY_PATH=$(dirname "$folder")
    run_quietly "$work/wheel"
    programs=("$work/rolls_in_c")
    ;;
esac
expected=$("$build/tests/rolls_here")
for program in "${programs[@]}"; do
  printed=$("$program")
  echo "$(basename "$program"): $printed"
  [ "$printed" = "$expected" ] || { echo "expected $expected" >&2; exit 1; }
done
