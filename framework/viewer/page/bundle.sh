#!/bin/sh
# Bundles the page's modules into one script: bundle.sh OUT [DYGRAPHS], by default that of Debian's libjs-dygraphs.
set -eu
folder=$(cd "$(dirname "$0")" && pwd)
exec esbuild "$folder/main.js" --bundle --format=iife --minify --target=es2020 --charset=utf8 --log-level=warning \
  "--alias:dygraphs=${2:-/usr/share/javascript/dygraphs/dygraph.min.js}" "--outfile=$1"
