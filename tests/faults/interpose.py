"""Runs a command with the interposer, and reads its counters."""

from __future__ import annotations

import errno
import os
import signal
import struct
import subprocess
import time
import uuid
from dataclasses import dataclass, field
from pathlib import Path

KINDS = (
    "open", "read", "write", "sync", "rename", "unlink", "truncate", "folder", "close", "lock",
    "stat", "memory", "mmap", "process", "thread", "change",
)  # fmt: skip
# The layout of Board in interposer/board.h.
_BOARD = struct.Struct(f"={len(KINDS)}qqq64s64s1024sq64q")
LIMIT_S = 300.0  # a busy machine takes its time; a program that hangs takes more
_LOOK_S = 1.0  # counted in looks, so that a time does not count in which all of these processes were held up
MARK = "NILAS_FAULT_MARK"


@dataclass(frozen=True)
class Plan:
    """Which call fails and how. ``action``: an error's number, ``short`` or ``kill``."""

    kind: str
    at: int
    action: str
    lasting: bool = False

    def text(self) -> str:
        action = errno.errorcode.get(int(self.action), "") if self.action.isdigit() else self.action
        return f"{self.kind} {self.at} {action}{' and all later' if self.lasting else ''}"


@dataclass
class Ended:
    """How a command ended. ``code``: the exit code, or minus the number of a signal."""

    code: int
    out: str
    err: str
    hung: bool = False
    calls: dict[str, int] = field(default_factory=dict)
    fired: int = 0
    program: str = ""
    call: str = ""
    path: str = ""

    def where(self) -> str:
        return f"{self.program}: {self.call} {self.path}".strip()


class Runner:
    """Runs commands in a folder, whose files alone are counted."""

    def __init__(self, library: Path, folder: Path, environment: dict[str, str]) -> None:
        self._library = library
        self._folder = folder
        self._environment = environment
        self._board = folder.with_name(folder.name + ".board")

    def start(self, words: list[str], mark: str, more: dict[str, str]) -> subprocess.Popen[str]:
        """Starts a command whose processes all carry a mark in their environment."""
        return subprocess.Popen(
            words,
            cwd=self._folder,
            env=os.environ | self._environment | more | {MARK: mark},
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            errors="replace",
            start_new_session=True,
        )

    def run(self, words: list[str], plan: Plan | None = None, shadow: Path | None = None) -> Ended:
        """Runs a command to its end, with a plan of failure or none."""
        self._board.write_bytes(bytes(_BOARD.size))
        more = {
            "LD_PRELOAD": str(self._library),
            "NILAS_FAULT_BOARD": str(self._board),
            "NILAS_FAULT_UNDER": str(self._folder) + "/",
        }
        if plan is not None:
            more |= {"NILAS_FAULT_CLASS": plan.kind, "NILAS_FAULT_AT": str(plan.at)}
            more |= {"NILAS_FAULT_ACTION": plan.action}
            more |= {"NILAS_FAULT_LASTING": "1"} if plan.lasting else {}
        if shadow is not None:
            more["NILAS_FAULT_SHADOW"] = str(shadow)
        ended = self._finish(words, more)
        values = _BOARD.unpack(self._board.read_bytes())
        count = len(KINDS)
        ended.calls = dict(zip(KINDS, values[:count], strict=True))
        ended.fired = values[count]
        texts = (raw.split(b"\0")[0].decode() for raw in values[count + 2 : count + 5])
        ended.program, ended.call, ended.path = texts
        return ended

    def plainly(self, words: list[str]) -> Ended:
        """Runs a command without the interposer."""
        return self._finish(words, {})

    def _finish(self, words: list[str], more: dict[str, str]) -> Ended:
        mark = uuid.uuid4().hex
        process = self.start(words, mark, more)
        for _ in range(round(LIMIT_S / _LOOK_S)):
            try:
                out, err = process.communicate(timeout=_LOOK_S)
            except subprocess.TimeoutExpired:
                continue
            return Ended(process.returncode, out, err)
        end_marked(mark)
        out, err = process.communicate()
        return Ended(process.returncode, out, err, hung=True)


def marked(mark: str) -> list[int]:
    """The processes that carry a mark and have not ended."""
    found = []
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            environment = (entry / "environ").read_bytes()
            state = (entry / "stat").read_text().rpartition(")")[2].split()[0]
        except OSError:
            continue
        if f"{MARK}={mark}".encode() in environment.split(b"\0") and state not in "ZX":
            found.append(int(entry.name))
    return found


def end_marked(mark: str) -> None:
    """Kills the processes that carry a mark: those of one command, and no others."""
    for process in marked(mark):
        try:
            os.kill(process, signal.SIGKILL)
        except ProcessLookupError:
            pass


def outlived(mark: str, patience_s: float) -> list[int]:
    """The processes of a killed command that still run after so many seconds.

    They are counted in looks, so that a time does not count in which all of these processes were held up.
    """
    pause_s = 0.01
    for _ in range(round(patience_s / pause_s)):
        if not marked(mark):
            return []
        time.sleep(pause_s)
    return marked(mark)
