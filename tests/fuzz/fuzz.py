#!/usr/bin/env python3
"""Feeds every reader of the program with changed inputs, and writes a table of what came of it.

usage: fuzz.py [--keep] [SECONDS] [TARGET ...]

The seconds (600 without them) are shared among the targets (all without names). Programs stand in build/fuzz, which
`./dev fuzz` builds. What a target finds new goes on from there: its inputs grow in build/fuzz/corpus/TARGET, and inputs
that crash, hang or take too much memory are kept in build/fuzz/findings. The table build/fuzz/fuzzing.csv sums over all
runs since that folder was made. With --keep the inputs that reach other code than the stored ones are then copied to
tests/fuzz/corpus, minimised.
"""
import argparse
import collections
import csv
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILD = ROOT / "build/fuzz"
STORED = ROOT / "tests/fuzz/corpus"
COLUMNS = ("target", "reads", "inputs", "processor_s", "edges", "inputs_kept", "findings", "slowest_s", "memory_mb")

# Each target: what it reads, the longest input in bytes, and the dictionary where it has one.
Target = collections.namedtuple("Target", "reads longest dictionary", defaults=(None,))
TARGETS = {
    "scene": Target("scene in XML", 4096, "scene"),
    "overrides": Target("lines of --set", 512, "scene"),
    "mooring": Target("mooring file", 4096, "scene"),
    "moordyn": Target("MoorDyn input", 2048),
    "tables": Target("tables in CSV", 2048),
    "ship": Target("ship file in CSV", 4096, "ship"),
    "hull": Target("hull in STL", 4096),
    "mesh_obj": Target("mesh in OBJ", 2048),
    "mesh_off": Target("mesh in OFF", 2048),
    "mesh_ply": Target("mesh in PLY", 2048),
    "mesh_stl": Target("mesh in STL", 2048),
    "field": Target("ice field in GeoJSON", 4096, "json"),
    "outlines": Target("outlines in JSON", 2048, "json"),
    "fclib": Target("FCLIB problem in HDF5", 32768),
    "checkpoint": Target("checkpoint in HDF5", 32768),
    "bem_hdf5": Target("BEM database in HDF5", 65536),
    "bem_netcdf": Target("BEM database in NetCDF", 16384),
    "bem_wamit": Target("BEM database of WAMIT", 4096),
    "replay": Target("replay", 8192),
    "control_lines": Target("lines of a controller", 1024, "json"),
    "json_results": Target("summary of a run in JSON", 4096, "json"),
    "live_requests": Target("requests of the live view", 2048, "http"),
    "study": Target("study in YAML", 4096),
}
# The time of an input is limited by each program itself, as processor time.
LIMITS = ("-rss_limit_mb=2048", "-malloc_limit_mb=1024", "-timeout=900", "-report_slow_units=900")


def environment():
    """HDF5 keeps what it had read of a damaged file; that is no finding. Files of inputs stay in memory."""
    own = os.environ | {"LSAN_OPTIONS": f"suppressions={ROOT}/tests/lsan-suppressions.txt:print_suppressions=0",
                        "ASAN_OPTIONS": "allocator_may_return_null=0:detect_stack_use_after_return=0"}
    if os.access("/dev/shm", os.W_OK):
        own["TMPDIR"] = "/dev/shm"
    return own


def run_once(name, seconds):
    """One run of a program until it finds something or the time is over. Returns its figures."""
    target, grown, found = TARGETS[name], BUILD / "corpus" / name, BUILD / "findings"
    grown.mkdir(parents=True, exist_ok=True)
    found.mkdir(exist_ok=True)
    if name == "study":
        words = [sys.executable, str(ROOT / "tests/fuzz/study_inputs.py"), str(max(1, round(seconds))), str(found)]
    else:
        words = [str(BUILD / f"fuzz_{name}"), str(grown), *([str(STORED / name)] if (STORED / name).exists() else []),
                 f"-max_total_time={max(1, round(seconds))}", f"-max_len={target.longest}", *LIMITS,
                 "-print_final_stats=1", "-verbosity=1", f"-artifact_prefix={found}/{name}-"]
        if target.dictionary:
            words.append(f"-dict={ROOT}/tests/fuzz/{target.dictionary}.dict")
    before = os.times()
    said = subprocess.run(words, env=environment(), capture_output=True, check=False).stderr.decode(errors="replace")
    after = os.times()

    def figure(pattern, otherwise=0.0):
        numbers = re.findall(pattern, said)
        return float(numbers[-1]) if numbers else otherwise

    return {"inputs": figure(r"number_of_executed_units:\s+(\d+)") or figure(r"#(\d+)\t"),
            "processor_s": after.children_user + after.children_system - before.children_user - before.children_system,
            "edges": figure(r"cov: (\d+)"), "slowest_s": figure(r"slowest input: ([\d.]+)"),
            "memory_mb": figure(r"peak_rss_mb:\s+(\d+)"), "found": re.findall(r"Test unit written to (\S+)", said),
            "said": said}


