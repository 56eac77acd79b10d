"""Says what is wrong with how a command met a fault."""

from __future__ import annotations

import re
from pathlib import Path

from commands import Command
from interpose import Ended, Plan

_DONE, _FILE = 0, 4
# A study goes on where one of its runs fails, and then ends with 3; the next call makes the run again.
_RIGHT_CODES = {"study": {3, _FILE}}
_INTERNAL = re.compile(r"internal error|Traceback|terminate called|LOG ERROR", re.IGNORECASE)
# Python that gets no memory at its own start says so itself, before any line of this project.
_NO_PYTHON = re.compile(r"Fatal Python error: .*\nPython runtime state: (pre|core )initialized\nMemoryError")
_WORDS = {
    "memory": re.compile(r"memory|MemoryError|cannot allocate", re.IGNORECASE),
    "mmap": re.compile(r"memory|cannot allocate|map", re.IGNORECASE),
    "process": re.compile(r"start|run|fork|gnuplot|temporarily", re.IGNORECASE),
    "thread": re.compile(r"thread|temporarily", re.IGNORECASE),
}


def fault_of(command: Command, plan: Plan, ended: Ended) -> str:
    """What is wrong with the exit code, the message and the files of a command, or nothing."""
    if ended.hung:
        return "it did not end"
    if ended.code < 0 or ended.code > 128:
        return f"signal {-ended.code if ended.code < 0 else ended.code - 128}: {_last(ended.err)}"
    if ended.code == _DONE:
        return command.judge(True)
    if command.name == "study" and _NO_PYTHON.search(ended.err):
        return command.judge(False)
    if ended.code not in _RIGHT_CODES.get(command.name, {_FILE}):
        return f"exit code {ended.code}: {_last(ended.err)}"
    if _INTERNAL.search(ended.err):
        return f"message: {_last(ended.err)}"
    if not _is_told(command, plan, ended):
        return f"message names nothing: {_last(ended.err)}"
    return command.judge(False)


def _is_told(command: Command, plan: Plan, ended: Ended) -> bool:
    if plan.lasting and any(name in ended.err for name in command.files):
        return True
    if plan.kind in _WORDS:
        return _WORDS[plan.kind].search(ended.err) is not None
    file = Path(ended.path)
    names = {file.name, file.name.removesuffix(".part"), file.stem, file.parent.name}
    return any(name and name in ended.err for name in names)


def _last(text: str) -> str:
    lines = [line for line in text.splitlines() if line.strip()]
    return lines[-1][:160] if lines else "no message"
