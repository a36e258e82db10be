#!/usr/bin/env bash
# Draws one figure. Usage: plots/draw.sh FIGURE.gp TABLES_FOLDER OUTPUT.svg|OUTPUT.png|OUTPUT.pdf|OUTPUT.gif [COMMANDS]
# The last word has commands of gnuplot that come first.
# A gnuplot warning is a failure, as is a table without content, and a failure leaves no figure.
# The comment that the script begins with says what the figure shows, and becomes the title of an SVG.
set -euo pipefail
script=$1 tables=$2 output=$3 commands=${4-}
plots=$(dirname "$0")
fail() {
  echo "draw: $script: $1" >&2
  exit 1
}

format=${output##*.}
case "$format" in
  svg | png | pdf | gif) ;;
  *) fail "$output: expected a name that ends in .svg, .png, .pdf or .gif" ;;
esac
rm -f "$output"
command -v gnuplot >/dev/null || fail "gnuplot is not installed"
if [ "$format" = gif ]; then
  gnuplot -e 'set terminal gif animate' 2>/dev/null || fail "gnuplot has no terminal gif here; .svg, .png and .pdf do without"
fi

# All that the figure names, itself or in what it loads. gnuplot would say neither which table is
# empty nor that one is cut off between two rows.
mapfile -t loaded < <(sed -n "s|^load scripts\.\"/\(.*\)\"|$plots/\1|p" "$script")
for table in $(grep -oh '"/[a-z_]*\.tsv"' "$script" "${loaded[@]}" | tr -d '"' | sort -u); do
  table=$tables$table
  [ -r "$table" ] || fail "$table: no such table"
  [ -z "$(tail -c 1 "$table")" ] || fail "$table: cut off, its last line has no end"
  problem=$(awk -F '\t' '
    /^#/ { next }
    !columns { columns = NF; next }
    NF != columns { print "cut off, a row has " NF " cells, not " columns; exit }
    { rows++; for (i = 1; i <= NF; i++) if ($i !~ /^-?nan$/) cells++ }
    END { if (NF == columns || !rows) print !rows ? "no rows" : !cells ? "nothing but nan" : "" }' "$table")
  [ -z "$problem" ] || fail "$table: $problem"
done

caption=$(sed -n '/^#/! q; s/^# *//; s/&/\&amp;/g; s/</\&lt;/g; s/>/\&gt;/g; p' "$script" | paste -sd ' ')
[ -n "$caption" ] || fail "does not begin with a comment that says what it shows"

mkdir -p "$(dirname "$output")"
partial=$(dirname "$output")/.$(basename "$output").$$.part
trap 'rm -f "$partial" "$partial.log"' EXIT
status=0
titled() {
  if [ "$format" = svg ]; then
    caption=$caption awk '{ if (sub("<title>Gnuplot</title>", "")) print "<title>" ENVIRON["caption"] "</title>"; else print }'
  else
    cat
  fi
}
gnuplot -e "format='$format'; tables='${tables//\'/\'\'}'; scripts='${plots//\'/\'\'}'; $commands" "$plots/style.gp" "$script" 2>"$partial.log" |
  titled >"$partial" || status=$?
# gnuplot takes no notice of a full disk: is the end there?
case "$format" in
  svg) last="</svg>" ;;
  png) last=IEND ;;
  pdf) last="%%EOF" ;;
  gif) last=";$" ;;
esac
tail -c 10 "$partial" | grep -aq "$last" || status=1
# A line that gnuplot writes for every animation is no warning.
[ "$format" != gif ] || sed -i '/^[0-9]* frames in animation sequence$/d' "$partial.log"
if [ $status -ne 0 ] || [ -s "$partial.log" ]; then
  cat "$partial.log" >&2
  fail "gnuplot failed"
fi
mv "$partial" "$output"
