#!/usr/bin/env bash
# ./run fuzz --minutes N [TARGET…]: explores each target for N minutes from the committed seeds. What it finds stays in
# build/fuzz/found; inputs that reach new code in build/fuzz/corpus.
set -euo pipefail
cd "$(dirname "$0")/../.."
readonly build=build/fuzz

minutes=1
targets=()
while (( $# )); do
  case "$1" in
    --minutes) minutes=${2:?--minutes needs a number}; shift 2 ;;
    *) targets+=("$1"); shift ;;
  esac
done
[[ $minutes =~ ^[0-9]+$ ]] || { echo "run fuzz: --minutes takes a whole number, not '$minutes'" >&2; exit 2; }
command -v clang++ >/dev/null || { echo "run fuzz: needs the packages of .ci/packages-fuzz.txt" >&2; exit 2; }

(( ${#targets[@]} )) || mapfile -t targets < <(ls tests/fuzz/corpus)
programs=("${targets[@]/#/fuzz_}")
[[ -f $build/build.ninja ]] || cmake --preset fuzz >/dev/null
cmake --build --preset fuzz --target "${programs[@]}" >&2

found=0
for target in "${targets[@]}"; do
  mkdir -p "$build/corpus/$target" "$build/found"
  echo "run fuzz: $target, $minutes min" >&2
  "$build/tests/fuzz/fuzz_$target" -max_total_time=$((60 * minutes)) -dict=tests/fuzz/json.dict -max_len=20000 -print_funcs=0 -timeout=30 \
    -rss_limit_mb=2048 -artifact_prefix="$build/found/$target-" -print_final_stats=1 \
    "$build/corpus/$target" "tests/fuzz/corpus/$target" >"$build/$target.log" 2>&1 || { found=1; tail -n 40 "$build/$target.log" >&2; }
  awk -v name="$target" '/number_of_executed_units/ {n = $2} /peak_rss_mb/ {m = $2} END {printf "%-12s %12d inputs, %5d MB at most\n", name, n, m}' \
    "$build/$target.log"
done
exit $found
