"""Is a folder the folder of a run, and how did that run end?"""

from __future__ import annotations

import json
import os
import re
from pathlib import Path
from typing import Any, NamedTuple

from nilas.errors import InputError

# One of these stands in the folder of any run that has begun.
_MARKS = ("scene.xml", "steps.csv", "summary.json")
# A line of the log behind its date and time.
_ERROR = re.compile(r"^\d{4}-\d\d-\d\d [\d:.]+ error: (.*)$", re.MULTILINE)


class NoRun(InputError):
    """A folder is not the folder of a run, or lacks what was asked for.

    >>> example_run.events  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    nilas.results.folder.NoRun: ...: this run has no events.csv; runs where floes can break have it.
    """


class UnfinishedRun(UserWarning):
    """A run failed, was interrupted or was killed: its files end early.

    >>> import shutil, warnings
    >>> import nilas
    >>> folder = Path(shutil.copytree(example_folder, "killed"))
    >>> (folder / "summary.json").unlink()
    >>> with warnings.catch_warnings(record=True) as told:
    ...     run = nilas.Run(folder)
    >>> run.status, told[0].category is nilas.UnfinishedRun
    ('killed', True)
    """


class State(NamedTuple):
    """How a run stands.

    ``status``: ``done``, ``failed``, ``interrupted``, ``running`` or ``killed`` (it has no
    summary, and no program writes it any more). ``trouble``: a sentence where the run did not
    reach its end, else empty.

    >>> State("killed", "It was killed.").status
    'killed'
    """

    status: str
    trouble: str


def demand_run(folder: Path) -> None:
    """Raises ``NoRun`` with a sentence where the folder is no run folder.

    >>> demand_run(Path("there-is-none"))  # doctest: +IGNORE_EXCEPTION_DETAIL
    Traceback (most recent call last):
    nilas.results.folder.NoRun: there-is-none: there is no such folder.
    """
    if not folder.exists():
        raise NoRun(f"{folder}: there is no such folder.")
    if not folder.is_dir():
        raise NoRun(f"{folder}: this is a file. Name the run folder, which holds steps.csv.")
    if not is_run(folder):
        inside = sorted(path.name for path in folder.iterdir() if path.is_dir() and is_run(path))
        hint = f" It holds the run folders {_some(inside)}." if inside else ""
        raise NoRun(
            f"{folder}: this is no run folder, since it has none of {', '.join(_MARKS)}.{hint}"
        )


def is_run(folder: Path) -> bool:
    """Whether a folder holds a run that has begun.

    >>> is_run(Path("."))
    False
    """
    return any((folder / mark).is_file() for mark in _MARKS)


def read_summary(folder: Path) -> dict[str, Any] | None:
    """The content of summary.json, or None before the run has written it.

    >>> read_summary(example_folder)["scene"], read_summary(Path("."))
    ('small', None)
    """
    file = folder / "summary.json"
    try:
        text = file.read_text(encoding="utf-8")
    except FileNotFoundError:
        return None
    try:
        summary = json.loads(text)
    except json.JSONDecodeError as fault:
        raise NoRun(f"{file}: this is no JSON text: {fault}.") from None
    if not isinstance(summary, dict):
        raise NoRun(f"{file}: this holds no object.")
    return summary


def state_of(folder: Path, summary: dict[str, Any] | None) -> State:
    """How the run in a folder stands, from its summary or, without one, from its lock.

    >>> state_of(example_folder, {"status": "interrupted", "time_end_s": 0.25})
    State(status='interrupted', trouble='It was interrupted at 0.25 s.')
    """
    if summary is None:
        if _is_locked(folder / "nilas.log"):
            return State("running", "")
        return State("killed", "It was killed: it has no summary.json, and no program writes it.")
    status = str(summary.get("status", "done"))
    if status == "done":
        return State(status, "")
    error = _last_error(folder / "nilas.log") if status == "failed" else ""
    if error:
        return State(status, f"It failed: {error}.")
    end = summary.get("time_end_s")
    at = f" at {end:.6g} s" if isinstance(end, (int, float)) else ""
    return State(status, f"It failed{at}." if status == "failed" else f"It was {status}{at}.")


def _last_error(log: Path) -> str:
    """The last error that a run logged, without its time; empty where there is none."""
    if not log.is_file():
        return ""
    errors = _ERROR.findall(log.read_text(encoding="utf-8", errors="replace"))
    return str(errors[-1]).rstrip(".") if errors else ""


def _is_locked(log: Path) -> bool:
    """Whether a program holds the lock of a run, which the system releases when it ends."""
    try:
        import fcntl
    except ImportError:  # not a POSIX system: nothing can be known
        return False
    try:
        descriptor = os.open(log, os.O_RDONLY)
    except OSError:
        return False
    try:
        fcntl.flock(descriptor, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    except OSError:  # a file system without locks
        return False
    finally:
        os.close(descriptor)
    return False


def _some(names: list[str]) -> str:
    """The first names of a list, and how many more there are."""
    shown = 3
    rest = len(names) - shown
    return ", ".join(names[:shown]) + (f" and {rest} more" if rest > 0 else "")
