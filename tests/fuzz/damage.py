#!/usr/bin/env python3
"""Damages HDF5 files at many places, gives each to the program, and counts what it does.

usage: damage.py PROGRAM [COUNT] [--csv FILE] [--seed S] [--wait SECONDS] [--keep FOLDER] [NAME ...]

COUNT damaged copies of each file (1000 without it) are spread evenly over its bytes. A copy has one byte changed, one
bit turned, a number of eight bytes replaced by an extreme one, bytes moved from elsewhere, or is cut short. The program
must read it or refuse it with a message (2 or 4), within 20 s of processor time, the seconds of --wait and 1 GB of memory.
Copies that end otherwise are stored in the folder of --keep.
"""
import argparse
import collections
import csv
import os
import pathlib
import random
import resource
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parents[2]
SECONDS = 20  # [s] of processor time
MEMORY = 1 << 30  # [bytes] of the program and its children, each
EXTREME = (0, 1, 0xff, 0xffff, 2**31 - 1, 2**31, 2**32 - 1, 2**40, 2**47, 2**63 - 1, 2**63, 2**64 - 1)
COLUMNS = ("file", "command", "bytes", "copies", "read", "refused", "ended_by_hdf5", "crashed", "beyond_bounds",
           "slowest_s", "memory_mb")
# What the message of a refusal says where HDF5 itself failed in the process that reads.
WITHIN_HDF5 = b"HDF5 itself"

# 3 is the code of `nilas hydro` for a database that contradicts itself.
READ = (0, 3)
REFUSED = (2, 4)

SCENE = """<scene version="1">
  <time step="0.01" end="0.06"/>
  <contact law="coulomb" solver="nsgs" tolerance="1e-6"/>
  <body name="ground" shape="plane" fixed="true"/>
  <body name="box" shape="box" size="1 1 1" mass="2" position="0 0 0.5" velocity="1 0 0"/>
  <output contacts="all" checkpoint_every="0.03"/>
</scene>
"""


Kind = collections.namedtuple("Kind", "command prepare")


def stored(path, *words):
    """A file of the repository, which one command reads."""
    def prepare(program, folder):
        shutil.copy(ROOT / path, folder / "a.h5")
        return folder / "a.h5", lambda: [*words, "a.h5"]
    return Kind("nilas " + " ".join(words), prepare)


def of_run(name):
    """A file of a run that is resumed half way."""
    def prepare(program, folder):
        (folder / "s.xml").write_text(SCENE)
        subprocess.run([program, "run", "s.xml", "--out", "whole", "--until", "0.03", "--quiet"], cwd=folder, check=True)

        def words():
            shutil.rmtree(folder / "run", ignore_errors=True)
            shutil.copytree(folder / "whole", folder / "run")
            shutil.copy(folder / "a.h5", folder / "run" / name)
            return ["run", "--resume", "run", "--until", "0.06", "--quiet"]
        shutil.copy(folder / "whole" / name, folder / "a.h5")
        return folder / "a.h5", words
    return Kind("nilas run --resume", prepare)


KINDS = {
    "local.hdf5": stored("tests/fuzz/corpus/fclib/local", "solve"),
    "global_rolling.hdf5": stored("tests/fuzz/corpus/fclib/global_rolling", "solve"),
    "bemio.h5": stored("tests/fuzz/corpus/bem_hdf5/bemio", "hydro"),
    "capytaine.nc": stored("tests/fuzz/corpus/bem_hdf5/capytaine", "hydro"),
    "checkpoint.h5": of_run("checkpoint.h5"),
    "contacts.h5": of_run("contacts.h5"),
}


