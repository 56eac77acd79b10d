"""Reads the factors of a study file."""

from __future__ import annotations

import re

from nilas.study.describe.factor import Factor, Level, between, number_level, rounded
from nilas.study.describe.faults import Faults
from nilas.study.describe.section import Section, number_of
from nilas.study.describe.yaml_items import Item

FACTOR_KEYS = (
    "name", "unit", "also", "values", "from", "to", "steps", "scale", "whole"
)  # fmt: skip
# Flags of ``nilas run`` that stand where a path of an attribute may.
RUN_FLAGS = ("--scale",)
_PATH = re.compile(r"^/?[\w\[\]@='\"+./ *-]*@[A-Za-z_]\w*$")
_NAME = re.compile(r"^[A-Za-z]\w*$")


def is_path(text: str) -> bool:
    """Whether a text has the form of an attribute's path, or is a flag that may stand for one.

    >>> is_path("vessel/carriage/@speed"), is_path("body[@name='box']/@mass"), is_path("speed")
    (True, True, False)
    >>> is_path("--scale")
    True
    """
    return text in RUN_FLAGS or bool(_PATH.match(text))


def read_factors(item: Item | None, faults: Faults) -> tuple[Factor, ...]:
    """The factors in the order of the file."""
    if item is None:
        return ()
    if item.kind != "map" or not item.entries:
        faults.add(
            item.line, "factors", "A map from attributes of the scene to values should stand here."
        )
        return ()
    factors = [_factor(key, value, faults) for key, value in item.entries.items()]
    seen: dict[str, int] = {"run": 0, "point": 0, "seed": 0, "status": 0, "message": 0}
    for factor in factors:
        if factor.name in seen:
            other = (
                f"the factor in line {seen[factor.name]}"
                if seen[factor.name]
                else "a column of the table"
            )
            faults.add(
                factor.line,
                "factors",
                f"The name '{factor.name}' is that of {other} too. Give this factor a name.",
            )
        seen[factor.name] = factor.line
    return tuple(factors)


def _factor(key: str, item: Item, faults: Faults) -> Factor:
    where = f"factors.{key}"
    if "seed/@value" in key:
        faults.add(item.line, where, "Seeds are no factor: they are replicates. Use the key seeds.")
    if item.kind == "map":
        return _long_factor(key, item, where, faults)
    if not is_path(key):
        _tell_no_path(item.line, where, key, faults)
    levels = _levels(item, (key,), where, faults)
    return Factor(default_name(key), "", (key,), levels, line=item.line)


def _long_factor(key: str, item: Item, where: str, faults: Faults) -> Factor:
    section = Section(item, where, FACTOR_KEYS, faults)
    own_levels = section.has("values") and section.entries["values"].kind == "map"
    if not own_levels and not is_path(key):
        _tell_no_path(item.line, where, key, faults)
    name = section.text("name", key if own_levels else default_name(key))
    if not _NAME.match(name):
        section.fault(
            "name", f"'{name}' is no name: letters, digits and _ are allowed, and a letter first."
        )
    unit = section.text("unit")
    if own_levels:
        levels = _named_levels(section.entries["values"], where, faults)
        return Factor(name, unit, (), levels, line=item.line)
    paths = (key, *_also(section, faults))
    if section.has("values"):
        for other in ("from", "to", "steps", "scale"):
            if section.has(other):
                section.fault(other, "A factor has either values, or from and to.")
        return Factor(
            name,
            unit,
            paths,
            _levels(section.entries["values"], paths, where, faults),
            line=item.line,
        )
    return _range(section, name, unit, paths)


