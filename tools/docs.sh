#!/usr/bin/env bash
# API pages in build/docs/html. Usage: tools/docs.sh
# A warning of Doxygen is a failure. Formulas are set by MathJax, which lies beside the pages: no network.
set -euo pipefail
cd "$(dirname "$0")/.."
mathjax=/usr/share/javascript/mathjax
[ -e "$mathjax/MathJax.js" ] || { echo "docs: $mathjax/MathJax.js: expected MathJax 2 there" >&2; exit 1; }
rm -rf build/docs
mkdir -p build/docs/html
doxygen docs/Doxyfile
ln -s "$mathjax" build/docs/html/mathjax
