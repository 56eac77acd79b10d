"""Keeps a second process out of a folder of runs, and waits for one that is about to leave a run."""

from __future__ import annotations

import fcntl
import os
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from nilas.study.describe.faults import StudyError


@contextmanager
def only_one(folder: Path, name: str) -> Iterator[None]:
    """Holds the file ``name`` in the folder. Raises ``StudyError`` where another process does."""
    folder.mkdir(parents=True, exist_ok=True)
    with open(folder / name, "w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError as error:
            raise StudyError(
                f"Another process is carrying out the study in {folder}.", 4
            ) from error
        except OSError:
            pass  # A file system without locks: nilas run goes on without them, too.
        lock.write(str(os.getpid()))
        lock.flush()
        yield


def wait_until_left(run: Path, patience_s: float = 60.0) -> None:
    """Returns once no process writes the run in a folder, as one whose study was killed still does.

    Such a run writes its checkpoint and ends. It holds a lock on its log until then. Raises
    ``StudyError`` where that takes longer than ``patience_s``.
    """
    end = time.monotonic() + patience_s
    while _is_written(run / "nilas.log"):
        if time.monotonic() > end:
            raise StudyError(
                f"Another process is writing the run in {run}. The same command goes on once it ends.",
                4,
            )
        time.sleep(0.02)


def _is_written(log: Path) -> bool:
    try:
        with open(log, "r+b") as stream:
            fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        return True
    except OSError:
        return False
    return False
