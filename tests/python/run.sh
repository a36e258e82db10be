#!/usr/bin/env bash
# The Python package. Status 77 where something for it is not installed.
#   package   its tests, on the package in the build folder
#   types     mypy finds no error in its annotations
#   notebook  the notebooks of examples/ run from top to bottom
#   install   pip makes a wheel in a virtual environment, without a network, and that solves a scene elsewhere
#   wheel     pip installs the wheel of `make wheels`, which loads the libraries that it has inside
# Usage: run.sh package|types|notebook|install|wheel SOURCE_FOLDER BUILD_FOLDER WORK_FOLDER
set -euo pipefail
part=$1 source=$(realpath "$2") build=$(realpath "$3") work=$4
export PYTHONDONTWRITEBYTECODE=1
rm -rf "$work"
mkdir -p "$work"
cd "$work"

# $@ modules; the first Python that has all of them
python_with() {
  local candidate
  for candidate in python3 /usr/bin/python3; do
    if "$candidate" -c "import ${*// /, }" 2>>log; then
      echo "$candidate"
      return
    fi
  done
  return 1
}
# $1 what is missing, $2 the group of packages that has it, if not languages
skip() {
  echo "skipped: $1 (tools/deps.sh ${2:-languages} installs it)"
  exit 77
}

# Shows that a package of pip works. With an argument more, its libraries are those inside.
cat >try.py <<'TEXT'
import pathlib, re, sys
import microslip as ms
assert pathlib.Path(ms.__file__).is_relative_to(sys.prefix), ms.__file__
result = ms.solve(sys.argv[1], load_force=-1000)
assert abs(result.summary["creepage"] / 0.00112813 - 1) < 1e-5, result
forces = ms.CreepTable().forces(1e-3, half_width=5, lateral_half_width=5, peak_traction=300, shear_modulus=82000, poisson_ratio=0.28)
assert abs(forces.force / -7285 - 1) < 0.01, forces
if len(sys.argv) > 2:
    loaded = {line.split()[-1] for line in open("/proc/self/maps") if re.search(r"/lib(gsl|gslcblas|fftw3|fmt)\.so", line)}
    assert len(loaded) == 4 and all(pathlib.Path(one).is_relative_to(sys.prefix) for one in loaded), loaded
print(f"microslip {ms.__version__} of pip: {result}")
TEXT

case "$part" in
  package)
    python=$(python_with numpy, pytest) || skip "no python3 with numpy and pytest"
    MICROSLIP=$build/bin/microslip PYTHONPATH=$build/python "$python" -W error::ResourceWarning -m pytest -q \
      -p no:cacheprovider -o python_files='*_test.py' "$source/tests/python"
    ;;
  types)
    command -v mypy >>log || skip "no mypy"
    (cd "$source" && mypy --cache-dir="$OLDPWD/cache")
    ;;
  notebook)
    python=$(python_with numpy, nbconvert, ipykernel, matplotlib) ||
      skip "no python3 with nbconvert, ipykernel and matplotlib" notebook
    export HOME=$work PYTHONPATH=$build/python PYDEVD_DISABLE_FILE_VALIDATION=1
    export IPYTHONDIR=$work/ipython
    for notebook in rolling ellipse; do
      "$python" -m nbconvert --to notebook --execute --output-dir "$work" --log-level ERROR \
        "$source/examples/python/$notebook.ipynb"
      # Each cell of code has run, and figures are there.
      "$python" - $notebook.ipynb <<'TEXT'
import json, sys
cells = [cell for cell in json.load(open(sys.argv[1]))["cells"] if cell["cell_type"] == "code"]
figures = sum("image/png" in output.get("data", {}) for cell in cells for output in cell["outputs"])
assert cells and all(cell["execution_count"] for cell in cells), "a cell did not run"
assert figures >= 3, f"{figures} figures"
print(f"{len(cells)} cells, {figures} figures")
TEXT
    done
    ;;
  install)
    python=$(python_with numpy, setuptools, wheel, venv, ensurepip) ||
      skip "no python3 with numpy, setuptools, wheel and venv"
    # From a copy, as setuptools writes beside the sources; the library is that of the build folder.
    mkdir tree
    tar -C "$source" --exclude=./build --exclude=./.git --exclude=./results -cf - . | tar -C tree -xf -
    "$python" -m venv --system-site-packages here
    MICROSLIP_BUILD_FOLDER=$build \
      here/bin/python -m pip install --quiet --no-build-isolation --no-index --disable-pip-version-check ./tree
    here/bin/python try.py "$source/examples/steady.info"
    here/bin/python -m pip uninstall --quiet --yes microslip
    ! here/bin/python -c "import microslip" 2>>log
    ;;
  wheel)
    python=$(python_with numpy, setuptools, wheel, venv, ensurepip) ||
      skip "no python3 with numpy, setuptools, wheel and venv"
    "$source/tools/wheel.sh" "$build" wheels "$python" || exit
    "$python" -m venv --system-site-packages here
    here/bin/python -m pip install --quiet --no-index --no-deps --disable-pip-version-check wheels/microslip-*.whl
    here/bin/python try.py "$source/examples/steady.info" inside
    ;;
esac
