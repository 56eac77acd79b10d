"""What a study says. A reader that leaves, as ``head`` does, stops no study and makes no error."""

from __future__ import annotations

import os
import sys
from typing import TextIO

NO_MEMORY = "error: there is too little memory for this command"


def tell(text: str) -> None:
    """Writes a line, or several, on standard output."""
    _write(sys.stdout, text + "\n")


def warn(text: object) -> None:
    """Writes a line, or several, on standard error."""
    _write(sys.stderr, f"{text}\n")


def settle() -> None:
    """Writes what still waits in both streams, so that nothing is left for the end of Python."""
    for stream in (sys.stdout, sys.stderr):
        _write(stream, "")


def _write(stream: TextIO, text: str) -> None:
    try:
        stream.write(text)
        stream.flush()
    except BrokenPipeError:
        # Whatever follows goes nowhere.
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno())
        os.close(nowhere)
