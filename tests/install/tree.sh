#!/usr/bin/env bash
# An installed tree works where it is put: programs, figures, man pages, completion.
# Usage: tree.sh CMAKE BUILD_FOLDER SOURCE_FOLDER WORK_FOLDER
set -euo pipefail
cmake=$1 build=$(realpath "$2") source=$(realpath "$3") work=$4
fail() {
  echo "$1" >&2
  exit 1
}
rm -rf "$work"
mkdir -p "$work/elsewhere"
"$cmake" --install "$build" --prefix "$work/first" >"$work/log"
mv "$work/first" "$work/a prefix"
prefix="$work/a prefix"
export PATH="$prefix/bin:$PATH"
cd "$work/elsewhere"

# A newcomer types these commands, with the installed programs and their scripts of figures.
[ "$(command -v microslip)" = "$prefix/bin/microslip" ] || fail "microslip is not installed"
microslip init steady >/dev/null
microslip explain steady.info >/dev/null
microslip steady.info
command -v gnuplot >/dev/null && { microslip plot >/dev/null; [ -s out.svg ] || fail "no figure"; }
microslip --version | grep -q "revision $(cat "$build/share/microslip/revision.txt")" || fail "no revision"

# All studies, with scene, scripts of figures and man page.
for scene in "$source"/studies/*/study.info; do
  study=$(basename "$(dirname "$scene")")
  "microslip-$study" --print-scene | cmp - "$prefix/share/microslip/studies/$study.info" || fail "$study"
  [ -f "$prefix/share/man/man1/microslip-$study.1" ] || fail "no man page of $study"
  grep -qxF ".B microslip\\-$study" "$prefix/share/man/man1/microslip-studies.1" || fail "$study has no entry"
  for script in "$source/plots/${study}"_*.gp; do
    [ -f "$prefix/share/microslip/plots/$(basename "$script")" ] || fail "not installed: $script"
  done
done
cmp "$source/tables/creep_forces.nc" "$prefix/share/microslip/creep_forces.nc" || fail "no table"
for script in sweep table; do
  cmp "$source/studies/$script.sbatch" "$prefix/share/microslip/$script.sbatch" || fail "no $script.sbatch"
done
microslip-carter --quick
[ -s results/carter/traction.tsv ] || fail "carter wrote nothing"

# Man pages, as far as there is a program that reads them, without warnings.
if command -v man >/dev/null; then
  for page in "$prefix"/share/man/man*/*; do
    warnings=$(cd "$prefix/share/man" && man --warnings -E UTF-8 -l "$page" 2>&1 >/dev/null)
    [ -z "$warnings" ] || fail "$page: $warnings"
  done
fi

# $1 what is typed; prints what TAB would offer.
completed() {
  COMP_LINE=$1 COMP_POINT=${#1} COMP_WORDS=("${1%% *}") COMP_WORDBREAKS=$' \t\n=:'
  local by=_microslip
  [[ ${COMP_WORDS[0]} == microslip ]] || by=_microslip_study
  $by
  echo "${COMPREPLY[*]}"
}
completions="$prefix/share/bash-completion/completions"
source "$completions/microslip"
expect() {
  [ "$(completed "$1")" = "$2" ] || fail "'$1' is completed to '$(completed "$1")', not '$2'"
}
expect 'microslip ex' 'explain'
expect 'microslip im' 'import'
expect 'microslip st' 'steady.info'
expect 'microslip init ' 'wheel ellipse line steady transient ellipse_transient cylinder run sweep'
expect 'microslip explain ' 'steady.info out results'
expect 'microslip plot o' 'out'
: >case.inp
expect 'microslip import ca' 'case.inp'
expect 'microslip import case.inp --scheme d' 'direct'
expect 'microslip steady.info --set contact.half_w' 'contact.half_width='
expect 'microslip sweep steady.info --th' '--threads'
expect 'microslip steady.info --set step.scheme=rel' 'relaxed relaxed_traction'
expect 'microslip steady.info --set=solver.type=' 'auto dense fft'
expect 'microslip steady.info --set load.force=' '-1500'
expect 'microslip steady.info --set grid.elements=' '100'
expect 'microslip steady.info --set solver.violation=' '0.05'
expect 'microslip --set solver.violation=' '0.05'
expect 'microslip steady.info --set contact.bound_file=ste' 'steady.info'
expect 'microslip sweep steady.info --set sw' 'sweep.'
expect 'microslip steady.info --set sw' ''
expect 'microslip curve steady.info --set sw' 'sweep.'
expect 'microslip sweep steady.info --set sweep.to' 'sweep.together.'
expect 'microslip sweep steady.info --set sweep.together_2.grid.e' 'sweep.together_2.grid.elements='
expect 'microslip sweep steady.info --set sweep.tab' 'sweep.table='
expect 'microslip sweep steady.info --set sweep.table=ste' 'steady.info'
expect 'microslip sweep steady.info --set sweep.grid.e' 'sweep.grid.elements='
expect 'microslip sweep steady.info --set sweep.kernel.type=p' 'plane'
expect 'microslip keys --format comp' 'completion'
expect 'microslip steady.info --format ' 'tsv csv'
expect 'microslip curve steady.info --beside ' 'nothing fastsim fastsim_one vermeulen_johnson polach'
expect 'microslip converge steady.info --reference f' 'fine'
microslip sweep steady.info --quiet --set 'sweep.load.force=-1 -2' >/dev/null
expect 'microslip plot out/sweep --over load' 'load.force'
expect 'microslip plot out/sweep --value cree' 'creepage'
expect 'microslip plot out/sweep --only load' 'load.force='
expect 'microslip-fourier_inverse --set grid.s' 'grid.spacing= grid.sizes='
expect 'microslip-fourier_inverse --quick --set basis=' 'both constant linear'
expect 'microslip-carter --print-keys=t' 'text'
# Every option that --help lists is offered.
for command in 'microslip' microslip\ {init,import,explain,response,curve,converge,table,plot,sweep,merge,keys} microslip-carter; do
  options=$($command --help | grep -oE '^  --[a-z-]+' | tr -d ' ')
  for option in $options; do  # of which one may be the beginning of others
    expect "$command $option" "$(grep -- "^$option" <<<"$options" | tr '\n' ' ' | sed 's/ $//')"
  done
done
# bash finds the completion of every study.
for study in "$prefix"/bin/microslip-*; do
  source "$completions/$(basename "$study")"
  complete -p "$(basename "$study")" >/dev/null || fail "no completion of $study"
done
