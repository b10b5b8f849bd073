#!/bin/sh
# Bundles the page's modules into one script: bundle.sh OUT [MODULES], by default where Debian keeps the modules of d3.
set -eu
folder=$(cd "$(dirname "$0")" && pwd)
NODE_PATH=${2:-/usr/share/nodejs} exec esbuild "$folder/main.js" --bundle --format=iife --minify --target=es2020 --charset=utf8 \
  --log-level=warning "--outfile=$1"
