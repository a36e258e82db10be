#!/usr/bin/env bash
# The API pages: no warning, and no formula that MathJax cannot set. Usage: api.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
for needed in doxygen chromium; do
  command -v "$needed" >/dev/null || { echo "skipped: $needed is not installed, see tools/deps.sh docs browser"; exit 77; }
done
[ -e /usr/share/javascript/mathjax ] || { echo "skipped: MathJax is not installed, see tools/deps.sh docs"; exit 77; }
tools/docs.sh
profile=$(mktemp -d)
times_of() { { grep -o "$1" "$profile/$page" || true; } | wc -l; }
trap 'rm -rf "$profile"' EXIT
for page in index classmicroslip_1_1StripKernel classmicroslip_1_1TransientRolling; do
  # A page on its own process: --dump-dom waits for the virtual time in which MathJax is done.
  timeout 120 chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking \
    --disable-component-update --disable-sync --disable-dev-shm-usage --user-data-dir="$profile" --allow-file-access-from-files \
    --virtual-time-budget=30000 --dump-dom "file://$PWD/build/docs/html/$page.html" >"$profile/$page" 2>/dev/null
  formulas=$(times_of 'class="MathJax[_ "]')
  errors=$(times_of 'class="[^"]*\(merror\|noError\)\|Undefined control sequence')
  echo "$page: $formulas formulas set, $errors errors"
  [ "$formulas" -gt 0 ] && [ "$errors" -eq 0 ]
done
