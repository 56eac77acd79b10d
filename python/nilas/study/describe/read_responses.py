"""Reads the responses of a study file: the numbers that each run gives."""

from __future__ import annotations

import re

from nilas.study.describe.faults import Faults
from nilas.study.describe.section import Section
from nilas.study.describe.study import STATISTICS, Response
from nilas.study.describe.yaml_items import Item

RESPONSE_KEYS = ("name", "unit", "channel", "table", "column", "statistic", "from_s", "to_s")
# Endings of names of columns and keys, and their units; see docs/reference/outputs.md.
_UNITS = {
    "N": "N", "Nm": "N m", "Ns": "N s", "m_s": "m/s", "rad_s": "rad/s", "deg_s": "deg/s",
    "kg_m3": "kg/m^3", "kg": "kg", "m": "m", "s": "s", "deg": "deg", "J": "J", "Pa": "Pa",
    "percent": "%", "ms": "ms", "rad": "rad",
}  # fmt: skip
_NAME = re.compile(r"^[A-Za-z]\w*$")


def read_responses(top: Section, taken: set[str], faults: Faults) -> tuple[Response, ...]:
    """The responses in the order of the file. ``taken``: names of columns that are in use."""
    item = top.item("responses")
    if item is None:
        top.fault(
            None,
            "'responses' is missing. It lists numbers of summary.json, as ice_load.along.mean_N.",
        )
        return ()
    if item.kind == "text":
        item = Item(item.line, "list", items=(item,))
    if item.kind != "list" or not item.items:
        faults.add(item.line, "responses", "A list should stand here, as [ice_load.along.mean_N].")
        return ()
    responses = [_response(one, faults) for one in item.items]
    seen = set(taken) | {"run", "point", "seed", "status", "message"}
    for response in responses:
        if response.name in seen:
            faults.add(
                response.line,
                "responses",
                f"The name '{response.name}' is in use. Give this response another.",
            )
        seen.add(response.name)
    return tuple(responses)


def _response(item: Item, faults: Faults) -> Response:
    if item.kind == "text":
        return Response(_name_of(item.text), unit_of(item.text), channel=item.text, line=item.line)
    section = Section(item, "responses", RESPONSE_KEYS, faults)
    channel, column = section.text("channel"), section.text("column")
    if bool(channel) == bool(column):
        section.fault(
            None, "A response has either a channel of summary.json, or a column of a table."
        )
    name = section.text("name", _name_of(channel or column or "response"))
    if not _NAME.match(name):
        section.fault(
            "name", f"'{name}' is no name: letters, digits and _ are allowed, and a letter first."
        )
    unit = section.text("unit", unit_of(channel or column))
    if not column:
        for key in ("table", "statistic", "from_s", "to_s"):
            if section.has(key):
                section.fault(key, "Only a response with a column has this key.")
        return Response(name, unit, channel=channel, line=item.line)
    from_s, to_s = section.number("from_s"), section.number("to_s")
    if from_s is not None and to_s is not None and from_s >= to_s:
        section.fault("to_s", "The time ends before it begins.")
    return Response(
        name,
        unit,
        table=section.text("table", "vessel.csv"),
        column=column,
        statistic=section.choice("statistic", STATISTICS, "mean"),
        from_s=from_s,
        to_s=to_s,
        line=item.line,
    )


def unit_of(channel: str) -> str:
    """The unit that a name ends in.

    >>> unit_of("ice_load.along.mean_N"), unit_of("loads.contact_fx_N.mean"), unit_of("steps")
    ('N', 'N', '')
    """
    for part in reversed(channel.split(".")):
        for ending in sorted(_UNITS, key=len, reverse=True):
            if part.endswith("_" + ending):
                return _UNITS[ending]
    return ""


def _name_of(channel: str) -> str:
    name = re.sub(r"\W+", "_", channel).strip("_")
    return name if name[:1].isalpha() else "response_" + name
