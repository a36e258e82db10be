#!/usr/bin/env bash
# The article as PDF, from tables of results. Usage: article.sh RESULTS OUTPUT.pdf WORK_FOLDER [NUMBERS.tex]
# The same tables give the same bytes. Numbers come from a file in their place if one is given, which is for tests.
set -euo pipefail
results=$1 output=$2 work=$3 numbers=${4-}
root=$(cd "$(dirname "$0")/../.." && pwd)
article=$root/article
fail() {
  echo "article: $1" >&2
  exit 1
}
command -v pdflatex >/dev/null || fail "no pdflatex; tools/deps.sh article installs it"
rm -rf "$work" "$output"
mkdir -p "$work" "$(dirname "$output")"
if [ -n "$numbers" ]; then
  cp "$numbers" "$work/numbers.tex"
else
  "$root/tools/article/article_numbers.py" "$results" "$article/article.tex" "$work/numbers.tex"
fi

for figure in $(grep -o '\\studyfigure{[a-z_]*}' "$article/article.tex" | sed 's/.*{\(.*\)}/\1/' | sort -u); do
  study=
  for folder in "$root"/studies/*/; do
    name=$(basename "$folder")
    [[ $figure != "$name"_* ]] || study=$name
  done
  [ -n "$study" ] || fail "$figure: of no study"
  "$root/plots/draw.sh" "$root/plots/$figure.gp" "$results/$study" "$work/$figure.pdf"
done

cp "$article"/*.tex "$article"/*.bib "$work"
cd "$work"
export SOURCE_DATE_EPOCH=0 FORCE_SOURCE_DATE=1
latex() { pdflatex -interaction=nonstopmode -halt-on-error article.tex >latex.log || { tail -n 30 latex.log >&2; fail "LaTeX failed"; }; }
latex
bibtex -terse article >bibtex.log || { cat bibtex.log >&2; fail "BibTeX failed"; }
latex
latex
! grep -E 'undefined|multiply defined|Rerun to' article.log >&2 || fail "references are not in order"
cd - >/dev/null
cp "$work/article.pdf" "$output"
