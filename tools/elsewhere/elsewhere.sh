#!/usr/bin/env bash
# Tables as other processors, libraries and compilers make them must agree with those of
# tests/reference_tables. Says of each way what it did, or why it was not run.
# Usage: elsewhere.sh PROGRAMS_FOLDER WORK_FOLDER JOBS [WAY ...]
# PROGRAMS_FOLDER: those of an ordinary build, compare_tables among them. Ways; all without any:
#   older   an older processor: the C library's functions without AVX, AVX2, AVX-512 and fused products, and
#           FFTW without vector instructions
#   O1      -O1 in the place of -O3
#   native  -march=native: all instructions of this processor
#   clang   clang++ in the place of the compiler that CMake finds
set -euo pipefail
programs=$1 work=$2 jobs=$3
ways=("${@:4}")
[ ${#ways[@]} -gt 0 ] || ways=(older O1 native clang)
root=$(cd "$(dirname "$0")/../.." && pwd)
mkdir -p "$work"
work=$(cd "$work" && pwd)

# agrees WAY: compares what is in WORK/WAY/tables, and sums up
agrees() {
  local said=$work/$1/compared status=0
  "$programs/compare_tables" "$work/$1/tables" "$root/tests/reference_tables" >"$said" || status=$?
  awk -v way="$1" '
    { count[$2 ~ /^identical/ ? "identical" : $2 ~ /^agrees/ ? "agrees" : "differs"]++ }
    match($0, /largest difference is [^ ]+/) {
      size = substr($0, RSTART + 22, RLENGTH - 22) + 0
      if (size > worst) { worst = size; where = $1 substr($0, RSTART + RLENGTH + 10) }
    }
    $2 ~ /^differs/ { print "elsewhere: " way ": " $0 }
    END {
      printf "elsewhere: %s: %d tables identical, %d agree, %d differ", way, count["identical"], count["agrees"], count["differs"]
      if (worst > 0) printf "; largest difference: %.2g of the tolerance, in %s", worst, where
      print ""
    }' "$said"
  return $status
}

# built WAY OPTIONS...: the programs, of a build with these options of CMake
built() {
  local build=$work/$1/build
  if ! { cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF "${@:2}" &&
         cmake --build "$build" -j "$jobs" --target programs; } >"$work/$1/log" 2>&1; then
    echo "elsewhere: $1: the build fails:" >&2
    tail -n 20 "$work/$1/log" >&2
    return 1
  fi
}

missing() { echo "elsewhere: $1: not run: $2"; }

status=0
for way in "${ways[@]}"; do
  rm -rf "${work:?}/$way/tables"
  mkdir -p "$work/$way"
  made=("$root/tools/quick_tables.sh" "$programs" "$work/$way/tables" "$jobs")
  case $way in
    older)
      [ "$(uname -m)" = x86_64 ] || { missing "$way" "no x86-64"; continue; }
      shim=$work/$way/without_simd.so
      "${CC:-cc}" -shared -fPIC -O1 -o "$shim" "$root/tools/elsewhere/fftw_without_simd.c" -ldl
      env GLIBC_TUNABLES=glibc.cpu.hwcaps=-AVX,-AVX2,-AVX512F,-FMA,-FMA4 LD_PRELOAD="$shim" "${made[@]}"
      ;;
    O1 | native | clang)
      case $way in
        O1) options=(-DCMAKE_CXX_FLAGS_RELEASE="-O1 -DNDEBUG") ;;
        native) options=(-DCMAKE_CXX_FLAGS_RELEASE="-O3 -march=native -DNDEBUG") ;;
        clang)
          command -v clang++ clang >/dev/null || { missing "$way" "no clang++"; continue; }
          options=(-DCMAKE_CXX_COMPILER=clang++ -DCMAKE_C_COMPILER=clang)
          ;;
      esac
      built "$way" "${options[@]}" || { status=1; continue; }
      made[1]=$work/$way/build/bin
      "${made[@]}"
      ;;
    *) echo "elsewhere.sh: unknown way '$way'; known: older O1 native clang" >&2; exit 1 ;;
  esac
  agrees "$way" || status=1
done
exit $status
