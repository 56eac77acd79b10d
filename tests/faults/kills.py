"""Kills commands at random instants."""

from __future__ import annotations

import argparse
import math
import os
import random
import re
import signal
import time
import uuid
from collections import Counter
from pathlib import Path

from commands import Bench, Command, prepared
from contents import status
from interpose import end_marked, outlived

COLUMNS = ("command", "tried", "killed", "orphans", "lost", "mended", "bad")
# A child that was asked to end writes its checkpoint first.
_PATIENCE_S = 10.0
# On a busy machine a command may take less time than when it was timed.
_MOST_TRIES = 3


def campaign(
    bench: Bench, store: Path, options: argparse.Namespace, end: float
) -> tuple[tuple[str, ...], list[dict]]:
    """Shares the kills evenly between the commands; a row for each. One that comes after the end does not count."""
    names = [name for name in options.of.split(",") if name in ("run", "resume", "compare", "study")]
    rows = []
    for name in names:
        chance = random.Random(f"{options.seed} kill {name}")
        command = prepared(name, bench, store)
        lasts = _duration(bench, command)
        row: Counter[str] = Counter()
        share = options.kills // len(names)
        while row["killed"] < share and row["tried"] < _MOST_TRIES * share and time.monotonic() < end:
            _kill(bench, command, lasts * chance.random(), row["tried"] % 2 == 0, row)
        rows.append({"command": name, **row})
        print(", ".join(f"{column} {rows[-1].get(column, 0)}" for column in COLUMNS), flush=True)
    return COLUMNS, rows


def _duration(bench: Bench, command: Command) -> float:
    """How long a command takes [s]."""
    bench.put_back(command.out, command.before)
    begun = time.monotonic()
    bench.demand(command.words)
    return time.monotonic() - begun


def _kill(bench: Bench, command: Command, after_s: float, waits: bool, row: Counter[str]) -> None:
    """Kills a command, looks for what outlives it, then continues it.

    ``waits``: continues it once all of its processes have ended, else at once.
    """
    bench.put_back(command.out, command.before)
    mark = uuid.uuid4().hex
    process = bench.runner.start(bench.words(command.words), mark, {})
    time.sleep(after_s)
    os.kill(process.pid, signal.SIGKILL)
    process.communicate()
    row["tried"] += 1
    row["killed"] += process.returncode == -signal.SIGKILL
    left: list[int] = outlived(mark, _PATIENCE_S) if waits else []
    out = bench.folder / command.out
    kept, saved = _finished(out), -math.inf if status(out) == "done" else _last_time(out, "a checkpoint at")
    fault = command.mend()
    left = left or outlived(mark, _PATIENCE_S)
    lost = [str(file) for file, text in kept.items() if not file.exists() or file.read_bytes() != text]
    if saved > _last_time(out, "the run continues from"):
        lost.append(f"the checkpoint at {saved:g} s")
    end_marked(mark)
    row["orphans"] += bool(left)
    row["lost"] += bool(lost)
    row["mended"] += not fault
    if fault or left or lost:
        row["bad"] += 1
        told = [fault, f"processes {left} live on" if left else "", f"{lost} were lost" if lost else ""]
        print(f"BAD {command.name}: killed after {after_s:.3f} s: {'; '.join(t for t in told if t)}", flush=True)


def _last_time(out: Path, words: str) -> float:
    """The last time that a run's log names after these words [s]; -inf without one."""
    try:
        log = (out / "nilas.log").read_text(errors="replace")
    except OSError:
        return -math.inf
    return max((float(time) for time in re.findall(words + r" (\S+) s", log)), default=-math.inf)


def _finished(out: Path) -> dict[Path, bytes]:
    """The records of runs that had ended: they must not be made again."""
    files = [*out.glob("results/*.json"), *out.rglob("record.json")]
    return {file: file.read_bytes() for file in files}
