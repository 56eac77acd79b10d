"""Keeps a second process out of a folder of runs."""

from __future__ import annotations

import fcntl
import os
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
        except OSError as error:
            raise StudyError(
                f"Another process is carrying out the study in {folder}.", 4
            ) from error
        lock.write(str(os.getpid()))
        lock.flush()
        yield
