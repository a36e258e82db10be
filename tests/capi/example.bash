# How the examples run in one language; for the tests of this folder. Status 77 where the language is not installed.

# $1 c, python or octave, $2 the program in C, $3 library, $4 source folder, $5 work folder, $6 folder of Python
prepare() {
  language=$1 c_program=$2 source=$4 work=$5
  local folder function
  folder=$(dirname "$3")
  rm -rf "$work"
  mkdir -p "$work"
  case "$language" in
    c) ;;
    python)
      for python in python3 /usr/bin/python3 none; do
        [ "$python" != none ] || skip "no python3 with numpy"
        ! "$python" -c 'import numpy' 2>"$work/log" || break
      done
      export PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$6
      ;;
    octave)
      for program in octave-cli mkoctfile; do
        command -v "$program" >"$work/log" || skip "no $program"
      done
      for function in microslip_mex microslip_ellipse_mex; do
        mkoctfile --mex "$source/examples/octave/$function.c" -o "$work/$function.mex" -Wall -Wextra \
          -I"$source/capi/include" -L"$folder" -lmicroslip "-Wl,-rpath,$folder" >"$work/log" 2>&1 ||
          { cat "$work/log" >&2; exit 1; }
        [ ! -s "$work/log" ] || { cat "$work/log" >&2; exit 1; }
      done
      ;;
  esac
}

skip() {
  echo "skipped: $1 (tools/deps.sh languages installs it)"
  exit 77
}

# $1 a function of Octave
octave_with() {
  octave-cli --no-init-file --no-history --path "$work" --path "$source/tests/capi" --path "$source/examples/octave" --eval "$1"
}

# $1 name of the example
run_example() {
  case "$language" in
    c) "$c_program" ;;
    python) "$python" "$source/examples/python/$1.py" ;;
    octave) octave_with "$1" ;;
  esac
}
