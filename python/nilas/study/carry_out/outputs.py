"""The names that a run writes: numbers of summary.json and columns of tables."""

from __future__ import annotations

import csv
import json
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from nilas.study.carry_out.named_file import naming
from nilas.study.carry_out.record import VOLATILE, parts_of
from nilas.study.describe.faults import listed, nearest
from nilas.study.describe.study import Response, Study

# Objects of a vessel that may come only after some steps, and those whose numbers depend on what happens.
_LATE = {"ice_load", "tow_force", "load_error", "carriage_balance", "joint_balance"}
_BY_EVENTS = {"figures", "step_load_error"}
_SHOWN = 12


@dataclass(frozen=True)
class Outputs:
    """What one run wrote. ``is_whole``: it reached its end, so nothing came late any more.

    ``summary``: the content of summary.json. ``columns``: those of each CSV table, by its file.
    """

    summary: dict[str, Any]
    columns: dict[str, list[str]] = field(default_factory=dict)
    is_whole: bool = True

    def has(self, response: Response) -> bool | None:
        """Whether runs of this scene have what a response asks for; None where it is not known.

        >>> outputs = Outputs({"ice_load": {"mean_N": 1.5, "halves": None}}, {"vessel.csv": ["time_s"]})
        >>> [outputs.has(Response("r", "", channel=f"ice_load.{name}")) for name in ("mean_N", "maen_N", "halves.N")]
        [True, False, None]
        >>> outputs.has(Response("r", "", table="vessel.csv", column="x_m"))
        False
        """
        if response.column:
            return response.column in self.columns.get(response.table, [])
        first = response.channel.split(".")[0]
        found = _find(self.summary, response.channel)
        is_late = first in _LATE and "vessel" in self.summary and first not in self.summary
        is_open = first in _BY_EVENTS or (is_late and not self.is_whole)
        return None if found is False and is_open else found

    def told(self, response: Response) -> str:
        """What is wrong with a response that no run has, and which names are allowed."""
        if not response.column:
            return _told_of_channel(self.summary, response.channel)
        if response.table not in self.columns:
            tables = listed(sorted(self.columns) or ["no table"])
            return f"The runs write no {response.table}.{nearest(response.table, self.columns)} They write {tables}."
        names = self.columns[response.table]
        return (
            f"{response.table} has no column {response.column}.{nearest(response.column, names)} "
            f"It has {_some(names)}."
        )


def outputs_of(folder: Path, *, is_whole: bool = True) -> Outputs | None:
    """The names in the folder of a run; None where it has no summary."""
    try:
        summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return None
    columns = {}
    for file in folder.glob("*.csv"):
        with naming(file), open(file, newline="", encoding="utf-8") as stream:
            columns[file.name] = next(csv.reader(stream), [])
    return Outputs(summary, columns, is_whole)


def faults_of(study: Study, outputs: Outputs, responses: Iterable[Response]) -> list[str]:
    """A sentence with its place for each response that runs like this one do not have."""
    return [
        f"{study.file}:{response.line}: responses.{response.name}: {outputs.told(response)}"
        for response in responses
        if outputs.has(response) is False
    ]


def _find(value: Any, path: str) -> bool | None:
    """Whether there is a number at a path of a JSON value; None where what would hold it is null."""
    if value is None:
        return None
    for name, part in parts_of(value):
        if path == name:
            return part is None or isinstance(part, (bool, int, float))
        if path.startswith(name + "."):
            found = _find(part, path[len(name) + 1 :])
            if found is not False:
                return found
    return False


def _told_of_channel(summary: dict[str, Any], path: str) -> str:
    if VOLATILE & set(path.split(".")):
        return f"{path} differs between runs of one scene, so it is no response; runs.csv has what runs take."
    names = list(_leaves(summary))
    place, inside = _deepest(summary, path + ".")
    text = f"summary.json has no number {path}.{nearest(path, names)}"
    return f"{text} {place or 'It'} has {_some(inside)}." if inside else text


def _deepest(value: Any, path: str) -> tuple[str, list[str]]:
    """The longest part of a path that exists, and the names below it that lead to numbers."""
    place = ""
    while True:
        parts = parts_of(value)
        name, value = next(
            ((name, part) for name, part in parts if path.startswith(name + ".")), ("", None)
        )
        if not parts_of(value):
            return place, [name for name, part in parts if any(True for _ in _leaves(part))]
        place = f"{place}.{name}" if place else name
        path = path[len(name) + 1 :]


def _leaves(value: Any, path: str = "") -> Iterable[str]:
    parts = parts_of(value)
    if not parts and (value is None or isinstance(value, (bool, int, float))):
        yield path
    for name, part in parts:
        yield from _leaves(part, f"{path}.{name}" if path else name)


def _some(names: list[str]) -> str:
    if len(names) <= _SHOWN:
        return listed(names)
    return f"{', '.join(names[:_SHOWN])} and {len(names) - _SHOWN} more"
