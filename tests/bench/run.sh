#!/usr/bin/env bash
# Times one step of the packed scene on Nilas, Bullet and ODE in turn and prints the table with ratios and growth exponents.
# `front` sets the residual of every engine and solver beside its cost on the jam, at two frictions; `loads` says how far the load
# of one step is off there.
# `solvers` times every contact solver and Siconos' on stored problems and draws what it finds.
# `collision TABLE` shows what contact search gets right, what it costs and how it grows; without TABLE all of them.
# `presawn` runs the pre-sawn scenes to their ends on two hull meshes, with twins.
# `symmetry` runs them with several solvers and tells how far their two sides differ, and how fast that grows.
# `level-ice TABLE` tows through ice that breaks, over thicknesses and speeds, steps, hull meshes, and in broken ice.
# `hull` prepares five hulls from users' files, stage by stage, and fails where one takes too long or is worse than recorded.
# `replay` measures the replay of towing runs: its size, what it costs the run, and how fast its page is.
# `size` measures time, memory and bytes of output of fields of up to a million floes.
# `cut` makes random cuts of floes, ordinary and adversarial, and shows what each kind keeps and costs.
# usage: tests/bench/run.sh [packed|exact|front|loads|solvers|scaling|threads|collision|field|presawn|symmetry|level-ice|load-coverage|load-statistics|hull|cut|replay|size|kernels|help]      (through ./dev bench)
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
bin=build/bench
out=$bin/packed