def fuzz(name, seconds, sums):
    end = time.monotonic() + seconds
    own = sums.setdefault(name, {"inputs": 0, "processor_s": 0, "edges": 0, "findings": 0, "slowest_s": 0, "memory_mb": 0})
    while (left := end - time.monotonic()) > 1:
        run = run_once(name, left)
        own["inputs"] += int(run["inputs"])
        own["processor_s"] += run["processor_s"]
        own["findings"] += len(run["found"])
        for key in ("edges", "slowest_s", "memory_mb"):
            own[key] = max(own[key], run[key])
        for file in run["found"]:
            print(f"{name}: found {file}", flush=True)
            pathlib.Path(file + ".txt").write_text(run["said"])
        if not run["inputs"]:
            print(run["said"][-3000:])
            break
    print(f"{name}: {own['inputs']} inputs, {int(own['edges'])} edges, {own['findings']} findings, "
          f"slowest {own['slowest_s']:.3f} s", flush=True)


def keep(name):
    """Copies inputs that reach other code than the stored ones, the smallest of each kind."""
    program, kept = BUILD / f"fuzz_{name}", STORED / name
    if not program.exists():
        return
    fresh = BUILD / "kept"
    shutil.rmtree(fresh, ignore_errors=True)
    fresh.mkdir()
    kept.mkdir(parents=True, exist_ok=True)
    subprocess.run([program, "-set_cover_merge=1", fresh, kept, BUILD / "corpus" / name,
                    f"-max_len={TARGETS[name].longest}", *LIMITS], env=environment(), capture_output=True, check=False)
    if any(fresh.iterdir()):
        shutil.rmtree(kept)
        fresh.rename(kept)


def write_table(sums):
    with open(BUILD / "fuzzing.csv", "w", newline="", encoding="utf-8") as out:
        table = csv.DictWriter(out, COLUMNS)
        table.writeheader()
        for name, own in sums.items():
            files = list((BUILD / "corpus" / name).glob("*"))
            table.writerow({"target": name, "reads": TARGETS[name].reads, "inputs": own["inputs"],
                            "processor_s": f"{own['processor_s']:.0f}", "edges": int(own["edges"]) or "",
                            "inputs_kept": len(files) or "", "findings": own["findings"],
                            "slowest_s": f"{own['slowest_s']:.3f}", "memory_mb": int(own["memory_mb"])})
    total = sum(own["inputs"] for own in sums.values())
    print(f"{total} inputs in sum, {sum(own['findings'] for own in sums.values())} findings: {BUILD / 'fuzzing.csv'}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--keep", action="store_true")
    parser.add_argument("--list", action="store_true", help="prints the names of the programs")
    parser.add_argument("words", nargs="*", metavar="SECONDS or TARGET")
    options = parser.parse_intermixed_args()
    seconds = next((float(word) for word in options.words if re.fullmatch(r"[\d.]+", word)), 600.0)
    names = [word for word in options.words if not re.fullmatch(r"[\d.]+", word)] or list(TARGETS)
    if unknown := [name for name in names if name not in TARGETS]:
        sys.exit(f"unknown target {unknown[0]}; there are {', '.join(TARGETS)}")
    if options.list:
        print("\n".join(f"fuzz_{name}" for name in names if name != "study"))
        return 0
    store = BUILD / "fuzzing.json"
    sums = json.loads(store.read_text()) if store.exists() else {}
    for name in names:
        fuzz(name, seconds / len(names), sums)
        store.write_text(json.dumps(sums))
        if options.keep:
            keep(name)
    write_table({name: sums[name] for name in TARGETS if name in sums})
    return 1 if any(sums[name]["findings"] for name in names) else 0


if __name__ == "__main__":
    sys.exit(main())
