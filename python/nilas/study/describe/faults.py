"""Faults of a study file: all of them are collected, then told together."""

from __future__ import annotations

import difflib
from collections.abc import Iterable
from dataclasses import dataclass, field


class StudyError(Exception):
    """A study that cannot be carried out as it is written.

    ``code``: the exit code of the command, 2 for wrong input and 4 for a file that cannot be
    read or written.

    >>> import nilas.study
    >>> try:
    ...     nilas.study.read_study("there-is-none.yaml")
    ... except nilas.study.StudyError as error:
    ...     print(error.code, error)
    4 The study file there-is-none.yaml cannot be read: No such file or directory.
    """

    def __init__(self, message: str, code: int = 2) -> None:
        super().__init__(message)
        self.code = code


@dataclass
class Faults:
    """The faults of one study file."""

    file: str
    texts: list[tuple[int, str]] = field(default_factory=list)
    only_unreadable: bool = True

    def add(self, line: int, where: str, message: str) -> None:
        """A fault at ``line`` (0: of the whole file) and at the key ``where``."""
        place = f"{self.file}:{line}" if line else self.file
        self.texts.append((line, f"{place}: {where + ': ' if where else ''}{message}"))
        self.only_unreadable = False

    def unreadable(self, message: str) -> None:
        """A file that cannot be opened."""
        self.texts.append((0, message))

    def throw(self) -> None:
        """Raises ``StudyError`` with all faults, in the order of their lines, if there are any."""
        if self.texts:
            text = "\n".join(text for _, text in sorted(self.texts, key=lambda fault: fault[0]))
            raise StudyError(text, 4 if self.only_unreadable else 2)


def nearest(word: str, allowed: Iterable[str]) -> str:
    """The hint that names what was perhaps meant, or nothing.

    >>> nearest("factor", ["factors", "seeds"])
    " Did you mean 'factors'?"
    >>> nearest("zzz", ["factors"])
    ''
    """
    close = difflib.get_close_matches(word, list(allowed), n=1, cutoff=0.6)
    return f" Did you mean '{close[0]}'?" if close else ""


def listed(words: Iterable[str]) -> str:
    """Words as a sentence lists them.

    >>> listed(["a", "b", "c"])
    'a, b and c'
    """
    words = list(words)
    return words[0] if len(words) == 1 else ", ".join(words[:-1]) + " and " + words[-1]
