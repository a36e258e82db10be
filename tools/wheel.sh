#!/usr/bin/env bash
# Makes a wheel of the Python package with the libraries inside that it needs (GSL, FFTW, fmt), from a build folder whose
# target microslip_python is built first. No network is needed. Status 77 where something for it is not installed.
# Usage: tools/wheel.sh BUILD_FOLDER WHEEL_FOLDER [PYTHON]
set -euo pipefail
source=$(cd "$(dirname "$0")/.." && pwd)
build=$(realpath "$1")
mkdir -p "$2"
wheels=$(realpath "$2")
for python in ${3:-python3 /usr/bin/python3} none; do
  if [ "$python" = none ]; then
    echo "wheel.sh: no Python with setuptools and wheel (tools/deps.sh wheels installs them)" >&2
    exit 77
  fi
  "$python" -c 'import setuptools, wheel' 2>/dev/null && break
done
for tool in ldd objdump; do
  command -v "$tool" >/dev/null || { echo "wheel.sh: no $tool" >&2; exit 77; }
done
# From a copy, as setuptools writes beside the sources.
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
(cd "$source" && tar -c setup.py pyproject.toml CMakeLists.txt LICENSE docs/python.md python/microslip/*.py \
  python/microslip/py.typed tables/creep_forces.nc) | tar -C "$work" -x
rm -f "$wheels"/microslip-*.whl
# As pip does it, which need not be there.
cd "$work"
MICROSLIP_BUNDLE=1 MICROSLIP_BUILD_FOLDER=$build "$python" - "$wheels" >log 2>&1 <<'TEXT' || { cat log >&2; exit 1; }
import sys
from setuptools import build_meta
build_meta.build_wheel(sys.argv.pop())
TEXT
ls "$wheels"/microslip-*.whl
