"""Finds the case files that come with the program."""

from __future__ import annotations

import os
from collections.abc import Sequence
from pathlib import Path

from nilas.study.describe.faults import StudyError, listed, nearest
from nilas.validate.cases.case import Case
from nilas.validate.cases.read_case import read_case


def cases_folder() -> Path:
    """The folder of the shipped cases: of the source tree, of an installation, or of a wheel.

    Raises ``StudyError`` where there is none.
    """
    package = Path(__file__).resolve().parents[1]
    places = [
        package.parents[1] / "apps/scenes/validation",
        package / "share/nilas/scenes/validation",
    ]
    named = os.environ.get("NILAS_PROGRAM")
    if named:
        prefix = Path(named).resolve().parents[1]
        places.append(prefix / "share/nilas/scenes/validation")
    for place in places:
        if place.is_dir():
            return place
    raise StudyError(
        "The shipped cases were not found. They were looked for in "
        f"{listed([str(place) for place in places])}. Name case files instead.",
        4,
    )


def chosen_cases(words: Sequence[str]) -> list[Case]:
    """The cases of these names or files; all shipped ones where none is named.

    The shipped ones come in the order in which a budget should be spent, which ``order.txt``
    states. Raises ``StudyError`` for a name that is neither a case nor a file.
    """
    if not words:
        folder = cases_folder()
        return [read_case(folder / f"{name}.yaml") for name in shipped_names(folder)]
    files = []
    for word in words:
        path = Path(word)
        if path.suffix in (".yaml", ".yml"):
            files.append(path)
            continue
        folder = cases_folder()
        names = shipped_names(folder)
        if word not in names:
            hint = nearest(word, names)
            raise StudyError(
                f"'{word}' is no case.{hint} Cases are {listed(names)}, or a YAML file."
            )
        files.append(folder / f"{word}.yaml")
    cases = [read_case(file) for file in files]
    names = [case.name for case in cases]
    for name in names:
        if names.count(name) > 1:
            raise StudyError(f"Two cases have the name {name}.")
    return cases


def shipped_names(folder: Path) -> list[str]:
    """Names of the cases in a folder, in the order of its ``order.txt``."""
    return (folder / "order.txt").read_text(encoding="utf-8").split()
