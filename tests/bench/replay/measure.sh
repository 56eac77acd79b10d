#!/usr/bin/env bash
# Measures the replay of towing runs with about 100, 1000 and 10 000 floes: its size, what it costs the run, and how fast
# the page is in a browser that draws by software.
# usage: tests/bench/replay/measure.sh BENCH_REPLAY_COST PAGE_FOLDER OUT [SIZES]
#   PAGE_FOLDER: the page with its packages, as the build has it in apps/view_page
set -euo pipefail
bench=$1 page=$2 out=$3
shift 3
echo "| floes | frames | contacts | MB | bytes a body and frame | step [ms] | frame [ms] | share of the run |"
echo "|---|---|---|---|---|---|---|---|"
files=()
[ $# -gt 0 ] || set -- 100 1000 10000
for size in "$@"; do
  case $size in
    100) length=8 width=4 until=10 ;;
    1000) length=32 width=10 until=10 ;;
    10000) length=100 width=32 until=1 ;;
    *) echo "sizes are 100, 1000 and 10000" >&2 && exit 2 ;;
  esac
  "$bench" apps/scenes/towing.xml "$until" "$out/$size" "tank/@length=$((length + 6))" "tank/@width=$width" \
    "ice/field/@region=5 -$((width / 2)) $((length + 5)) $((width / 2))"
  files+=("$out/$size/replay.bin")
done
node "$page/test/measure.mjs" 20 "${files[@]}"
