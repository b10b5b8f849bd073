#!/usr/bin/env bash
# The packages on a bare Debian 12 that is made for this and goes away: OPAL_PACKAGES=FOLDER test_packages.sh
# FOLDER holds the packages and a file Packages, as `./run package` makes them. Ends with 77 if it cannot be tried here.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
packages=${OPAL_PACKAGES:-}

skip() {
  echo "skipped: $1"
  exit 77
}

[ -n "$packages" ] || skip "OPAL_PACKAGES names no folder with packages; ./run package makes some and runs this test"
ls "$packages"/*.deb >/dev/null 2>&1 || skip "no packages in $packages; ./run package makes them"
command -v mmdebstrap >/dev/null || skip "no mmdebstrap; apt-get install mmdebstrap"

# The mirror that this machine uses.
mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Codename: bookworm' 'Component: main' 'Created-By: Packages' | head -n 1)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/srv"
cp -r "$packages" "$work/srv/packages"
cp -r "$here/inside" "$work/srv/test"
chmod -R a+rX "$work"

# Hooks run in every mode of mmdebstrap (root, unshare), and the system goes away by itself.
mmdebstrap --variant=apt --quiet \
  --customize-hook="copy-in $work/srv/packages $work/srv/test /srv" \
  --customize-hook='chroot "$1" bash /srv/test/steps.sh' \
  bookworm /dev/null "${mirror:-http://deb.debian.org/debian}"
