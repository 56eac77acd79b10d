"""Resistance in level ice and in brash-filled channels."""

from __future__ import annotations

import math

from nilas.validate.formulas.formula import Condition, Formula, Input, gravity

_SPEED = Input("speed", "m/s", "speed through the ice")
_THICKNESS = Input("thickness", "m", "thickness of the ice")
_BEAM = Input("beam", "m", "beam at the waterline")
_LENGTH = Input("length", "m", "length at the waterline")
_DRAUGHT = Input("draught", "m", "draught")
_FRICTION = Input("friction", "1", "coefficient of friction between hull and ice", high=1.0)
_STEM = Input("stem_angle", "rad", "angle of the stem from horizontal", high=math.pi / 2)
_ENTRANCE = Input(
    "entrance_angle", "rad", "half angle of the waterline at the stem", high=math.pi / 2
)
_STRENGTH = Input("flexural_strength", "Pa", "flexural strength of the ice")
_MODULUS = Input("youngs_modulus", "Pa", "Young's modulus of the ice")
_POISSON = Input("poisson", "1", "Poisson's ratio of the ice", high=0.5, default=0.3)
_WATER_DENSITY = Input("water_density", "kg/m^3", "density of the water")
_ICE_DENSITY = Input("ice_density", "kg/m^3", "density of the ice")


def normal_angle(stem_angle: float, entrance_angle: float) -> float:
    """The angle of the bow's normal from vertical [rad], psi = atan(tan phi / sin alpha)."""
    return math.atan(math.tan(stem_angle) / math.sin(entrance_angle))


def lindqvist_parts(
    *,
    thickness: float,
    beam: float,
    length: float,
    draught: float,
    friction: float,
    stem_angle: float,
    entrance_angle: float,
    flexural_strength: float,
    youngs_modulus: float,
    poisson: float,
    water_density: float,
    ice_density: float,
    gravity: float,
) -> tuple[float, float, float]:
    """Crushing at the stem, breaking by bending, and submersion [N], all at no speed."""
    psi = normal_angle(stem_angle, entrance_angle)
    mu, sigma, h = friction, flexural_strength, thickness
    sine, cosine, tangent = math.sin(stem_angle), math.cos(stem_angle), math.tan(stem_angle)
    slide = mu * cosine / math.cos(psi)
    crushing = 0.5 * sigma * h**2 * (tangent + slide) / (1 - mu * sine / math.cos(psi))
    foundation = math.sqrt(youngs_modulus / (12 * (1 - poisson**2) * water_density * gravity))
    breaking = 27 / 64 * sigma * beam * h**1.5 / foundation
    breaking *= math.tan(psi) + slide / math.sin(entrance_angle)
    breaking *= 1 + 1 / math.cos(psi)
    under = 0.7 * length - draught / tangent - beam / (4 * math.tan(entrance_angle))
    slope = math.sqrt(1 / sine**2 + 1 / math.tan(entrance_angle) ** 2)
    under += draught * cosine * math.cos(psi) * slope
    lost = draught * (beam + draught) / (beam + 2 * draught)
    weight = (water_density - ice_density) * gravity * h * beam
    return crushing, breaking, weight * (lost + mu * under)


def _lindqvist(speed: float, **values: float) -> float:
    crushing, breaking, submersion = lindqvist_parts(**values)
    fast = speed / math.sqrt(values["gravity"] * values["thickness"])
    slow = speed / math.sqrt(values["gravity"] * values["length"])
    return (crushing + breaking) * (1 + 1.4 * fast) + submersion * (1 + 9.4 * slow)


def _submersion(speed: float, **values: float) -> float:
    # Breaking and crushing vanish with the strength, and do not depend on it otherwise.
    soft = {"flexural_strength": 0.0, "youngs_modulus": 1.0, "poisson": 0.0}
    return _lindqvist(speed, **values, **soft)


def _riska(
    speed: float,
    thickness: float,
    beam: float,
    length: float,
    draught: float,
    stem_angle: float,
    parallel_length: float,
    bow_length: float,
) -> float:
    degrees = math.degrees(stem_angle)
    side = 230 * beam * parallel_length * thickness / (2 * draught / beam + 1)
    bow = 4580 * beam * thickness**2 + 1470 * bow_length * thickness**2
    bow += 290 * beam * bow_length * thickness
    still = side + (1 + 0.021 * degrees) * bow
    moving = (1 + 0.063 * degrees) * (18900 * thickness**1.5 + 670 * beam * thickness)
    moving += 1550 * thickness * (1 + 1.2 * draught / beam) * beam**2 / math.sqrt(length)
    return still + moving * speed


def _keinonen(
    speed: float,
    thickness: float,
    beam: float,
    length: float,
    draught: float,
    flexural_strength: float,
    flare_angle: float,
    buttock_angle: float,
    ice_temperature: float,
    salinity_factor: float,
    hull_factor: float,
) -> float:
    size = beam**0.7 * length**0.2 * draught**0.1 * thickness**1.25
    ice = (1 - 0.0083 * (ice_temperature + 30)) * (0.63 + 0.00074 * flexural_strength / 1e3)
    # Complex beyond the angles for which the formula has terms; Formula.value refuses it then.
    flare = 1 + 0.0018 * (90 - math.degrees(flare_angle)) ** 1.4
    buttock = 1 + 0.004 * (math.degrees(buttock_angle) - 5) ** 1.5
    hull = salinity_factor * hull_factor * flare * buttock
    return 1e6 * (0.08 + 0.017 * size * ice * hull)


def brash_thickness(channel_thickness: float, beam: float) -> float:
    """Thickness [m] of the brash that the bow pushes aside, 0.26 + sqrt(H_M B)."""
    return 0.26 + math.sqrt(channel_thickness * beam)


