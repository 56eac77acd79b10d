"""A factor of a study: what is varied, and over which values."""

from __future__ import annotations

import math
from dataclasses import dataclass

# Values between two others are rounded to these digits. So the table states what was run.
_DIGITS = 6


@dataclass(frozen=True)
class Level:
    """One value of a factor.

    ``label``: the value as tables show it. ``number``: the same as a number, or None for a word.
    ``overrides``: attributes of the scene and their values, as ``--set`` takes them.
    """

    label: str
    number: float | None
    overrides: tuple[tuple[str, str], ...]


@dataclass(frozen=True)
class Factor:
    """What is varied.

    ``paths``: the attributes that take the value, empty where each level names its own.
    ``levels``: the values of a list, or of a range with steps. ``low`` and ``high``: the ends of
    a range, None for a list. ``whole``: only whole numbers are taken from the range.
    """

    name: str
    unit: str
    paths: tuple[str, ...]
    levels: tuple[Level, ...]
    low: float | None = None
    high: float | None = None
    logarithmic: bool = False
    whole: bool = False
    line: int = 0

    @property
    def is_numeric(self) -> bool:
        """Whether every value is a number."""
        return self.low is not None or all(level.number is not None for level in self.levels)

    @property
    def title(self) -> str:
        """Name and unit, for axes."""
        return f"{self.name} [{self.unit}]" if self.unit else self.name

    def level_at(self, share: float) -> Level:
        """The value at ``share`` (0 to 1) of the range, or of the list.

        >>> wide = Factor("mu", "", ("a/@b",), (), low=0.1, high=10.0, logarithmic=True)
        >>> wide.level_at(0.5).label
        '1'
        """
        if self.low is None or self.high is None:
            return self.levels[min(int(share * len(self.levels)), len(self.levels) - 1)]
        if self.whole:
            low, high = int(self.low), int(self.high)
            return number_level(
                float(low + min(int(share * (high - low + 1)), high - low)), self.paths
            )
        return number_level(
            rounded(between(self.low, self.high, share, self.logarithmic)), self.paths
        )


def between(low: float, high: float, share: float, logarithmic: bool) -> float:
    """The number at ``share`` of the way from low to high."""
    if logarithmic:
        return math.exp(math.log(low) + share * (math.log(high) - math.log(low)))
    return low + share * (high - low)


def rounded(value: float) -> float:
    """The value to six significant digits."""
    return float(f"{value:.{_DIGITS}g}")


def number_text(value: float) -> str:
    """The shortest text that gives the same number back; whole numbers have no point.

    >>> number_text(0.30), number_text(2.0), number_text(1e-7)
    ('0.3', '2', '1e-07')
    """
    if value == int(value) and abs(value) < 1e15:
        return str(int(value))
    return repr(value)


def number_level(value: float, paths: tuple[str, ...]) -> Level:
    """The level of a number that the attributes ``paths`` take."""
    text = number_text(value)
    return Level(text, value, tuple((path, text) for path in paths))