def damaged(whole, k, count, chance):
    """The k-th of `count` copies: the place moves evenly over the file."""
    data, place = bytearray(whole), k * len(whole) // count + chance.randrange(1 + len(whole) // count)
    place = min(place, len(whole) - 1)
    how = chance.choice(("byte", "byte", "bit", "number", "number", "move", "several", "cut"))
    if how == "byte":
        data[place] = chance.randrange(256)
    elif how == "bit":
        data[place] ^= 1 << chance.randrange(8)
    elif how == "number":
        data[place:place + 8] = struct.pack("<Q", chance.choice(EXTREME))[:len(whole) - place]
    elif how == "move":
        size, source = chance.choice((1, 4, 8, 64, 512)), chance.randrange(len(whole))
        data[place:place + size] = whole[source:source + size]
    elif how == "several":
        for _ in range(chance.randrange(2, 20)):
            data[chance.randrange(len(whole))] = chance.randrange(256)
    else:
        del data[place:]
    return bytes(data)


def limit():
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_CPU, (2 * SECONDS, 2 * SECONDS))


def give(program, words, folder, wait):
    """Exit code, processor time [s], memory [bytes] and message of one command."""
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen([program, *words], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
                                   stderr=said, preexec_fn=limit)
        patience = threading.Timer(wait, process.kill)
        patience.start()
        _, status, used = os.wait4(process.pid, 0)
        patience.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        return process.returncode, used.ru_utime + used.ru_stime, 1024 * used.ru_maxrss, said.read()


def sweep(program, name, count, seed, keep, wait):
    row = dict.fromkeys(COLUMNS, 0) | {"file": name, "command": KINDS[name].command, "copies": count}
    chance = random.Random(f"{name} {seed}")
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        file, words = KINDS[name].prepare(program, folder)
        whole = file.read_bytes()
        row["bytes"] = len(whole)
        if (code := give(program, words(), folder, wait)[0]) not in READ:
            sys.exit(f"{name}: the file itself is not read (exit code {code})")
        for k in range(count):
            file.write_bytes(damaged(whole, k, count, chance))
            code, seconds, memory, said = give(program, words(), folder, wait)
            row["slowest_s"], row["memory_mb"] = max(row["slowest_s"], seconds), max(row["memory_mb"], memory / 2**20)
            beyond = seconds > SECONDS or memory > MEMORY or code == -signal.SIGKILL
            good = not beyond and (code in READ or code in REFUSED and said.strip())
            row["read"] += code in READ
            row["refused"] += code in REFUSED
            row["ended_by_hdf5"] += WITHIN_HDF5 in said
            row["crashed"] += code not in (*READ, *REFUSED, -signal.SIGKILL)
            row["beyond_bounds"] += beyond
            if keep and (not good or WITHIN_HDF5 in said):
                keep.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, keep / f"{name}-{k}")
            if not good:
                print(f"{name} copy {k}: exit code {code}, {seconds:.1f} s, {memory >> 20} MB: {said[-300:]}", flush=True)
    print(", ".join(f"{key} {round(value, 2) if isinstance(value, float) else value}" for key, value in row.items()),
          flush=True)
    return row


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("count", type=int, nargs="?", default=1000)
    parser.add_argument("--csv", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--wait", type=float, default=120, help="seconds until a command that does not end is killed")
    parser.add_argument("--keep", type=pathlib.Path)
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(KINDS))
    options = parser.parse_intermixed_args()
    if unknown := [name for name in options.names if name not in KINDS]:
        parser.error(f"unknown file {unknown[0]}; there are {', '.join(KINDS)}")
    rows = [sweep(options.program.resolve(), name, options.count, options.seed, options.keep, options.wait)
            for name in options.names or KINDS]
    if options.csv:
        with open(options.csv, "w", newline="", encoding="utf-8") as out:
            table = csv.DictWriter(out, COLUMNS)
            table.writeheader()
            for row in rows:
                table.writerow(row | {"slowest_s": f"{row['slowest_s']:.2f}", "memory_mb": f"{row['memory_mb']:.0f}"})
    return 1 if any(row["crashed"] or row["beyond_bounds"] for row in rows) else 0


if __name__ == "__main__":
    sys.exit(main())
