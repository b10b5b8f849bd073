#!/bin/sh
# Bundles the page's modules into one script: bundle.sh OUT [DYGRAPHS], the folder of Debian's libjs-dygraphs by default.
set -eu
folder=$(cd "$(dirname "$0")" && pwd)
exec esbuild "$folder/main.js" --bundle --format=iife --minify --target=es2020 --charset=utf8 --log-level=warning \
  "--alias:dygraphs=${2:-/usr/share/javascript/dygraphs}" "--outfile=$1"
