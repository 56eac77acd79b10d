"""A published formula: its function with source, units, range, and slopes."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

# Half width of the difference in ln x: small enough for four digits, large against rounding.
_STEP = 1e-4
# The power of the scale of lengths by which a quantity grows (Froude and Cauchy).
SCALE_POWERS = {
    "1": 0.0, "rad": 0.0, "m": 1.0, "m^2": 2.0, "m/s": 0.5, "m/s^2": 0.0, "kg/m^3": 0.0,
    "Pa": 1.0, "N": 3.0, "N/m": 2.0, "degC": 0.0,
}  # fmt: skip


class FormulaError(ValueError):
    """Inputs with which a formula has no value."""


@dataclass(frozen=True)
class Input:
    """One input of a formula.

    ``low`` and ``high``: the range that the source claims, or that follows from the meaning of
    the quantity. ``default``: the value where none is given, None where one is needed.
    """

    name: str
    unit: str
    meaning: str
    low: float = 0.0
    high: float = math.inf
    default: float | None = None


@dataclass(frozen=True)
class Condition:
    """A condition of the source on several inputs, in words and as a function of the inputs."""

    text: str
    holds: Callable[[Mapping[str, float]], bool]


@dataclass(frozen=True)
class Formula:
    """A formula that gives ``result``, in ``unit``.

    ``source``: who published it. ``read_in``: where its constants were read. ``doubt``: why no
    verdict rests on its values, or nothing. ``slopes_count``: whether its exponents are confirmed
    all the same. ``similar``: whether it keeps Froude's and Cauchy's laws exactly.
    """

    name: str
    title: str
    result: str
    unit: str
    source: str
    read_in: str
    inputs: tuple[Input, ...]
    function: Callable[..., float] = field(repr=False)
    conditions: tuple[Condition, ...] = ()
    doubt: str = ""
    slopes_count: bool = False
    similar: bool = True

    @property
    def counts_for_slopes(self) -> bool:
        return self.slopes_count or not self.doubt

    def needs(self) -> list[str]:
        """Names of the inputs that have no default."""
        return [one.name for one in self.inputs if one.default is None]

    def chosen(self, values: Mapping[str, float]) -> dict[str, float]:
        """Its own inputs among ``values``, with defaults for those that are missing.

        Raises ``FormulaError`` where one is missing, or is no finite number.
        """
        taken = {}
        for one in self.inputs:
            value = values.get(one.name, one.default)
            if value is None:
                raise FormulaError(f"{self.name} needs the input {one.name} [{one.unit}].")
            if not math.isfinite(value):
                raise FormulaError(f"{self.name}: {one.name} is {value}, which is no number.")
            taken[one.name] = float(value)
        return taken

    def value(self, values: Mapping[str, float]) -> float:
        """The result, inside of the range and outside of it.

        Raises ``FormulaError`` where the formula has no finite value.
        """
        taken = self.chosen(values)
        try:
            result = float(self.function(**taken))
        except (ValueError, ZeroDivisionError, OverflowError, TypeError) as error:
            raise FormulaError(f"{self.name} has no value for {taken}: {error}.") from error
        if not math.isfinite(result):
            raise FormulaError(f"{self.name} has no finite value for {taken}.")
        return result

    def outside(self, values: Mapping[str, float]) -> list[str]:
        """Why the inputs leave the formula's range, in sentences. Empty: they are inside."""
        taken = self.chosen(values)
        reasons = []
        for one in self.inputs:
            value = taken[one.name]
            if not one.low <= value <= one.high:
                unit = "" if one.unit == "1" else f" {one.unit}"
                reasons.append(
                    f"{one.name} is {value:.4g}{unit}, and the range is "
                    f"{one.low:g} to {one.high:g}."
                )
        reasons += [one.text for one in self.conditions if not one.holds(taken)]
        return reasons

    def slope(self, values: Mapping[str, float], name: str) -> float:
        """d ln result / d ln input, by a central difference.

        >>> square = Formula("sq", "", "", "N", "", "", (Input("x", "m", ""),), lambda x: x**2)
        >>> round(square.slope({"x": 3.0}, "x"), 6)
        2.0
        """
        taken = self.chosen(values)
        if name not in taken:
            raise FormulaError(f"{self.name} has no input {name}.")
        higher = self.value(taken | {name: taken[name] * math.exp(_STEP)})
        lower = self.value(taken | {name: taken[name] * math.exp(-_STEP)})
        if higher <= 0 or lower <= 0:
            raise FormulaError(f"{self.name} has no logarithm there.")
        return (math.log(higher) - math.log(lower)) / (2 * _STEP)


def gravity(default: float = 9.81) -> Input:
    """The acceleration of gravity, which all formulas take in the same way."""
    return Input("gravity", "m/s^2", "acceleration of gravity", default=default)
