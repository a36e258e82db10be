#!/usr/bin/env bash
# Installs what the project needs and this machine lacks. Usage: tools/deps.sh GROUP ...
# Groups: build, figures, report, article, python, languages, notebook, wheels, docs, browser, package, bench, clang, coverage.
# Does nothing, and prints nothing, when all is there. DEPS=skip turns it off. DEPS_ARCHIVE is the address of a Debian
# archive, as that of one date, from which alone packages are taken then; DEPS_SUITE is its suite, bookworm if not given.
set -euo pipefail
[ "${DEPS:-}" = skip ] && exit 0

# Debian package, and a command or pattern of files that shows it is present
needs() {
  case "$1" in
    build) cat <<'LIST'
g++ g++
cmake cmake
make make
ninja-build ninja
libeigen3-dev /usr/include/eigen3/Eigen/Core
libboost-dev /usr/include/boost/algorithm/string/replace.hpp
libboost-program-options-dev /usr/lib/*/cmake/boost_program_options-*
libgsl-dev /usr/include/gsl/gsl_integration.h
libfftw3-dev /usr/include/fftw3.h
libfmt-dev /usr/include/fmt/core.h
libgtest-dev /usr/include/gtest/gtest.h
LIST
      ;;
    figures) echo "gnuplot-nox gnuplot" ;;
    report) cat <<'LIST'
python3 python3
python3-jinja2 /usr/lib/python3/dist-packages/jinja2
python3-markdown /usr/lib/python3/dist-packages/markdown
LIST
      ;;
    article) echo "texlive-latex-base pdflatex" ;;
    browser) printf '%s\n' "chromium chromium" "chromium-driver chromedriver" ;;
    bench) echo "libbenchmark-dev /usr/include/benchmark/benchmark.h" ;;
    clang) cat <<'LIST'
clang clang++
libclang-rt-14-dev /usr/lib/llvm-14/lib/clang/14.0.6/include/fuzzer/FuzzedDataProvider.h
LIST
      ;;
    coverage) echo "gcovr gcovr" ;;
    python) cat <<'LIST'
python3-numpy /usr/lib/python3/dist-packages/numpy
python3-pytest /usr/lib/python3/dist-packages/pytest
python3-pandas /usr/lib/python3/dist-packages/pandas
python3-matplotlib /usr/lib/python3/dist-packages/matplotlib
pkg-config pkg-config
LIST
      ;;
    languages) needs python; cat <<'LIST'
python3-pip /usr/lib/python3/dist-packages/pip
python3-venv /usr/share/doc/python3-venv
python3-setuptools /usr/lib/python3/dist-packages/setuptools
python3-wheel /usr/lib/python3/dist-packages/wheel
mypy mypy
octave-dev mkoctfile
LIST
      ;;
    notebook) cat <<'LIST'
python3-matplotlib /usr/lib/python3/dist-packages/matplotlib
python3-nbconvert /usr/lib/python3/dist-packages/nbconvert
python3-ipykernel /usr/lib/python3/dist-packages/ipykernel
LIST
      ;;
    wheels) cat <<'LIST'
python3-setuptools /usr/lib/python3/dist-packages/setuptools
python3-wheel /usr/lib/python3/dist-packages/wheel
binutils objdump
LIST
      ;;
    docs) printf '%s\n' "doxygen doxygen" "libjs-mathjax /usr/share/javascript/mathjax/MathJax.js" ;;
    package) echo "dpkg-dev dpkg-shlibdeps" ;;
    *) echo "deps.sh: unknown group '$1'; see tools/deps.sh" >&2; return 1 ;;
  esac
}

missing=()
for group in "$@"; do
  list=$(needs "$group")
  while read -r package probe; do
    case "$probe" in
      /*) compgen -G "$probe" >/dev/null || missing+=("$package") ;;
      *) command -v "$probe" >/dev/null || missing+=("$package") ;;
    esac
  done <<<"$list"
done
[ ${#missing[@]} -eq 0 ] && exit 0

echo "deps: installing ${missing[*]}"
command -v apt-get >/dev/null || {
  echo "deps: no apt-get here; install these yourself and run with DEPS=skip" >&2
  exit 1
}
sudo=
[ "$(id -u)" -eq 0 ] || sudo=sudo
log=$(mktemp)
sources=$(mktemp --suffix=.list)
trap 'rm -f "$log" "$sources"' EXIT
from=()
if [ -n "${DEPS_ARCHIVE:-}" ]; then
  echo "deb $DEPS_ARCHIVE ${DEPS_SUITE:-bookworm} main" >"$sources"
  chmod a+r "$sources"
  # A list of an old date is valid no longer, and no less right for that.
  from=(-o "Dir::Etc::sourcelist=$sources" -o Dir::Etc::sourceparts=- -o Acquire::Check-Valid-Until=false)
fi
if ! { $sudo apt-get "${from[@]}" update && DEBIAN_FRONTEND=noninteractive \
       $sudo apt-get "${from[@]}" install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
  tail -n 20 "$log" >&2
  echo "deps: apt-get failed" >&2
  exit 1
fi
