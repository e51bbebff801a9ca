#!/usr/bin/env bash
# The site, into build/site: ./run site [--serve [PORT]].
set -euo pipefail
cd "$(dirname "$0")/.."

say() { printf '%s\n' "site: $*" >&2; }

# The reference as WebAssembly. Emscripten of Debian looks for acorn where Debian's Node.js does.
build_webassembly() {
  local toolchain=/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake
  export NODE_PATH=/usr/share/nodejs
  [[ -f build/wasm/build.ninja ]] || say "compiling the reference to WebAssembly; the first time takes about two minutes on two cores"
  cmake -S site/wasm -B build/wasm -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_TOOLCHAIN_FILE="$toolchain" >/dev/null
  cmake --build build/wasm --target tps_web >&2
}

build_webassembly
[[ ${1-} == --webassembly ]] && exit
python3 site/assemble.py build/site-sources build/wasm build/release/tps
mkdocs --quiet build --clean --config-file site/mkdocs.yml --site-dir "$PWD/build/site"
rm -f build/site/sitemap.xml*  # of addresses, which a folder of files has not
say "open build/site/index.html"
if [[ ${1-} == --serve ]]; then
  port=${2-8000}
  say "serving on http://127.0.0.1:$port (Ctrl-C ends it)"
  exec python3 -m http.server --bind 127.0.0.1 --directory build/site "$port"
fi
