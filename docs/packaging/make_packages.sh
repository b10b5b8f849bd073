#!/usr/bin/env bash
# Debian packages of Opal in out/packages, which is also a source for apt: what `./run package` runs.
#   make_packages.sh          build, look at them with lintian
#   make_packages.sh --again  build a second time elsewhere, without a cache, and compare every file byte by byte
set -euo pipefail
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
jobs=${OPAL_JOBS:-$(nproc)}
work=$root/out/package
packages=$root/out/packages
sources=(CMakeLists.txt framework plugins patterns maps configs docs README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md LICENSE)
version=$(sed -n '1s/.*(\(.*\)).*/\1/p' "$root/docs/packaging/debian/changelog")

# Packages and CMake must not disagree on what this is.
check_version() {
  local built
  built=$(sed -n 's/^project(opal VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt")
  [ "$version" = "$built" ] && return
  echo "docs/packaging/debian/changelog: version $version, expected $built as in CMakeLists.txt" >&2
  return 1
}

# Files have the date of the changelog, whenever they came onto this machine.
date_of_sources=$(sed -n '/^ -- /{s/.*>  //p;q}' "$root/docs/packaging/debian/changelog")

# The tree as Debian's tools want it: debian/ at the root of the sources. Files that git does not know stay behind.
lay_out() {  # FOLDER
  rm -rf "$1"
  mkdir -p "$1"
  if git -C "$root" rev-parse --git-dir >/dev/null 2>&1; then
    git -C "$root" ls-files -z --cached --others --exclude-standard -- "${sources[@]}" |
      tar -C "$root" --null --verbatim-files-from --files-from=- --mtime="$date_of_sources" -c | tar -C "$1" -x
  else
    tar -C "$root" --exclude=node_modules --exclude=__pycache__ --mtime="$date_of_sources" -c "${sources[@]}" |
      tar -C "$1" -x
  fi
  cp -r "$1/docs/packaging/debian" "$1/debian"
}

build_in() {  # FOLDER LOG
  lay_out "$1"
  echo "building in $1 (log: $2)"
  if ! (cd "$1" && dpkg-buildpackage --build=binary --no-sign --jobs="$jobs") >"$2" 2>&1 </dev/null; then
    tail -n 40 "$2"
    return 1
  fi
  ! grep ' is not there$' "$2"  # a link of a page: Doxygen does not end when its filter does
}

# What was compiled before serves again; debhelper sets HOME, so the cache is named.
build_first() {
  local cache
  if command -v ccache >/dev/null; then
    cache=$(ccache --get-config cache_dir)
    export CCACHE_DIR=$cache CCACHE_BASEDIR=$work/opal-$version CMAKE_C_COMPILER_LAUNCHER=ccache CMAKE_CXX_COMPILER_LAUNCHER=ccache
  fi
  build_in "$work/opal-$version" "$work/build.log"
}

collect() {
  rm -rf "$packages"
  mkdir -p "$packages"
  cp "$work"/*.deb "$packages"
  dpkg-deb --fsys-tarfile "$packages/opal_${version}"_*.deb | tar -xO ./usr/share/doc/opal/opal.spdx.json >"$packages/opal.spdx.json"
  (cd "$packages" && sha256sum -- *.deb >SHA256SUMS && dpkg-scanpackages --multiversion . /dev/null 2>/dev/null | tee Packages | gzip -9n >Packages.gz)
}

# Another folder, no cache, another language, time zone and umask: the packages must not show where and how they were made.
build_again() {
  local other
  other=$(mktemp -d /var/tmp/opal-built-again-XXXXXX)
  (umask 002 && unset CMAKE_C_COMPILER_LAUNCHER CMAKE_CXX_COMPILER_LAUNCHER &&
    CCACHE_DISABLE=1 TZ=Pacific/Auckland LC_ALL=C.UTF-8 build_in "$other/elsewhere/opal-$version" "$work/again.log")
  if (cd "$other/elsewhere" && sha256sum --check "$packages/SHA256SUMS"); then
    echo "both builds made the same packages, byte by byte"
    rm -rf "$other"
  else
    echo "the builds differ: compare $packages and $other/elsewhere, for example with diffoscope" >&2
    return 1
  fi
}

show_sizes() {
  local file
  for file in "$packages"/*.deb; do
    printf '%-46s %8d kB, installed %8d kB\n' "${file##*/}" $(($(stat -c %s "$file") / 1000)) "$(dpkg-deb -f "$file" Installed-Size)"
  done
}

check_version
mkdir -p "$work"
rm -f "$work"/*.deb "$work"/*.buildinfo "$work"/*.changes
build_first
collect
show_sizes
lintian --fail-on error --info --display-info "$work/opal_${version}"_*.changes >"$work/lintian.log" 2>&1 ||
  { grep '^E' "$work/lintian.log"; exit 1; }
echo "lintian: no errors, $(grep -c '^W' "$work/lintian.log" || true) warnings (log: $work/lintian.log)"
case ${1:-} in --again) build_again ;; esac
