#!/usr/bin/env bash
# The Debian package: what it needs is in Debian, and dpkg unpacks, configures and removes it. Into a
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
depends=$(dpkg-deb --field "$package" Depends)
echo "$(basename "$package"): $depends"
for library in libc6 libfftw3 libgsl libfmt libboost-program-options; do
  grep -q "$library" <<<"$depends" || fail "does not depend on $library"
done
while read -r name; do
  dpkg --status "$name" >/dev/null 2>&1 || fail "depends on $name, which this build did not use"
done < <(tr ',' '\n' <<<"$depends" | awk '{ print $1 }')

# Not as another user, and without a database of the machine's packages: their place is taken by
# --force-depends.
root=$work/root
mkdir -p "$root/var/lib/dpkg/"{info,updates,triggers,parts}
touch "$root/var/lib/dpkg/"{status,available}
dpkg_there() {
  dpkg --root="$root" --force-not-root --force-depends --force-script-chrootless --log="$work/dpkg.log" "$@" \
    >>"$work/log" 2>&1 || { cat "$work/log"; fail "dpkg $1 failed"; }
}
dpkg_there --install "$package"
[ "$(dpkg-query --admindir="$root/var/lib/dpkg" --showformat '${Status}' --show microslip)" = "install ok installed" ] ||
  fail "not installed"
"$root/usr/bin/microslip" --version
(cd "$work" && "$root/usr/bin/microslip" init steady && "$root/usr/bin/microslip" steady.info) >/dev/null
nm -D --defined-only "$(find "$root/usr/lib" -name libmicroslip.so)" | grep -q microslip_create || fail "no C interface"
dpkg_there --remove microslip
left=$(find "$root/usr" -not -type d 2>/dev/null || true)
[ -z "$left" ] || fail "left behind: $left"
