#!/usr/bin/env bash
# The shared library defines what its header declares, and nothing else.
# Usage: symbols.sh NM LIBRARY HEADER
set -euo pipefail
nm=$1 library=$2 header=$3
declared=$(grep -oE 'microslip_[a-z_]+\(' "$header" | tr -d '(' | sort -u)
defined=$("$nm" -D --defined-only "$library" | awk '{ print $3 }' | sort -u)
diff <(echo "$declared") <(echo "$defined") || { echo "< declared, > defined" >&2; exit 1; }
