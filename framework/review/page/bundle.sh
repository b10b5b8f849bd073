#!/bin/sh
# Bundles the page's modules, and those that it shares with the page of `opal view`, into one script: bundle.sh OUT.
set -eu
folder=$(cd "$(dirname "$0")" && pwd)
exec esbuild "$folder/main.js" --bundle --format=iife --minify --target=es2020 --charset=utf8 --log-level=warning "--outfile=$1"
