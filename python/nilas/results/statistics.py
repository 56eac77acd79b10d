"""Statistics of a run as the program computed them, from summary.json, as tables."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

import pandas as pd

from nilas.results.units import unit_of

_STATISTICS = ["std", "max", "p99", "max_filtered"]
_COLUMNS = ["unit", "mean", "error", *_STATISTICS]


def load_table(summary: Mapping[str, Any]) -> pd.DataFrame:
    """A row per load channel of the vessel: its unit, its statistics and its error.

    ``error`` is the half width of the interval of about 95 % of the mean, nan where it is not
    known. It holds for one ice field.

    >>> table = load_table({"loads": {"ice_side_N": {"mean": 2.0, "std": 0.5, "max": 3, "p99": 3}}})
    >>> table.loc["ice_side_N", "unit"], float(table.loc["ice_side_N", "mean"])
    ('N', 2.0)
    """
    loads = summary.get("loads") or {}
    errors = (summary.get("load_error") or {}).get("channels") or {}
    rows = {
        channel: {
            "unit": unit_of(channel),
            "mean": statistics.get("mean"),
            "error": (errors.get(channel) or {}).get("estimate"),
            **{name: statistics.get(name) for name in _STATISTICS},
        }
        for channel, statistics in loads.items()
    }
    return _numbers(pd.DataFrame.from_dict(rows, orient="index", columns=_COLUMNS), "channel")


def structure_table(summary: Mapping[str, Any]) -> pd.DataFrame:
    """A row per fixed body and load channel, with the figures of summary.json.

    Names of figures have no unit here: the column ``unit`` has that of the channel.

    >>> pier = {"name": "pier", "loads": {"contact_mz_Nm": {"mean_Nm": 2.0}}}
    >>> row = structure_table({"structures": [pier]}).loc[("pier", "contact_mz_Nm")]
    >>> row["unit"], float(row["mean"])
    ('N m', 2.0)
    """
    rows = {}
    for structure in summary.get("structures") or []:
        for channel, figures in (structure.get("loads") or {}).items():
            row: dict[str, Any] = {"unit": unit_of(channel)}
            for name, value in figures.items():
                if not isinstance(value, Mapping):
                    row[_without_unit(name)] = value
            rows[structure["name"], channel] = row
    frame = pd.DataFrame.from_dict(rows, orient="index")
    if len(frame):
        frame.index = pd.MultiIndex.from_tuples(rows, names=["structure", "channel"])
    return frame


def figures_of(summary: Mapping[str, Any]) -> dict[str, float | str | bool]:
    """All single values of a summary under one name each, as in ``ice_load.along.mean_N``.

    Parts of lists have their name, else their number from 1, as in ``structures.pier.touched_by_ice``.

    >>> figures_of({"steps": 3, "ice_load": {"along": {"mean_N": 2.5, "halves": None}}})
    {'steps': 3, 'ice_load.along.mean_N': 2.5}
    >>> figures_of({"vessel": {"cog_m": [0.1, 0.2]}, "structures": [{"name": "pier", "window": 3}]})
    {'vessel.cog_m.1': 0.1, 'vessel.cog_m.2': 0.2, 'structures.pier.name': 'pier', 'structures.pier.window': 3}
    """
    return {name: value for name, value in _leaves(summary, "") if value is not None}


def has_figure(summary: Mapping[str, Any], name: str) -> bool:
    """Whether a summary has a figure of this name, though it may not be known.

    >>> summary = {"ice_load": {"along": {"mean_N": 2.5, "halves": None}}}
    >>> has_figure(summary, "ice_load.along.halves.differ"), has_figure(summary, "ice_load.mean_N")
    (True, False)
    """
    return any(
        name == one or value is None and name.startswith(one + ".")
        for one, value in _leaves(summary, "")
    )


def _leaves(value: Any, path: str) -> Iterator[tuple[str, Any]]:
    """The single values in an object or list, with their paths."""
    if isinstance(value, Mapping):
        parts = [(str(name), inner) for name, inner in value.items()]
    elif isinstance(value, list):
        parts = [(_name_in_list(one, place), one) for place, one in enumerate(value, 1)]
    else:
        yield path, value
        return
    for name, inner in parts:
        yield from _leaves(inner, f"{path}.{name}" if path else name)


def _name_in_list(value: Any, place: int) -> str:
    name = value.get("name") if isinstance(value, Mapping) else None
    return str(name) if name else str(place)


def _numbers(frame: pd.DataFrame, index_name: str) -> pd.DataFrame:
    """The table with numbers as floats, so that what is not known is nan."""
    for column in frame.columns.drop("unit"):
        frame[column] = frame[column].astype(float)
    frame.index.name = index_name
    return frame


def _without_unit(name: str) -> str:
    """A name of a figure such as ``event_impulse_Ns`` without the unit of the load.

    The ending stays where it is a time or an impulse: these are not in the channel's unit.
    """
    for ending in ("_N", "_Nm"):
        if name.endswith(ending):
            return name[: -len(ending)]
    return name
