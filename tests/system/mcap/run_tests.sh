#!/bin/sh
# Runs the tests, or says what they lack and returns 77. Once before: npm ci in this folder.
cd "$(dirname "$0")" || exit 1
skip() { echo "skipped: $1"; exit 77; }
command -v node >/dev/null || skip "node is not installed (Debian: nodejs)"
[ -d node_modules/@mcap/core ] || skip "@mcap/core is not installed: run npm ci in tests/system/mcap"
node --test mcap.test.js
