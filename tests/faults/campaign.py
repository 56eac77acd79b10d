#!/usr/bin/env python3
"""Lets calls of the system fail one by one, and judges how the program meets that.

usage: campaign.py [--of run,resume,compare,study,report] [--seconds N] [--most N] [--kinds write,...]
       campaign.py --kills N | --power | --slice
Each case runs a command whose N-th call of a class fails, then repeats or resumes it without a fault. Right is: exit
code 0 with the outputs of a run that did not fail, or exit code 4 with a message that names the file or what is lacking,
and nothing half on the disk. The repeated or resumed command must end with the same bits. Exit code 1: a case was bad.
"""

from __future__ import annotations

import argparse
import csv
import random
import sys
import tempfile
import time
from collections import Counter
from pathlib import Path

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))

import kills  # noqa: E402  (they stand beside this script)
import power  # noqa: E402
from commands import COMMANDS, Bench, Command, bench_for, carry_out, prepared  # noqa: E402
from interpose import Plan  # noqa: E402
from judge import fault_of  # noqa: E402
from plans import KINDS, plans, share_of_time  # noqa: E402

ROOT = Path(__file__).resolve().parents[2]
COLUMNS = ("command", "kind", "calls", "tried", "not_reached", "same", "refused", "mended", "bad")


def options_of(words: list[str]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="./dev faults", description=__doc__.splitlines()[0])
    parser.add_argument("--of", default=",".join(COMMANDS), help="the commands, separated by commas")
    parser.add_argument("--kinds", default=",".join(KINDS), help="the classes of calls, separated by commas")
    parser.add_argument("--seconds", type=float, default=1e9, help="begin no case after this wall time")
    parser.add_argument("--most", type=int, default=10**6, help="try at most so many calls of a class")
    parser.add_argument("--seed", type=int, default=1, help="the seed of what is drawn")
    parser.add_argument("--at", type=int, help="only this call of each class")
    parser.add_argument("--kills", type=int, default=0, help="kill commands at so many random instants instead")
    parser.add_argument("--power", action="store_true", help="lose the power at each change of a file instead")
    parser.add_argument("--slice", action="store_true", help="some cases of a run in each of the three ways")
    parser.add_argument("--table", type=Path, help="write the table into this file")
    parser.add_argument("--program", type=Path, default=ROOT / "build/release/nilas")
    parser.add_argument("--library", type=Path, default=ROOT / "build/release/tests/libinject_faults.so")
    return parser.parse_args(words)


def try_case(bench: Bench, command: Command, plan: Plan, row: Counter[str]) -> None:
    """One fault, and the command that mends it."""
    ended = carry_out(bench, command, plan)
    row["tried"] += 1
    if not ended.fired:
        row["not_reached"] += 1
        return
    fault = fault_of(command, plan, ended)
    if not fault and ended.code == 0:
        row["same"] += 1
        return
    row["refused"] += not fault
    worse = command.mend()
    row["mended"] += not worse
    if fault or worse:
        row["bad"] += 1
        told = "; ".join(text for text in (fault, worse) if text)
        print(f"BAD {command.name}: {plan.text()} ({ended.where()}): {told}", flush=True)


def try_command(name: str, bench: Bench, store: Path, options: argparse.Namespace, end: float) -> list[dict]:
    """All chosen faults of one command: a row of the table for each class."""
    command = prepared(name, bench, store)
    calls = carry_out(bench, command).calls
    rows = []
    kinds = options.kinds.split(",")
    for k, kind in enumerate(kinds):
        row: Counter[str] = Counter()
        chance = random.Random(f"{options.seed} {name} {kind}")
        its_end = share_of_time(end, len(kinds) - k)
        for plan in plans(kind, calls[kind], options.most, chance, options.at):
            if time.monotonic() < its_end:
                try_case(bench, command, plan, row)
        rows.append({"command": name, "kind": kind, "calls": calls[kind], **row})
        print(", ".join(f"{column} {rows[-1].get(column, 0)}" for column in COLUMNS), flush=True)
    return rows


def try_all(bench: Bench, store: Path, options: argparse.Namespace, end: float) -> tuple[tuple[str, ...], list[dict]]:
    """All cases of one way: the columns of the table and its rows."""
    if options.kills:
        return kills.campaign(bench, store, options, end)
    if options.power:
        return power.campaign(bench, store, options, end)
    rows = []
    names = options.of.split(",")
    for k, name in enumerate(names):
        rows += try_command(name, bench, store, options, share_of_time(end, len(names) - k))
    return COLUMNS, rows


def try_slice(bench: Bench, work: Path, options: argparse.Namespace, end: float) -> list[dict]:
    """Some faults at the same calls each time, a loss of power and a kill of a run: for the tests.

    A write to contacts.h5 fails in a resumed run, whose first file of HDF5 is one that it reads, and a run of a
    comparison cannot be started.
    """
    rows = []
    kinds = "open,read,write,sync,rename,memory"
    ways: tuple[dict[str, object], ...] = (
        {"most": 1, "kinds": kinds, "at": 20},
        {"of": "resume", "most": 1, "kinds": "write", "at": 56},
        {"of": "compare", "most": 1, "kinds": "process", "at": 8},
        {"at": 120, "power": True},
        {"kills": 1},
    )
    for number, way in enumerate(ways):
        chosen = argparse.Namespace(**(vars(options) | {"of": "run"} | way))
        rows += try_all(bench, work / f"store-{number}", chosen, end)[1]
    return rows


def write_table(file: Path | None, columns: tuple[str, ...], rows: list[dict]) -> None:
    if file is None:
        return
    with open(file, "w", newline="", encoding="utf-8") as stream:
        table = csv.DictWriter(stream, columns, restval=0, lineterminator="\n", extrasaction="ignore")
        table.writeheader()
        table.writerows(rows)


def main(words: list[str]) -> int:
    options = options_of(words)
    end = time.monotonic() + options.seconds
    with tempfile.TemporaryDirectory(prefix="nilas-faults-") as folder:
        work = Path(folder).resolve()
        bench = bench_for(options.program.resolve(), options.library.resolve(), work / "bench")
        if options.slice:
            rows = try_slice(bench, work, options, end)
        else:
            columns, rows = try_all(bench, work / "store", options, end)
            write_table(options.table, columns, rows)
    bad = sum(row.get("bad", 0) for row in rows)
    print(f"{sum(row.get('tried', 0) for row in rows)} cases, {bad} of them bad")
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