def _brash_channel(
    channel_thickness: float,
    beam: float,
    length: float,
    draught: float,
    parallel_length: float,
    stem_angle: float,
    entrance_angle: float,
    bow_flare: float,
    bow_area: float,
) -> float:
    psi = math.atan(math.tan(bow_flare) / math.sin(entrance_angle))
    friction = 0.15 * math.cos(stem_angle) + math.sin(psi) * math.sin(entrance_angle)
    friction = max(friction, 0.45)
    degrees = math.degrees(psi)
    spread = 0.047 * degrees - 2.115 if degrees > 45 else 0.0
    pushed = brash_thickness(channel_thickness, beam)
    bow = 845 * friction * (pushed + channel_thickness) ** 2 * (beam + spread * pushed)
    side = 42 * parallel_length * pushed**2
    waves = 825 * (length * draught / beam**2) ** 3 * bow_area / length
    return bow + side + waves


_MERCHANT_SHIPS = "The rules hold for merchant ships of 65 to 250 m; the model is far smaller."


def _is_ship(values) -> bool:
    return 65 <= values["length"] <= 250 and 11 <= values["beam"] <= 40


LEVEL_ICE = (
    Formula(
        "lindqvist",
        "Lindqvist",
        "mean resistance in level ice",
        "N",
        "Lindqvist (1989), POAC",
        "the structure in a public calculator of ice resistance, whose brackets are wrong; six "
        "values that Hu and Zhou (2016) publish for MT Uikku depend on thickness, strength, "
        "modulus and speed as it does, within 0.1 %",
        (
            _SPEED,
            _THICKNESS,
            _BEAM,
            _LENGTH,
            _DRAUGHT,
            _FRICTION,
            _STEM,
            _ENTRANCE,
            _STRENGTH,
            _MODULUS,
            _POISSON,
            _WATER_DENSITY,
            _ICE_DENSITY,
            gravity(),
        ),  # fmt: skip
        _lindqvist,
        doubt="The terms of the hull's angles were not confirmed in the paper.",
        slopes_count=True,
    ),
    Formula(
        "lindqvist-submersion",
        "Lindqvist, submersion alone",
        "mean resistance in ice that is cut already",
        "N",
        "Lindqvist (1989), POAC",
        "as lindqvist",
        (
            _SPEED,
            _THICKNESS,
            _BEAM,
            _LENGTH,
            _DRAUGHT,
            _FRICTION,
            _STEM,
            _ENTRANCE,
            _WATER_DENSITY,
            _ICE_DENSITY,
            gravity(),
        ),  # fmt: skip
        _submersion,
        doubt="The terms of the hull's angles were not confirmed in the paper.",
        slopes_count=True,
    ),
    Formula(
        "riska",
        "Riska (FSICR level ice)",
        "mean resistance in level ice",
        "N",
        "Riska et al. (1997), in the Finnish-Swedish ice class rules",
        "a public function of a routing program; values that Hu and Zhou (2016) publish for MT "
        "Uikku agree within 1 %",
        (
            _SPEED,
            _THICKNESS,
            _BEAM,
            _LENGTH,
            _DRAUGHT,
            _STEM,
            Input("parallel_length", "m", "length of the parallel midbody"),
            Input("bow_length", "m", "length of the bow"),
        ),  # fmt: skip
        _riska,
        # Its speed terms have constants with dimensions that do not scale.
        conditions=(Condition(_MERCHANT_SHIPS, _is_ship),),
        similar=False,
    ),
    Formula(
        "keinonen",
        "Keinonen, rounded hull at 1 m/s",
        "mean resistance in level ice",
        "N",
        "Keinonen et al. (1996), regression of trials of icebreakers",
        "no text that could be opened; offset, power of the thickness and terms of the strength "
        "agree within 0.2 % with the two values that Hu and Zhou (2016) publish at 1 m/s",
        (
            Input("speed", "m/s", "speed through the ice", 0.99, 1.01),
            _THICKNESS,
            _BEAM,
            _LENGTH,
            _DRAUGHT,
            _STRENGTH,
            Input("flare_angle", "rad", "mean angle of the sides from horizontal",
                  high=math.pi / 2),
            Input("buttock_angle", "rad", "mean angle of the buttocks of the bow from horizontal",
                  math.radians(5), math.pi / 2),
            Input("ice_temperature", "degC", "temperature of the ice surface", -30.0, 0.0),
            Input("salinity_factor", "1", "1 in the sea, less in brackish water", default=1.0),
            Input("hull_factor", "1", "1 for a coated hull, more for bare steel", default=1.0),
        ),  # fmt: skip
        _keinonen,
        conditions=(Condition(_MERCHANT_SHIPS, _is_ship),),
        doubt="The terms of the hull and of the temperature were not confirmed in the paper.",
        similar=False,
    ),
    Formula(
        "fsicr-channel",
        "FSICR brash channel",
        "resistance in a channel of brash ice at 5 knots",
        "N",
        "Finnish-Swedish ice class rules",
        "no text that could be opened",
        (
            Input("channel_thickness", "m", "thickness of the brash in the channel"),
            _BEAM,
            _LENGTH,
            _DRAUGHT,
            Input("parallel_length", "m", "length of the parallel midbody"),
            _STEM,
            _ENTRANCE,
            Input("bow_flare", "rad", "rake of the bow at a quarter of the beam"),
            Input("bow_area", "m^2", "area of the waterplane of the bow"),
        ),  # fmt: skip
        _brash_channel,
        conditions=(Condition(_MERCHANT_SHIPS, _is_ship),),
        doubt="No constant was confirmed in the rules.",
        similar=False,
    ),
)
