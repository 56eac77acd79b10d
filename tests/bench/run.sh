#!/usr/bin/env bash
# Times one step of the packed scene on Nilas, Bullet and ODE in turn and prints the table with ratios and growth exponents.
# usage: tests/bench/run.sh [packed|kernels|help]      (through ./dev bench)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
bin=build/bench
out=$bin/packed

packed() {
  local rounds=${ROUNDS:-3} floes sweeps round
  for floes in 200 1000 4000; do
    [ -f "$out/packed-$floes.txt" ] || "$bin/bench_packed" write "$floes" "$out"
  done
  local rows=$out/rows.csv
  echo "engine,floes,sweeps,detect_ms,solve_ms,water_ms,total_ms,contacts,penetration_max_over_thickness" >"$rows"
  # In turn, so that a change in the machine's speed meets all three.
  for round in $(seq "$rounds"); do
    for floes in 200 1000 4000; do
      for sweeps in 10 50 200; do
        "$bin/bench_packed" run "$out" "$floes" "$sweeps" >>"$rows"
        "$bin/peer_bullet" "$out/packed-$floes.txt" "$sweeps" >>"$rows"
        "$bin/peer_ode" "$out/packed-$floes.txt" "$sweeps" >>"$rows"
      done
    done
  done
  awk -F, -f tests/bench/table.awk "$rows"
  echo "rows: $rows"
}

case "${1:-packed}" in
  packed) packed ;;
  kernels) shift; "$bin/bench_kernels" "$@" ;;
  *) echo "usage: ./dev bench [packed|kernels]   ROUNDS=n sets how often the packed table is measured (3)" ;;
esac
