#!/usr/bin/env bash
# ./run test site [FILE …]: the WebAssembly build against the native program, and every page in headless Chromium.
set -euo pipefail
cd "$(dirname "$0")/../.."

site/build.sh
cmake --build --preset release --target tps_web_native >&2
# playwright-core alone, as package-lock.json pins it: the browser is Debian's.
mkdir -p build/site-tools
cp site/package.json site/package-lock.json build/site-tools/
cmp -s site/package-lock.json build/site-tools/node_modules/.installed ||
  { npm ci --prefix build/site-tools --no-audit --no-fund --ignore-scripts >&2 && cp site/package-lock.json build/site-tools/node_modules/.installed; }
(( $# )) || set -- site/test/*.test.mjs
exec node --test "$@"
