#!/usr/bin/env bash
# The machine of the Containerfile as a folder, by debootstrap and chroot, where there is no container engine. Needs root.
# Usage: DEPS_ARCHIVE=ADDRESS tools/rootfs.sh FOLDER [COMMAND ...], as tools/rootfs.sh /var/tmp/debian make quick
# FOLDER is made if it is not there; the project lies in FOLDER/microslip, without builds and results of this one.
set -euo pipefail
folder=$1
shift
root=$(cd "$(dirname "$0")/.." && pwd)
fail() {
  echo "rootfs: $1" >&2
  exit 1
}
[ -n "${DEPS_ARCHIVE:-}" ] || fail "expected DEPS_ARCHIVE, the address of a Debian archive, as that of one date"
command -v debootstrap >/dev/null || fail "no debootstrap; install the package of that name"
export DEPS_SUITE=${DEPS_SUITE:-bookworm} LC_ALL=C.UTF-8
if [ ! -e "$folder/packages.txt" ]; then
  rm -rf "$folder"
  debootstrap --variant=minbase "$DEPS_SUITE" "$folder" "$DEPS_ARCHIVE" >"$folder.log" 2>&1 || { tail -n 20 "$folder.log" >&2; fail "debootstrap failed"; }
  mkdir "$folder/microslip"
  tar -C "$root" --exclude=./build --exclude='./results/*' -c . | tar -C "$folder/microslip" -x
  chroot "$folder" /microslip/tools/deps.sh build figures report article
  chroot "$folder" dpkg-query -W >"$folder/packages.txt"
fi
echo "rootfs: $folder: $(wc -l <"$folder/packages.txt") packages"
[ $# -gt 0 ] || exit 0
# Programs look in /proc for the folder that they are in, and the shell for its pipes.
mount -t proc proc "$folder/proc" || fail "cannot mount $folder/proc"
trap 'umount "$folder/proc"' EXIT
DEPS=skip chroot "$folder" sh -c 'cd /microslip && exec "$@"' sh "$@"
