#!/bin/sh
# Runs the browser tests, or says what they lack and returns 77. Once before: npm ci in this folder.
cd "$(dirname "$0")" || exit 1
skip() { echo "skipped: $1"; exit 77; }
command -v node >/dev/null || skip "node is not installed (Debian: nodejs)"
command -v esbuild >/dev/null || skip "esbuild is not installed (Debian: esbuild)"
[ -x "${OPAL_CHROMIUM:-/usr/bin/chromium}" ] || skip "chromium is not installed (Debian: chromium)"
[ -e /usr/share/javascript/dygraphs/dygraph.min.js ] || skip "dygraphs is not installed (Debian: libjs-dygraphs)"
[ -d node_modules/playwright-core ] || skip "playwright-core is not installed: run npm ci in tests/system/browser"
# One file at a time: every one of them runs a browser of its own.
for file in *.test.js; do
  node --test "$file" || failed=yes
done
[ -z "${failed:-}" ]
