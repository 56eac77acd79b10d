#!/usr/bin/env python3
"""Tells which sockets the commands of the program make, and whether a run without a network has the same bits.

usage: network.py PROGRAM [--quick] [--csv FILE]

Each command runs under strace, with all processes that it starts. Pairs of sockets without an address, by which
processes of one command speak to each other, are counted apart. A command that fails is a fault, and so is any other
socket but those of the live view on the loopback. The package for Python is taken from the folder beside the program.
Then a run in a network namespace of its own, in which nothing is connected, must give the bits of one outside. --quick
does only this; where the system allows no such namespace the exit code is 77.
"""
import argparse
import collections
import csv
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
COLUMNS = ("command", "exit_code", "pairs", "others", "good")
HULL = ("hull", "--generate", "icebreaker", "--length", "3", "--beam", "0.8", "--draught", "0.2", "--triangles", "300",
        "--quiet")
# Each with the words of the command.
COMMANDS = (
    ("run", "ship.xml", "--out", "run", "--quiet", "--until", "0.2"),
    ("run", "--resume", "run", "--until", "0.3", "--quiet"),
    ("run", "ship.xml", "--out", "live", "--quiet", "--until", "0.1", "--view"),
    ("report", "run"),
    ("view", "run"),
    ("check", "ship.xml"),
    ("field", "ship.xml"),
    ("solve", str(ROOT / "tests/fuzz/corpus/fclib/local")),
    ("hydro", str(ROOT / "tests/fuzz/corpus/bem_hdf5/bemio")),
    ("compare", "ship.xml", "--solvers", "nsgs", "--dt", "0.01", "--seeds", "1", "--until", "0.05", "--out", "compared"),
    ("verify", "--case", "A1"),
    ("study", "study.yaml", "--out", "study"),
    ("statistics", "run"),
)


def sockets(trace):
    """Pairs without an address, and all else that makes or uses an address."""
    pairs, others = 0, collections.Counter()
    for line in trace.splitlines():
        if "socketpair(AF_UNIX" in line:
            pairs += 1
        elif found := re.search(r"\b(socket)\((AF_\w+)", line):
            others[f"{found[1]} {found[2]}"] += 1
        elif found := re.search(r"\b(bind|connect|sendto|accept4?)\(.*sa_family=(AF_\w+).*?(?:inet_addr\(\"([\d.]+)\"|})", line):
            others[f"{found[1]} {found[3] or found[2]}"] += 1
    return pairs, others


def traced(program, words, folder):
    trace = folder / "trace.txt"
    done = subprocess.run(["strace", "-f", "-qq", "-e", "trace=%network", "-o", trace, program, *words], cwd=folder,
                          stdin=subprocess.DEVNULL, capture_output=True, check=False,
                          env=os.environ | {"PYTHONPATH": str(pathlib.Path(program).parent / "python")})
    pairs, others = sockets(trace.read_text(errors="replace"))
    allowed = {"socket AF_INET", "bind 127.0.0.1"} if "--view" in words else set()
    good = not set(others) - allowed and done.returncode == 0
    row = {"command": "nilas " + " ".join(word.replace(f"{ROOT}/", "") for word in words), "exit_code": done.returncode,
           "pairs": pairs, "others": ", ".join(f"{key}: {count}" for key, count in sorted(others.items())) or "none",
           "good": "yes" if good else "no"}
    print(", ".join(f"{key}: {value}" for key, value in row.items()), flush=True)
    if done.returncode != 0:
        print(done.stderr.decode()[-300:])
    return row


def bits(folder):
    digest = hashlib.sha256()
    for file in sorted([*folder.glob("*.csv"), *folder.glob("trajectory/*")]):
        if file.name != "steps.csv":  # it holds times of the wall clock
            digest.update(file.name.encode() + file.read_bytes())
    return digest.hexdigest()


def without_network(program, folder):
    """Whether a run has the same bits where nothing is connected; None where that cannot be tried."""
    apart = ["unshare", "--user", "--map-root-user", "--net"]
    if subprocess.run([*apart, "true"], capture_output=True, check=False).returncode != 0:
        return None
    run = [program, "run", "ship.xml", "--quiet", "--until", "0.2", "--out"]
    subprocess.run([*run, "outside"], cwd=folder, check=True, capture_output=True)
    subprocess.run([*apart, *run, "apart"], cwd=folder, check=True, capture_output=True)
    return bits(folder / "outside") == bits(folder / "apart")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--csv", type=pathlib.Path)
    options = parser.parse_args()
    program, rows = str(options.program.resolve()), []
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        for name in ("ship.xml", "study.yaml"):
            shutil.copy(ROOT / "tests/faults/scenes" / name, folder)
        subprocess.run([program, *HULL, "--out", "ship"], cwd=folder, check=True, capture_output=True)
        same = without_network(program, folder)
        if not options.quick:
            rows = [traced(program, words, folder) for words in COMMANDS]
    print({None: "a run without a network was not tried: the system allows no namespace of the network",
           True: "a run without a network has the same bits", False: "a run without a network has OTHER bits"}[same])
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as out:
            table = csv.DictWriter(out, COLUMNS)
            table.writeheader()
            table.writerows(rows)
    if same is None and options.quick:
        return 77
    return 1 if same is False or any(row["good"] == "no" for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