load_statistics() {
  local scripts=tests/bench/load_statistics study
  export PYTHONPATH=python
  for study in "$scripts"/*.yaml; do
    "$bin/nilas" study "$study" -j "${JOBS:-2}" --no-page
  done
  /usr/bin/python3 "$scripts/judge_coverage.py" runs/coverage-{pack,ship,breaking,drift}
  /usr/bin/python3 "$scripts/judge_peaks.py" runs/peaks-{pack,ship,crushing,presawn}
  /usr/bin/python3 "$scripts/judge_return_levels.py"
}

packed() {
  local rounds=${ROUNDS:-3} floes sweeps round
  for floes in 200 1000 4000; do
    [ -f "$out/packed-$floes.txt" ] || "$bin/bench_packed" write "$floes" "$out"
  done
  local rows=$out/rows.csv
  echo "engine,floes,sweeps,detect_ms,solve_ms,water_ms,total_ms,contacts,penetration_max_over_thickness,total_ms_95,natural_map_m_s,missed_steps" >"$rows"
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

# auto on the exact cone beside ODE and Bullet at 50 sweeps and MuJoCo's Newton; what takes too long says so.
exact() {
  local rows=$bin/packed/exact.csv floes limit=${LIMIT:-600} python=${PYTHON:-/usr/bin/python3} mujoco=yes
  "$python" -c 'import mujoco' 2>/dev/null || { mujoco=no && echo "mujoco: Python package not found, left out"; }
  echo "engine,floes,sweeps,detect_ms,solve_ms,water_ms,total_ms,contacts,penetration_max_over_thickness,total_ms_95,natural_map_m_s,missed_steps" >"$rows"
  for floes in ${SIZES:-200 1000 4000}; do
    [ -f "$bin/packed/packed-$floes.txt" ] || "$bin/bench_packed" write "$floes" "$bin/packed"
    timeout "$limit" "$bin/bench_packed" run "$bin/packed" "$floes" 0 >>"$rows" || echo "auto on $floes floes: not within $limit s"
    timeout "$limit" "$bin/bench_packed" run "$bin/packed" "$floes" cold >>"$rows" || echo "without warm start: not within $limit s"
    "$bin/peer_ode" "$bin/packed/packed-$floes.txt" 50 >>"$rows"
    "$bin/peer_bullet" "$bin/packed/packed-$floes.txt" 50 >>"$rows"
    [ $mujoco = no ] || "$python" tests/bench/peers/mujoco_peer.py "$bin/packed/packed-$floes.txt" "${LIMIT:-300}" >>"$rows" || true
  done
  awk -F, -f tests/bench/table.awk "$rows"
}

# What each engine, solver and tolerance costs on the jam of 966 floes, and the residual that it leaves; then friction 0.3.
# docs/figures/jam_front.py draws the rows from docs/evidence/data/jam-front.csv.
front() {
  local rows=$bin/packed/front.csv limit=${LIMIT:-600} python=${PYTHON:-/usr/bin/python3} sweeps solver tolerance
  local scene=$bin/packed/packed-1000.txt
  [ -f "$scene" ] || "$bin/bench_packed" write 1000 "$bin/packed"
  echo "engine,floes,sweeps,detect_ms,solve_ms,water_ms,total_ms,contacts,penetration_max_over_thickness,total_ms_95,natural_map_m_s,missed_steps" >"$rows"
  for sweeps in 10 50 200 1000; do
    "$bin/bench_packed" run "$bin/packed" 1000 "$sweeps" >>"$rows"
    "$bin/peer_ode" "$scene" "$sweeps" >>"$rows"
    "$bin/peer_bullet" "$scene" "$sweeps" >>"$rows"
  done
  for solver in nsgs auto; do
    for tolerance in 1e-2 1e-3 1e-4 1e-6; do
      timeout "$limit" "$bin/bench_packed" run "$bin/packed" 1000 0 $tolerance 0.15 $solver >>"$rows" ||
        echo "$solver to $tolerance: not within $limit s"
    done
  done
  for tolerance in 1e-4 1e-6; do
    "$bin/bench_packed" run "$bin/packed" 1000 0 $tolerance 0.3 >>"$rows"
    for friction in 0.15 0.3; do THREADS=2 "$bin/bench_packed" run "$bin/packed" 1000 0 $tolerance $friction >>"$rows"; done
  done
  if "$python" -c 'import mujoco' 2>/dev/null; then
    "$python" tests/bench/peers/mujoco_peer.py "$scene" "${LIMIT:-300}" >>"$rows" || true
  fi
  cat "$rows"
}

# How far the hull load of one step is off on the jam of 966 floes, by a second solution of each step.
loads() {
  local rows=$bin/packed/loads.csv sweeps solver tolerance
  [ -f "$bin/packed/packed-1000.txt" ] || "$bin/bench_packed" write 1000 "$bin/packed"
  echo "engine,floes,sweeps,checked_steps,unsolved_steps,mean_N,error_median_1,error_p95_1" >"$rows"
  for sweeps in 10 50 200; do "$bin/bench_packed" load "$bin/packed" 1000 "$sweeps" >>"$rows"; done
  for solver in nsgs auto; do
    for tolerance in 1e-2 1e-3 1e-4; do
      "$bin/bench_packed" load "$bin/packed" 1000 0 $tolerance 0.15 $solver >>"$rows"
    done
  done
  for tolerance in 1e-3 1e-4; do "$bin/bench_packed" load "$bin/packed" 1000 0 $tolerance 0.3 >>"$rows"; done
  cat "$rows"
}

# Problems: those of NILAS_FCLIB_DIR where that is set, and the worst steps of runs made here.
solvers() {
  local out=$bin/solvers rows=$bin/solvers/rows.csv scene files=()
  mkdir -p "$out"
  for scene in towing mirror-25 presawn-a; do
    [ -f "$out/$scene/summary.json" ] ||
      "$bin/nilas" run "apps/scenes/$scene.xml" --until 4 --set output/@problems=worst --out "$out/$scene" --force >/dev/null
    for file in "$out/$scene"/problems/*.hdf5; do
      [ -f "$file" ] && cp "$file" "$out/$scene-$(basename "$file")" && files+=("$out/$scene-$(basename "$file")")
    done
  done
  if [ -n "${NILAS_FCLIB_DIR:-}" ]; then files+=("$NILAS_FCLIB_DIR"/*.hdf5); fi
  echo "problem,contacts,velocities,solver,asked,status,iterations,seconds,natural_map_m_s" >"$rows"
  OPENBLAS_NUM_THREADS=1 OMP_NUM_THREADS=1 "$bin/bench_solvers" "${LIMIT:-5}" "${files[@]}" >>"$rows"
  /usr/bin/python3 tests/bench/solvers_table.py "$rows" "$out"
  echo "rows: $rows"
}

collision() {
  local bench=$bin/bench_collision threads=${THREADS:-$(nproc)} table
  case "${1:-all}" in
    classes) "$bench" classes "${BATCHES:-100}" "$threads" nilas ${CLASS:+"$CLASS"} ;;
    classes-fcl) "$bench" classes "${BATCHES:-100}" "$threads" fcl ${CLASS:+"$CLASS"} || true ;;  # FCL's errors are what it shows
    narrow) "$bin/bench_narrow_phase" "${UNTIL:-5}" ${SCENES:-apps/scenes/*.xml} ;;
    plates) for crowd in 1 150; do "$bin/bench_thin_plates" "${PAIRS:-100000}" "$crowd"; done ;;
    peers) "$bench" peers "${PAIRS:-1000}" "${ROUNDS:-5}" ;;
    steps) "$bench" steps "${STEPS:-100}" ${SIZES:-1000 4000 10000} ;;
    threads) "$bench" threads "${SIZES:-4000}" "${THREADS:-2}" "${STEPS:-100}" ;;
    swept) "$bin/bench_collision_swept" "${PAIRS:-100000}" ;;
    all) for table in peers steps threads swept plates narrow classes classes-fcl; do collision "$table"; done ;;
    *) echo "collision knows the tables classes, classes-fcl, narrow, peers, plates, steps, swept and threads" >&2 && return 2 ;;
  esac
}

case "${1:-packed}" in
  collision) collision "${2:-all}" ;;
  exact) exact ;;
  front) front ;;
  loads) loads ;;
  solvers) solvers ;;
  packed) packed ;;
  scaling) "$bin/bench_scaling" "${LIMIT:-60}" "${TOLERANCE:-1e-6}" ${SIZES:-100 1000 10000 100000} ;;
  threads) "$bin/bench_threads" "${SIZES:-10000}" "${THREADS:-2}" "${ROUNDS:-5}" ;;
  field) "$bin/bench_field" ${SIZES:-1000 3000 10000} ;;
  level-ice) "$bin/bench_level_ice" "${2:-loads}" "${TWINS:-2}" "${THREADS:-2}" "$bin" ;;
  load-coverage)
    swept=(contact/@solver=nsgs contact/@tolerance=1e-3)
    "$bin/bench_load_coverage" apps/scenes/level-ice.xml "${UNTIL:-4.6}" "${RUNS:-10}" \
      -- "${swept[@]}" contact/@max_iterations=200 -- "${swept[@]}" -- contact/@tolerance=1e-3 -- contact/@tolerance=1e-5 ;;
  load-statistics) load_statistics ;;
  presawn) "$bin/bench_presawn" "${TWINS:-7}" "${THREADS:-2}" ;;
  symmetry) shift; "$bin/bench_presawn_symmetry" "${END:-10}" "$@" ;;
  hull) shift; "$bin/bench_hull" "$bin/hull" "${THREADS:-$(nproc)}" "$@" ;;
  replay) shift; tests/bench/replay/measure.sh "$bin/bench_replay_cost" "$bin/apps/view_page" "$bin/replay" "$@" ;;
  size) /usr/bin/python3 tests/bench/size/measure.py "$bin/nilas" "$bin/tests/bench/libprocessor_clock.so" "$bin/size" \
    ${SIZES:-10000 100000 1000000} ;;
  cut) "$bin/bench_cut_study" "${CUTS:-100000}" ;;
  kernels) shift; "$bin/bench_kernels" "$@" ;;
  *) echo "usage: ./dev bench [packed|exact|front|loads|solvers|scaling|threads|collision [TABLE]|field|presawn|symmetry|level-ice [TABLE]|load-coverage|load-statistics|hull [SHAPE ...]|cut|replay [SIZE ...]|size|kernels]
collision: classes (against the oracle, BATCHES=100 of 1000 pairs in each class, CLASS=name for one), peers (beside FCL and
Bullet, PAIRS=1000 of each class), steps (a field that moves, SIZES, STEPS=100), threads, swept (missed and false first
contacts of PAIRS=100000 random pairs on their way), plates (PAIRS=100000 thin plates that fly at others, alone and in crowds),
narrow (shipped scenes with each narrow phase, UNTIL=5 s, SCENES=files), classes-fcl (FCL's contacts against the oracle); without
TABLE all; field: packing time (SIZES); presawn: TWINS=n further
runs of each scene (7), with pieces moved by up to a micrometre; symmetry: END=s of the scenes (10), solvers as
auto=1e-8 in place of the five shown; level-ice: loads (thicknesses and speeds, beside Lindqvist, with a picture),
steps, meshes, field (broken ice that may and may not break), TWINS=n (2); load-coverage: whether what single runs say of their mean
load holds in level ice, RUNS=10 of each setting until UNTIL=4.6 s; load-statistics: convergence of peaks, coverage of stated
errors and of return levels, on JOBS=2 cores, goes on where it was stopped; hull: wedge, cone, moon-pool, semi-submersible, ship-with-bulb,
on THREADS (all cores), ends with 1 where 18 000 triangles take over 60 s or parts stand further off than recorded; cut: CUTS=100000 random cuts of floes; replay: sizes 100, 1000 and 10000 floes, in Chromium;
size: SIZES in floes (1e6 takes 18 GB and a quarter of an hour), STEPS=6 of each, LAYOUT=closed for floes that touch on all sides;
ROUNDS=n: how often packed (3), threads and collision peers (5) are measured; THREADS=n;
LIMIT=s: seconds that a solver has for a problem (solvers 5, scaling 60) or a scene (exact 600, MuJoCo in it 300);
PYTHON=python3: one with the packages mujoco and numpy adds MuJoCo to exact; NILAS_FCLIB_DIR: a folder of further problems for solvers" ;;
esac
