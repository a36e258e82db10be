#!/usr/bin/env bash
# Tests the answers of compare_tables about tables that were changed by hand.
# Usage: compare_tables.sh COMPARE_TABLES WORK_FOLDER
# shellcheck disable=SC2016,SC2053  # what is said is a pattern, and a quoted $ is one of sed
set -euo pipefail
compare=$1 work=$2
rm -rf "$work"
mkdir -p "$work/references" "$work/tables/study"
printf '%s\n' '# the column of counts is looser' '* * 1e-9 1e-12 0' 'study/* rounds 0 0 1' \
  >"$work/references/tolerances.txt"
table=$work/tables/study/result.tsv
original=$work/original.tsv
{
  printf '%s\n' '# study: a result' '# parameters' '#   a = 1' '# columns' '#   x [mm]: position' \
    '#   name [1]: of a scheme' '#   rounds [1]: until it settled' $'x\tname\trounds'
  for i in {1..1000}; do printf '%s.5\ta scheme of order 1.5\t7\n' "$i"; done
} >"$original"
cp "$original" "$table"
"$compare" --update "$work/tables" "$work/references" >/dev/null
kept=$(grep -vc '^#' "$work/references/study/result.tsv")
[ "$kept" -eq 301 ] || { echo "the reference has $kept lines" >&2; exit 1; }

# expect STATUS TEXT SED_SCRIPT: of the table changed by sed
expect() {
  local status=0 said
  sed "$3" "$original" >"$table"
  said=$("$compare" "$work/tables" "$work/references" 2>&1) || status=$?
  if [ $status -ne "$1" ] || [[ $said != $2 ]]; then
    echo "sed '$3': status $status, said: $said" >&2
    exit 1
  fi
}
worst='the largest difference is'
expect 0 'study/result: identical' ''
expect 0 "study/result: agrees: 1 cells within the tolerance; $worst 0.2* of it, in x in row 1: 1.5000000005, reference 1.5" 's/^1\.5\t/1.5000000005\t/'
expect 1 "study/result: differs: 1 cells beyond the tolerance; $worst 2* of it, in x in row 1: 1.500000005, reference 1.5" 's/^1\.5\t/1.500000005\t/'
expect 1 'study/result: differs: 1 cells beyond*in x in row 300: 1001.5, reference 1000.5' 's/^1000\.5/1001.5/'
expect 1 'study/result: differs: 1 cells beyond*: nan, reference 1.5' 's/^1\.5/nan/'
expect 0 'study/result: agrees: 1 cells *in rounds in row 1: 8, reference 7' '9s/7$/8/'
expect 1 'study/result: differs: 1 cells *in rounds in row 1: 9, reference 7' '9s/7$/9/'
expect 0 'study/result: agrees: 300 cells *in name *: a scheme of order 1.500000001, *' 's/r 1\.5/r 1.500000001/'
expect 1 'study/result: differs: 300 cells *in name *: a scheme of order 1.6, *' 's/r 1\.5/r 1.6/'
expect 1 'study/result: differs: 300 cells *in name *: a pattern of order 1.5, *' 's/scheme of/pattern of/'
expect 1 'study/result: differs: 300 cells *in name *: a scheme of order 1.5 and more, *' 's/r 1\.5/& and more/'
expect 1 "study/result: differs: parameter 'rows = 300 of 999', reference 'rows = 300 of 1000'" '$d'
expect 1 "study/result: differs: parameter 'a = 2', reference 'a = 1'" 's/a = 1/a = 2/'
expect 1 'study/result: differs: columns y \[mm\]*, reference x \[mm\]*' 's/#   x/#   y/; s/^x\t/y\t/'
expect 1 'study/result: differs: columns x \[m\]*' 's/\[mm\]/[m]/'
expect 1 'compare_tables: *result.tsv: expected *' '$s/\t.*//'

# A table that agrees stays as it is; another one becomes the reference.
update() {
  sed "$1" "$original" >"$table"
  "$compare" --update "$work/tables" "$work/references" >/dev/null
  grep -v '^#' "$work/references/study/result.tsv" | sed -n 2p
}
[ "$(update 's/^1\.5\t/1.5000000005\t/' | cut -f1)" = 1.5 ] || { echo "a table that agrees was written" >&2; exit 1; }
[ "$(update 's/^1\.5\t/1.6\t/' | cut -f1)" = 1.6 ] || { echo "a table that differs was not written" >&2; exit 1; }

# Numbers that are nothing but rounding: the reference has no digits of them, and they have a bound.
{
  printf '%s\n' '# study: a result' '# parameters' '# columns' '#   name [1]: of a quantity' \
    '#   value [see there]: of it' '#   residual [1]: of it' '# nothing but rounding' \
    '#   residual up to 1e-09' '#   value up to 1e-12 where name = small' $'name\tvalue\tresidual' \
    $'large\t2.5\t3e-11' $'small\t-4e-15\t0' $'odd\t7e-11\t0.5'
} >"$original"
cp "$original" "$table"
"$compare" --update "$work/tables" "$work/references" >/dev/null
expected=$'large\t2.5\trounding\nsmall\trounding\trounding\nodd\t7e-11\t0.5'
[ "$(tail -n 3 "$work/references/study/result.tsv")" = "$expected" ] || { echo "rounding has digits" >&2; exit 1; }
expect 0 'study/result: identical' ''
expect 0 'study/result: identical' 's/3e-11/9e-10/; s/-4e-15/8e-13/'
expect 0 'study/result: agrees: 1 cells *' 's/\t0\.5/\t0.5000000009/'
expect 1 'study/result: differs: 1 cells *in residual in row 3: 0.500000003, reference 0.5' 's/\t0\.5/\t0.500000003/'
expect 1 'study/result: differs: 1 cells *in residual in row 1: 2e-09, reference rounding' 's/3e-11/2e-09/'
expect 1 'study/result: differs: 1 cells *in value in row 2: -2e-12, reference rounding' 's/-4e-15/-2e-12/'
expect 1 'study/result: differs: 1 cells *in value in row 3: 8e-11, reference 7e-11' 's/7e-11/8e-11/'
expect 1 'study/result: differs: 1 cells *in residual in row 3: 1e-10, reference 0.5' 's/0\.5/1e-10/'
expect 1 'study/result: differs: residual in row 1 is rounding up to 1e-08, reference 1e-09' 's/1e-09/1e-08/'
expect 1 'study/result: differs: value in row 2 is rounding up to 0, reference 1e-12' '/where/d'
expect 1 'compare_tables: *result.tsv: expected *' 's/up to 1e-09/up to a lot/'

cp "$original" "$table"
cp "$original" "$work/tables/study/more.tsv"
cp "$original" "$work/tables/study/more_timing.tsv"
said=$("$compare" "$work/tables" "$work/references") && exit 1
[ "$said" = $'study/more: differs: no reference; make references makes it\nstudy/result: identical' ]
rm -r "$work/tables/study"
said=$("$compare" "$work/tables" "$work/references") && exit 1
[ "$said" = 'study/result: differs: no table' ]
echo '* x 1 1' >>"$work/references/tolerances.txt"
said=$("$compare" "$work/tables" "$work/references" 2>&1) && exit 1
[[ $said = "compare_tables: tolerances: '* x 1 1': expected "* ]]