def _range(section: Section, name: str, unit: str, paths: tuple[str, ...]) -> Factor:
    low, high = section.number("from"), section.number("to")
    for key, value in (("from", low), ("to", high)):
        if value is None and not section.has(key):
            section.fault(
                None, f"'{key}' is missing. A factor has a list of values, or from and to."
            )
    logarithmic = section.choice("scale", ("linear", "log"), "linear") == "log"
    whole = section.choice("whole", ("true", "false"), "false") == "true"
    low, high = low or 0.0, 1.0 if high is None else high
    if low >= high and section.has("from") and section.has("to"):
        section.fault("to", f"The range ends at {high:g}, which is not above its start {low:g}.")
        return Factor(name, unit, paths, (), low=low, high=high, line=section.line)
    if logarithmic and low <= 0:
        section.fault("from", "A range with the scale log must start above 0.")
        logarithmic = False
    if whole and (low != int(low) or high != int(high)):
        section.fault("whole", "A range of whole numbers must start and end with one.")
        whole = False
    steps = section.whole("steps", 0, least=2, most=100000) if section.has("steps") else 0
    shares = [k / (steps - 1) for k in range(steps)] if steps > 1 else []
    values = [rounded(between(low, high, share, logarithmic)) for share in shares]
    if whole:
        values = sorted({float(round(value)) for value in values})
    levels = tuple(number_level(value, paths) for value in values)
    return Factor(name, unit, paths, levels, low, high, logarithmic, whole, section.line)


def _also(section: Section, faults: Faults) -> tuple[str, ...]:
    """Further attributes that take the same value."""
    if not section.has("also"):
        return ()
    item = section.entries["also"]
    words = item.items if item.kind == "list" else (item,)
    for word in words:
        if word.kind != "text" or not is_path(word.text):
            faults.add(
                word.line,
                f"{section.where}.also",
                f"{word.described()} is no path of an attribute.",
            )
    return tuple(word.text for word in words)


def _levels(item: Item, paths: tuple[str, ...], where: str, faults: Faults) -> tuple[Level, ...]:
    if item.kind != "list" or not item.items:
        faults.add(
            item.line, where, f"{item.described()} stands here; a list such as [0.6, 0.8] should."
        )
        return ()
    levels: list[Level] = []
    for one in item.items:
        if one.kind != "text":
            faults.add(
                one.line, where, f"{one.described()} stands in the list; a number or a word should."
            )
            continue
        level = level_of(one.text, paths)
        if any(level.label == other.label for other in levels):
            faults.add(one.line, where, f"The value {level.label} stands in the list twice.")
        levels.append(level)
    return tuple(levels)


def level_of(text: str, paths: tuple[str, ...]) -> Level:
    """The level that a text names, as a number where it is one."""
    number = number_of(text)
    if number is not None:
        return number_level(number, paths)
    return Level(text, None, tuple((path, text) for path in paths))


def _named_levels(item: Item, where: str, faults: Faults) -> tuple[Level, ...]:
    """Levels that each set attributes of their own."""
    levels = []
    for label, entry in item.entries.items():
        if entry.kind != "map" or not entry.entries:
            faults.add(
                entry.line,
                f"{where}.values.{label}",
                "A map from attributes to values should stand here.",
            )
            continue
        levels.append(
            Level(label, number_of(label), read_overrides(entry, f"{where}.values.{label}", faults))
        )
    return tuple(levels)


def read_overrides(item: Item | None, where: str, faults: Faults) -> tuple[tuple[str, str], ...]:
    """Attributes of the scene and the values that they take."""
    if item is None or item.kind == "nothing":
        return ()
    if item.kind != "map":
        faults.add(
            item.line,
            where,
            f"{item.described()} stands here; a map from attributes to values should.",
        )
        return ()
    overrides = []
    for path, value in item.entries.items():
        if not is_path(path):
            _tell_no_path(value.line, where, path, faults)
        elif value.kind != "text":
            faults.add(
                value.line, f"{where}.{path}", f"{value.described()} stands here; one value should."
            )
        elif path.endswith("seed/@value"):
            faults.add(value.line, f"{where}.{path}", "Seeds are replicates. Use the key seeds.")
        else:
            overrides.append((path, value.text))
    return tuple(overrides)


def default_name(path: str) -> str:
    """The attribute's name, or that of a flag."""
    return path.rsplit("@", 1)[-1].lstrip("-")


def _tell_no_path(line: int, where: str, text: str, faults: Faults) -> None:
    faults.add(
        line, where, f"'{text}' is no path of an attribute. An example is vessel/carriage/@speed."
    )
