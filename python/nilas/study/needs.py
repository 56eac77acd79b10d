"""The packages of Python that a study needs: looked for at its begin, not after hours of runs."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from importlib.util import find_spec

from nilas.study.describe.faults import StudyError, listed

_OF_TABLES = ("scipy",)
_OF_PAGE = ("matplotlib", "jinja2")


def demand_packages(*, page: bool) -> None:
    """Raises ``StudyError`` where a package is missing. ``page``: whether the page is to be written.

    >>> demand_packages(page=True)
    """
    missing = [name for name in (*_OF_TABLES, *(_OF_PAGE if page else ())) if find_spec(name) is None]
    if missing:
        hint = " Without a page, --no-page, the tables need scipy alone." if page else ""
        raise StudyError(told(missing) + hint, 4)


def told(missing: Iterable[str]) -> str:
    """What is missing, and how to get it.

    >>> told(["jinja2"])  # doctest: +ELLIPSIS
    "Studies need the package jinja2, which ... lacks. apt install python3-jinja2 of Debian, or pip install 'nilas[study]'."
    """
    names = list(missing)
    debian = " ".join(f"python3-{name}" for name in names)
    return (
        f"Studies need the package{'s' if len(names) > 1 else ''} {listed(names)}, which {sys.executable} lacks. "
        f"apt install {debian} of Debian, or pip install 'nilas[study]'."
    )
