"""Typed access to a map of the study file: each wrong value is a fault with place and remedy."""

from __future__ import annotations

import math
from collections.abc import Sequence

from nilas.study.describe.faults import Faults, listed, nearest
from nilas.study.describe.yaml_items import Item


def number_of(text: str) -> float | None:
    """The finite number that a text is, or None.

    >>> number_of("1e-4"), number_of("fast"), number_of("nan")
    (0.0001, None, None)
    """
    try:
        value = float(text)
    except ValueError:
        return None
    return value if math.isfinite(value) and "_" not in text else None


class Section:
    """A map with known keys. Unknown keys are faults, with the nearest name."""

    def __init__(self, item: Item | None, where: str, keys: Sequence[str], faults: Faults) -> None:
        self.where = where
        self.faults = faults
        self.line = item.line if item else 0
        self.entries: dict[str, Item] = {}
        if item is None or item.kind == "nothing":
            return
        if item.kind != "map":
            known = listed(keys)
            self.fault(
                None, f"{item.described()} stands here; a map with keys among {known} should."
            )
            return
        self.entries = item.entries
        for key, value in item.entries.items():
            if key not in keys:
                hint = nearest(key, keys)
                faults.add(
                    value.line,
                    self._at(key),
                    f"There is no such key.{hint} Keys are {listed(keys)}.",
                )

    def has(self, key: str) -> bool:
        return key in self.entries and self.entries[key].kind != "nothing"

    def item(self, key: str) -> Item | None:
        return self.entries[key] if self.has(key) else None

    def line_of(self, key: str) -> int:
        return self.entries[key].line if key in self.entries else self.line

    def fault(self, key: str | None, message: str) -> None:
        line = self.line_of(key) if key else self.line
        self.faults.add(line, self._at(key) if key else self.where, message)

    def text(self, key: str, default: str = "") -> str:
        if not self.has(key):
            return default
        item = self.entries[key]
        if item.kind != "text" or not item.text.strip():
            self.fault(key, f"{item.described()} stands here; a word or a text should.")
            return default
        return item.text.strip()

    def choice(self, key: str, allowed: Sequence[str], default: str) -> str:
        word = self.text(key, default)
        if word not in allowed:
            hint = nearest(word, allowed)
            self.fault(key, f"'{word}' is not known.{hint} Allowed are {listed(allowed)}.")
            return default
        return word

    def number(
        self, key: str, default: float | None = None, *, above: float | None = None
    ) -> float | None:
        if not self.has(key):
            return default
        item = self.entries[key]
        value = number_of(item.text) if item.kind == "text" else None
        if value is None or (above is not None and value <= above):
            limit = "" if above is None else f" above {above:g}"
            self.fault(key, f"{item.described()} stands here; a number{limit} should.")
            return default
        return value

    def whole(self, key: str, default: int, *, least: int = 0, most: int = 2**53) -> int:
        if not self.has(key):
            return default
        item = self.entries[key]
        value = whole_of(item)
        if value is None or not least <= value <= most:
            top = f" and at most {most}" if most < 2**53 else ""
            self.fault(
                key,
                f"{item.described()} stands here; a whole number of at least {least}{top} should.",
            )
            return default
        return value

    def _at(self, key: str | None) -> str:
        return f"{self.where}.{key}" if self.where and key else (key or self.where)


def whole_of(item: Item) -> int | None:
    """The whole number of an item, or None."""
    if item.kind != "text":
        return None
    try:
        return int(item.text)
    except ValueError:
        return None
