#!/usr/bin/env bash
# Tries the two commands of the README in a bare Debian 12: a root made by debootstrap, a fresh clone, nothing else.
#
#   bare_debian.sh [DIRECTORY]    keeps the root in DIRECTORY for another look; otherwise it is removed
#
# The Debian mirror is the one that this machine's apt uses. Needs root and debootstrap; exits with 77 (skipped) without.
set -euo pipefail

skip() { echo "skipped: $*"; exit 77; }
[ "$(id -u)" -eq 0 ] || skip "needs root for debootstrap and chroot"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"

# Mounts in a name space of our own disappear with this process, whatever happens.
if [ -z "${HARMOS_PRIVATE_MOUNTS:-}" ]; then
  HARMOS_PRIVATE_MOUNTS=1 exec unshare --mount --propagation private "$0" "$@"
fi

checkout=$(git -C "$(dirname "$0")" rev-parse --show-toplevel)
mirror=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME) $(COMPONENT)' 'Created-By: Packages' |
  awk '$2 == "bookworm" && $3 == "main" { print $1; exit }')
[ -n "$mirror" ] || skip "this machine's apt knows no mirror of Debian 12"

if [ $# -gt 0 ]; then
  root=$1
  mkdir -p "$root"
else
  root=$(mktemp -d)
  trap 'umount -R "$root/proc" "$root/dev" "$root/sys"; rm -rf --one-file-system "$root"' EXIT
fi

if [ ! -e "$root/etc/debian_version" ]; then
  echo "== debootstrap"
  debootstrap --variant=minbase bookworm "$root" "$mirror" >"$root.log" 2>&1 || { tail -n 20 "$root.log"; exit 1; }
  rm -f "$root.log"
fi
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mount --rbind /sys "$root/sys"
cp -L /etc/resolv.conf /etc/hosts "$root/etc/"
printf '#!/bin/sh\nexit 101\n' >"$root/usr/sbin/policy-rc.d"  # packages must not start services in the root
chmod +x "$root/usr/sbin/policy-rc.d"

rm -rf "$root/root/harmos"
git clone --quiet --no-hardlinks "$checkout" "$root/root/harmos"

# A login environment and nothing of this process, as a newcomer would have.
bare() {
  echo "== $*"
  env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    chroot "$root" /bin/bash -c 'cd /root/harmos && exec "$@"' bash "$@" </dev/null
}
bare drivers/harmos run xml/bolted_joint.xml
bare test -s results/bolted_joint.e
bare drivers/harmos test
