"""Units of columns and keys, which their names end in."""

from __future__ import annotations

import re
from collections.abc import Iterable

# Endings of names and the units that they stand for. Of two that fit, the longer one holds.
_ENDINGS = {
    "N": "N",
    "Nm": "N m",
    "Ns": "N s",
    "Nms": "N m s",
    "J": "J",
    "sqrtJ": "sqrt(J)",
    "W": "W",
    "Pa": "Pa",
    "Pa_sqrt_m": "Pa sqrt(m)",
    "kg": "kg",
    "kg_m2": "kg m^2",
    "kg_m3": "kg/m^3",
    "m": "m",
    "m2": "m^2",
    "m3": "m^3",
    "m_s": "m/s",
    "m3_s": "m^3/s",
    "s": "s",
    "1_s": "1/s",
    "deg": "deg",
    "deg_s": "deg/s",
    "rad": "rad",
    "rad_s": "rad/s",
    "rpm": "1/min",
    "percent": "%",
    "1": "1",
}
_BY_LENGTH = sorted(_ENDINGS, key=len, reverse=True)
# Names of pure numbers that have no ending.
_PURE = re.compile(
    r"(id|floe_id|floes|contacts|islands|iterations|load_ratio|q[wxyz]|n[xyz]|step|steps|body|other"
    r"|part|other_part|key)$"
)
# Wall times of phases have their unit in front.
_MILLISECONDS = re.compile(r"ms(_|$)")


def unit_of(name: str) -> str:
    """The unit that the name of a column or key ends in.

    Returns ``"1"`` for pure numbers and ``""`` for texts and names without a unit.

    >>> unit_of("contact_mx_Nm"), unit_of("vx_m_s"), unit_of("floes"), unit_of("status")
    ('N m', 'm/s', '1', '')
    """
    if _PURE.match(name):
        return "1"
    if _MILLISECONDS.match(name):
        return "ms"
    for ending in _BY_LENGTH:
        if name.endswith("_" + ending):
            return _ENDINGS[ending]
    return ""


def units_of(names: Iterable[str]) -> dict[str, str]:
    """The unit of each name.

    >>> units_of(["time_s", "yaw_deg"])
    {'time_s': 's', 'yaw_deg': 'deg'}
    """
    return {name: unit_of(name) for name in names}
