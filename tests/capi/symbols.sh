#!/usr/bin/env bash
# The shared library defines what its headers declare, and nothing else.
# Usage: symbols.sh NM LIBRARY HEADER...
set -euo pipefail
nm=$1 library=$2
declared=$(grep -hoE 'microslip_[a-z_]+\(' "${@:3}" | tr -d '(' | sort -u)
defined=$("$nm" -D --defined-only "$library" | awk '{ print $3 }' | sort -u)
diff <(echo "$declared") <(echo "$defined") || { echo "< declared, > defined" >&2; exit 1; }
