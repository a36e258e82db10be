#!/usr/bin/env bash
# The Debian packages: what they need is in Debian, and dpkg unpacks, configures and removes them. Into a
# folder of its own, so that the machine stays as it is. Status 77 where Debian's tools are missing.
# Usage: package.sh CPACK BUILD_FOLDER WORK_FOLDER
set -euo pipefail
cpack=$1 build=$2 work=$3
for tool in dpkg-deb dpkg-shlibdeps; do
  command -v "$tool" >/dev/null || { echo "skipped: no $tool (tools/deps.sh package installs it)"; exit 77; }
done
fail() {
  echo "$1" >&2
  exit 1
}
rm -rf "$work"
mkdir -p "$work"
"$cpack" --config "$build/CPackConfig.cmake" -B "$work" >"$work/log" 2>&1 || { cat "$work/log"; exit 1; }
package=$(ls "$work"/microslip_*.deb)
of_python=$(ls "$work"/python3-microslip_*.deb)

# $1 a package, $@ what it depends on, and no other than this build used
expect_depends() {
  local depends name
  depends=$(dpkg-deb --field "$1" Depends)
  echo "$(basename "$1"): $depends"
  for name in "${@:2}"; do
    grep -q "$name" <<<"$depends" || fail "does not depend on $name"
  done
  while read -r name; do
    dpkg --status "$name" >/dev/null 2>&1 || fail "depends on $name, which this build did not use"
  done < <(tr ',' '\n' <<<"$depends" | awk '{ print $1 }' | grep -vx python3-numpy)
}
expect_depends "$package" libc6 libfftw3 libgsl libfmt libboost-program-options
expect_depends "$of_python" libc6 libfftw3 libgsl libfmt python3-numpy
! dpkg-deb --contents "$package" | grep -q python3/ || fail "the programs' package has that of Python"

# Not as another user, and without a database of the machine's packages: their place is taken by
# --force-depends.
root=$work/root
mkdir -p "$root/var/lib/dpkg/"{info,updates,triggers,parts}
touch "$root/var/lib/dpkg/"{status,available}
dpkg_there() {
  dpkg --root="$root" --force-not-root --force-depends --force-script-chrootless --log="$work/dpkg.log" "$@" \
    >>"$work/log" 2>&1 || { cat "$work/log"; fail "dpkg $1 failed"; }
}
dpkg_there --install "$package" "$of_python"
[ "$(dpkg-query --admindir="$root/var/lib/dpkg" --showformat '${Status}' --show microslip)" = "install ok installed" ] ||
  fail "not installed"
"$root/usr/bin/microslip" --version
(cd "$work" && "$root/usr/bin/microslip" init steady && "$root/usr/bin/microslip" steady.info) >/dev/null
nm -D --defined-only "$(find "$root/usr/lib" -name libmicroslip.so)" | grep -q microslip_create || fail "no C interface"
# dpkg's own Python, if it has numpy.
if /usr/bin/python3 -c "import numpy" 2>>"$work/log"; then
  PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$root/usr/lib/python3/dist-packages /usr/bin/python3 -c "
import microslip as ms
assert ms.__file__.startswith('$root'), ms.__file__
print(ms.solve('$work/steady.info'), ms.CreepTable())"
fi
dpkg_there --remove microslip python3-microslip
left=$(find "$root/usr" -not -type d 2>/dev/null || true)
[ -z "$left" ] || fail "left behind: $left"
