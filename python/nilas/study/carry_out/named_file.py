"""Reads files so that an error names them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path


@contextmanager
def naming(path: Path) -> Iterator[None]:
    """Gives an error of an open file its name, which it does not know.

    >>> with naming(Path("steps.csv")):
    ...     raise OSError(5, "Input/output error")
    Traceback (most recent call last):
    OSError: [Errno 5] Input/output error: 'steps.csv'
    """
    try:
        yield
    except OSError as error:
        raise OSError(error.errno, error.strerror, str(path)) from error


def text_in(path: Path) -> str:
    """The text of a file. Raises ``OSError`` with its name."""
    with naming(path):
        return path.read_text(encoding="utf-8")
