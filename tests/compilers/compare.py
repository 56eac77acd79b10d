#!/usr/bin/env python3
"""Builds the program in other ways and compares what it computes, bit by bit.

usage: compare.py [--jobs N] [--out FOLDER] [BUILD ...]

Each BUILD stands in build/compilers/BUILD; without names all are made but arm64, which takes longest. The scenes are
those of tests/scenario/golden.json. Of each it is told whether the hash of the last state is that of build/release, in
which step the states part, and how far the mean loads then differ beside their stated errors. The cases A and B of
`nilas verify`, which have known answers, must hold in every build. FOLDER/builds.csv has a row per build and scene.

The exit code is 1 where a build that must give the same bits does not, where a case of `verify` fails, or where a run
fails. arm64 is built by Debian's cross compiler and run by qemu; arm64_root.sh loads its libraries.
"""
import argparse
import csv
import json
import math
import pathlib
import subprocess
import sys
from dataclasses import dataclass, field

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUILDS = ROOT / "build/compilers"
ARM_ROOT = BUILDS / "arm64-root"
FAMILIES = ("A", "B")
COLUMNS = ("build", "flags", "scene", "until_s", "same_bits", "first_other_step", "steps", "load_N", "load_error_N",
           "reference_load_N", "verify_rows", "verify_failed")


@dataclass
class Build:
    """A way to build the program."""

    flags: str  # what differs from a release build, for the table
    options: list[str]  # of cmake
    same_bits: bool  # whether the pages promise the bits of the release build
    runner: list[str] = field(default_factory=list)


def of_flags(flags: str, same_bits: bool) -> Build:
    return Build(flags, ["-DCMAKE_BUILD_TYPE=Release", f"-DCMAKE_CXX_FLAGS={flags}"], same_bits)


# -march lets g++ and Eigen add in other orders, and use other registers. That of v2 is the oldest that has SSE4.
KINDS = {
    "debug": Build("-O0 -g, assertions", ["-DCMAKE_BUILD_TYPE=Debug"], True),
    "o2": Build("-O2", ["-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_CXX_FLAGS_RELEASE=-O2 -DNDEBUG"], True),
    "v2": of_flags("-march=x86-64-v2", False),
    "v3": of_flags("-march=x86-64-v3", False),
    "v4": of_flags("-march=x86-64-v4", False),
    "arm64": Build("aarch64-linux-gnu-g++, run by qemu",
                   ["-DCMAKE_BUILD_TYPE=Release",
                    f"-DCMAKE_TOOLCHAIN_FILE={pathlib.Path(__file__).resolve().parent / 'arm64.cmake'}",
                    "-DHDF5_C_COMPILER_EXECUTABLE=/bin/false"], False,
                   ["qemu-aarch64-static", "-L", str(ARM_ROOT)]),
}


def make(name: str, jobs: int) -> list[str]:
    """Builds the program and returns the words that run it."""
    folder = BUILDS / name
    if name == "arm64" and not (ARM_ROOT / "complete").exists():
        subprocess.run(["bash", str(pathlib.Path(__file__).resolve().parent / "arm64_root.sh"), str(ARM_ROOT)], check=True)
    if not (folder / "build.ninja").exists():
        subprocess.run(["cmake", "-S", str(ROOT), "-B", str(folder), "-G", "Ninja", "-DNILAS_TESTS=OFF",
                        *KINDS[name].options], check=True)
    subprocess.run(["cmake", "--build", str(folder), "--target", "nilas", "-j", str(jobs)], check=True)
    return [*KINDS[name].runner, str(folder / "nilas")]


def scenes() -> list[tuple[str, str]]:
    stored = json.loads((ROOT / "tests/scenario/golden.json").read_text(encoding="utf-8"))
    return [(case["scene"], case["until_s"]) for case in stored["sets"][0]["hashes"]]


@dataclass
class Outcome:
    hashes: list[str]
    load: float
    error: float


def run(program: list[str], scene: str, until: str, out: pathlib.Path) -> Outcome:
    subprocess.run([*program, "run", str(ROOT / "apps/scenes" / scene), "--until", until, "--out", str(out), "--force",
                    "--quiet"], check=True, stderr=subprocess.PIPE)
    with open(out / "steps.csv", encoding="utf-8", newline="") as table:
        hashes = [row["state_hash"] for row in csv.DictReader(table)]
    along = json.loads((out / "summary.json").read_text(encoding="utf-8"))["ice_load"]["along"]
    return Outcome(hashes, along["mean_N"] or 0.0, along["estimate_N"] or math.nan)


def verify(program: list[str]) -> tuple[int, int]:
    """How many rows of `nilas verify` there are, and how many of them do not hold."""
    words = [word for family in FAMILIES for word in ("--case", family)]
    done = subprocess.run([*program, "verify", *words, "--json"], stdout=subprocess.PIPE, check=False)
    rows = json.loads(done.stdout)["rows"]
    return len(rows), sum(row["verdict"] != "holds" for row in rows)


def first_other(a: list[str], b: list[str]) -> int | None:
    """The first step, from 1, after which the states differ."""
    return next((k + 1 for k, (x, y) in enumerate(zip(a, b, strict=True)) if x != y), None)


def compare(name: str, program: list[str], reference: list[str], out: pathlib.Path) -> list[dict]:
    rows = []
    count, failed = verify(program)
    for scene, until in scenes():
        stem = scene.removesuffix(".xml")
        ours = run(reference, scene, until, out / f"release-{stem}")
        other = run(program, scene, until, out / f"{name}-{stem}")
        parted = first_other(ours.hashes, other.hashes)
        rows.append(dict(zip(COLUMNS, (
            name, KINDS[name].flags, stem, until, "yes" if parted is None else "no", parted or "", len(ours.hashes),
            f"{other.load:.6g}", f"{other.error:.2g}", f"{ours.load:.6g}", count, failed), strict=True)))
    return rows


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("builds", nargs="*", metavar="BUILD", help=", ".join(KINDS))
    parser.add_argument("--jobs", type=int, default=2, help="compilations at a time")
    parser.add_argument("--out", type=pathlib.Path, default=BUILDS / "runs", help="folder of the runs and the table")
    asked = parser.parse_args()
    unknown = [name for name in asked.builds if name not in KINDS]
    if unknown:
        parser.error(f"no build named {', '.join(unknown)}; there are {', '.join(KINDS)}")
    reference = [str(ROOT / "build/release/nilas")]
    asked.out.mkdir(parents=True, exist_ok=True)
    rows, wrong = [], []
    for name in asked.builds or [kind for kind in KINDS if kind != "arm64"]:
        rows += compare(name, make(name, asked.jobs), reference, asked.out)
        for row in rows[-len(scenes()):]:
            print(f"{name:6} {row['scene']:10} " + (
                "same bits" if row["same_bits"] == "yes" else f"other bits from step {row['first_other_step']} of "
                f"{row['steps']}, mean load {row['load_N']} N +- {row['load_error_N']} N for {row['reference_load_N']} N"))
            if row["verify_failed"] or (KINDS[name].same_bits and row["same_bits"] == "no"):
                wrong.append(f"{name}, {row['scene']}")
        print(f"{name:6} verify     {rows[-1]['verify_rows']} rows, {rows[-1]['verify_failed']} of them fail", flush=True)
        with open(asked.out / "builds.csv", "w", encoding="utf-8", newline="") as table:
            writer = csv.DictWriter(table, COLUMNS)
            writer.writeheader()
            writer.writerows(rows)
    for text in wrong:
        print(f"not as promised: {text}", file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
