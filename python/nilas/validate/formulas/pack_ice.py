"""Resistance in pack ice and broken ice that does not break."""

from __future__ import annotations

import math

from nilas.validate.formulas.formula import Formula, Input, gravity

_SPEED = Input("speed", "m/s", "speed through the ice")
_CONCENTRATION = Input("concentration", "1", "area of ice over area", high=1.0)
_THICKNESS = Input("thickness", "m", "thickness of the floes")
_BEAM = Input("beam", "m", "beam of the ship at the waterline")
_ICE_DENSITY = Input("ice_density", "kg/m^3", "density of the ice")
_PACK = (_SPEED, _CONCENTRATION, _THICKNESS, _BEAM, _ICE_DENSITY, gravity())


def pack_froude(speed: float, concentration: float, thickness: float, gravity: float) -> float:
    """Froude number of pack ice, V / sqrt(g h C)."""
    return speed / math.sqrt(gravity * thickness * concentration)


def colbourne(
    factor: float,
    power: float,
    exponent: float,
    *,
    speed: float,
    concentration: float,
    thickness: float,
    beam: float,
    ice_density: float,
    gravity: float,
) -> float:
    """Resistance [N] of Colbourne's form, 1/2 k Fr_p^-b rho_i B h V^2 C^n."""
    froude = pack_froude(speed, concentration, thickness, gravity)
    pressure = 0.5 * ice_density * beam * thickness * speed**2
    return factor * froude**-power * pressure * concentration**exponent


def _slender(**values: float) -> float:
    return colbourne(4.4, 0.8267, 2.0, **values)


def _blunt(**values: float) -> float:
    return colbourne(16.1, 1.7937, 3.0, **values)


def _huang(
    speed: float,
    concentration: float,
    thickness: float,
    beam: float,
    length: float,
    ice_density: float,
    gravity: float,
    factor: float,
) -> float:
    froude = speed / math.sqrt(gravity * length)
    pressure = ice_density * beam * thickness * speed**2
    return factor * pressure * concentration**1.5 / froude


def _beam_ratio(
    speed: float,
    concentration: float,
    thickness: float,
    beam: float,
    ice_density: float,
    gravity: float,
) -> float:
    froude = pack_froude(speed, concentration, thickness, gravity)
    ratio = 10 * thickness / beam
    coefficient = 10**2.651 * froude**-1.665 * ratio**1.019 * concentration**5.196
    return 0.5 * coefficient * ice_density * beam * thickness * concentration * speed**2


def _zuev(
    speed: float,
    concentration: float,
    thickness: float,
    beam: float,
    ice_density: float,
    gravity: float,
) -> float:
    froude = speed / math.sqrt(gravity * thickness)
    shape = 0.13 * beam / thickness + 1.3 * froude + 0.5 * froude**2
    weight = ice_density * gravity * beam * thickness**2
    return weight * shape * (2 - concentration) * concentration**2


_COLBOURNE = "Colbourne (2000), NRC"
_POLAR_ROUTE = (
    "vessel_performance/vessels/SDA.py of PolarRoute (British Antarctic Survey); "
    "the paper itself was not opened"
)

PACK_ICE = (
    Formula(
        "colbourne-slender",
        "Colbourne, slender bow",
        "mean resistance in pack ice",
        "N",
        _COLBOURNE,
        _POLAR_ROUTE,
        _PACK,
        _slender,
    ),
    Formula(
        "colbourne-blunt",
        "Colbourne, blunt bow",
        "mean resistance in pack ice",
        "N",
        _COLBOURNE,
        _POLAR_ROUTE,
        _PACK,
        _blunt,
    ),
    Formula(
        "huang",
        "Huang et al.",
        "mean resistance in a field of small rigid floes",
        "N",
        "Huang et al. (2021), regression of CFD with discrete elements for a container ship",
        "a public function of a routing program, which takes it below C h = 0.3 m; the factor 0.20 "
        "is that of one ship there, and the paper itself was not opened",
        (
            _SPEED,
            _CONCENTRATION,
            _THICKNESS,
            _BEAM,
            Input("length", "m", "length between perpendiculars"),
            _ICE_DENSITY,
            gravity(),
            Input("factor", "1", "factor of the ship", default=0.20),
        ),
        _huang,
    ),
    Formula(
        "beam-ratio",
        "Regression with the ratio of thickness to beam",
        "mean resistance in pack ice",
        "N",
        "author not named; probably for moored or blunt vessels",
        "a public model of Arctic routes; its range is not stated there",
        _PACK,
        _beam_ratio,
        doubt="Author and range are unknown.",
    ),
    Formula(
        "zuev",
        "Zuev",
        "mean resistance in broken ice",
        "N",
        "Zuev, as used by Russian programs",
        "MaximPansh/IceTech; its range is not stated there",
        _PACK,
        _zuev,
        doubt="Its range is unknown; model ice is far thinner next to the beam than its ships.",
    ),
)
