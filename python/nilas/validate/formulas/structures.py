"""Loads of level ice on sloping and vertical structures."""

from __future__ import annotations

import math

from scipy.special import ellipe, ellipk

from nilas.validate.formulas.formula import Condition, Formula, Input, gravity

_WIDTH = Input("width", "m", "width of the structure at the waterline")
_SLOPE = Input("slope_angle", "rad", "angle of the face from horizontal", high=math.pi / 2)
_THICKNESS = Input("thickness", "m", "thickness of the ice")
_STRENGTH = Input("flexural_strength", "Pa", "flexural strength of the ice")
_FRICTION = Input("friction", "1", "coefficient of friction between ice and structure", high=1.0)
_ICE_DENSITY = Input("ice_density", "kg/m^3", "density of the ice")
_ICE_FLOE = "the module IceFloe of OpenFAST"


def flexural_length(
    *, thickness: float, youngs_modulus: float, poisson: float, water_density: float, gravity: float
) -> float:
    """Characteristic length of a floating plate [m], (E h^3 / (12 rho_w g (1 - nu^2)))^(1/4)."""
    stiffness = youngs_modulus * thickness**3 / (12 * (1 - poisson**2))
    return (stiffness / (water_density * gravity)) ** 0.25


def slope_factor(slope_angle: float, friction: float) -> float:
    """Horizontal over vertical force on a sloping face with friction."""
    sine, cosine = math.sin(slope_angle), math.cos(slope_angle)
    if friction * sine >= cosine:
        raise ValueError("ice does not slide up a face of this angle and friction")
    return (sine + friction * cosine) / (cosine - friction * sine)


def breaking_width(width: float, **plate: float) -> float:
    """The width over which the sheet breaks [m], w + pi^2 L_c / 4."""
    return width + math.pi**2 / 4 * flexural_length(**plate)


def breaking_load(
    *,
    width: float,
    slope_angle: float,
    thickness: float,
    flexural_strength: float,
    friction: float,
    youngs_modulus: float,
    poisson: float,
    water_density: float,
    gravity: float,
) -> float:
    """Horizontal load [N] that breaks the sheet, H_B of Croasdale."""
    plate = {
        "thickness": thickness, "youngs_modulus": youngs_modulus, "poisson": poisson,
        "water_density": water_density, "gravity": gravity,
    }  # fmt: skip
    length = (water_density * gravity * thickness**5 / youngs_modulus) ** 0.25
    face = slope_factor(slope_angle, friction)
    return 0.68 * face * flexural_strength * length * breaking_width(width, **plate)


def _rubble_loads(
    width: float,
    slope_angle: float,
    thickness: float,
    friction: float,
    ice_friction: float,
    ice_density: float,
    gravity: float,
    rubble_height: float,
    rubble_angle: float,
    rubble_porosity: float,
    rubble_cohesion: float,
    rubble_friction_angle: float,
) -> float:
    """The loads [N] of pushing through rubble, of riding up, of lifting rubble and of turning."""
    sine, cosine, tangent = math.sin(slope_angle), math.cos(slope_angle), math.tan(slope_angle)
    weight = ice_density * gravity
    loose = weight * (1 - rubble_porosity)
    part = 1 - math.tan(rubble_angle) / tangent
    cotangents = 1 / math.tan(rubble_angle) - 1 / tangent
    pushed = width * rubble_height**2 * ice_friction * loose * part**2 / 2 / math.tan(rubble_angle)
    both = ice_friction + friction
    ride = 0.5 * ice_friction * both * loose * rubble_height**2 * sine * cotangents * part
    ride += 0.5 * both * loose * rubble_height**2 * cosine / tangent * part
    ride += rubble_height * thickness * weight * (sine + friction * cosine) / sine
    ride *= width / (cosine - friction * sine)
    lift = 0.5 * rubble_height * loose * (cotangents + math.tan(rubble_friction_angle) * part)
    lift = (lift + rubble_cohesion) * width * rubble_height * part
    lift *= slope_factor(slope_angle, friction)
    turn = 1.5 * width * thickness**2 * weight * cosine / (sine - friction * cosine)
    return pushed + ride + lift + turn


def _croasdale(
    width: float,
    slope_angle: float,
    thickness: float,
    flexural_strength: float,
    friction: float,
    youngs_modulus: float,
    poisson: float,
    water_density: float,
    gravity: float,
    **rubble: float,
) -> float:
    plate = {
        "thickness": thickness, "youngs_modulus": youngs_modulus, "poisson": poisson,
        "water_density": water_density, "gravity": gravity,
    }  # fmt: skip
    face = {"width": width, "slope_angle": slope_angle, "friction": friction}
    breaking = breaking_load(flexural_strength=flexural_strength, **face, **plate)
    rest = _rubble_loads(thickness=thickness, gravity=gravity, **face, **rubble)
    squeezed = breaking / (flexural_strength * breaking_width(width, **plate) * thickness)
    return (breaking + rest) / (1 - squeezed)


def _croasdale_bare(ice_density: float, **values: float) -> float:
    none = {
        "ice_friction": 0.0, "rubble_height": 0.0, "rubble_angle": values["slope_angle"],
        "rubble_porosity": 0.0, "rubble_cohesion": 0.0, "rubble_friction_angle": 0.0,
    }  # fmt: skip
    return _croasdale(ice_density=ice_density, **values, **none)


def _ralston(
    width: float,
    top_width: float,
    slope_angle: float,
    thickness: float,
    ride_up_thickness: float,
    flexural_strength: float,
    friction: float,
    ice_density: float,
    gravity: float,
) -> float:
    sine, cosine, tangent = math.sin(slope_angle), math.cos(slope_angle), math.tan(slope_angle)
    weight = ice_density * gravity * width**2 / (4 * flexural_strength * thickness)
    yielding = 2.711
    x = 1 + 1 / math.sqrt(3 * weight + yielding / 2)
    share = sine + slope_angle / cosine
    share /= math.pi / 2 * sine**2 + 2 * friction * slope_angle * cosine
    left = 1 - share * friction
    if left <= 0:
        raise ValueError("ice does not slide up a cone of this angle and friction")
    hinges = weight * (x - 1) * (x + 2) + (1 + yielding * x * math.log(x)) / (x - 1)
    breaking = flexural_strength * thickness**2 / 3 * tangent / left * hinges
    sheet = ice_density * gravity * ride_up_thickness * (width**2 - top_width**2) / (4 * cosine)
    modulus = sine**2
    around = friction * float(ellipk(modulus)) * cosine + sine
    slide = friction * (float(ellipe(modulus)) - around * share * cosine)
    return breaking + sheet * (tangent + slide) / left


def iso_exponent(thickness: float) -> float:
    """The exponent n of the thickness: -0.50 + h / 5, and -0.30 from 1 m on."""
    return min(-0.30, -0.50 + thickness / 5)


def _iso_crushing(width: float, thickness: float, strength_coefficient: float) -> float:
    pressure = strength_coefficient * thickness ** iso_exponent(thickness)
    return pressure * (width / thickness) ** -0.16 * width * thickness


def _full_contact(width: float, thickness: float, compressive_strength: float) -> float:
    return compressive_strength * width * thickness


def _pressure_area(width: float, thickness: float, coefficient: float, exponent: float) -> float:
    return coefficient * (width * thickness) ** (1 + exponent)


_SHEET = (
    _WIDTH, _SLOPE, _THICKNESS, _STRENGTH, _FRICTION,
    Input("youngs_modulus", "Pa", "Young's modulus of the ice"),
    Input("poisson", "1", "Poisson's ratio of the ice", high=0.5, default=0.3),
    Input("water_density", "kg/m^3", "density of the water"),
    gravity(),
)  # fmt: skip
_RUBBLE = (
    Input("ice_friction", "1", "friction between pieces of ice", high=1.0),
    _ICE_DENSITY,
    Input("rubble_height", "m", "height of the rubble on the face"),
    Input("rubble_angle", "rad", "angle of the rubble from horizontal", high=math.pi / 2),
    Input("rubble_porosity", "1", "porosity of the rubble", high=1.0),
    Input("rubble_cohesion", "Pa", "cohesion of the rubble"),
    Input("rubble_friction_angle", "rad", "angle of internal friction of the rubble"),
)

STRUCTURES = (
    Formula(
        "croasdale",
        "Croasdale",
        "largest horizontal load on a sloping face",
        "N",
        "Croasdale and Cammaert (1994), in ISO 19906",
        _ICE_FLOE + ", IceFlexISO.f90",
        (*_SHEET, *_RUBBLE),
        _croasdale,
    ),
    Formula(
        "croasdale-bare",
        "Croasdale without rubble",
        "largest horizontal load of breaking and turning a sheet",
        "N",
        "Croasdale and Cammaert (1994), in ISO 19906",
        _ICE_FLOE + ", IceFlexISO.f90",
        (*_SHEET, _ICE_DENSITY),
        _croasdale_bare,
    ),
    Formula(
        "ralston",
        "Ralston",
        "largest horizontal load on a cone",
        "N",
        "Ralston (1977), POAC, in IEC 61400-3",
        _ICE_FLOE + ", IceFlexIEC.f90",
        (
            _WIDTH,
            Input("top_width", "m", "diameter of the cone's top"),
            _SLOPE,
            _THICKNESS,
            Input("ride_up_thickness", "m", "thickness of the ice that rides up"),
            _STRENGTH,
            _FRICTION,
            _ICE_DENSITY,
            gravity(),
        ),
        _ralston,
        conditions=(
            Condition(
                "The module takes slopes of 20 to 70 degrees alone.",
                lambda values: math.radians(20) <= values["slope_angle"] <= math.radians(70),
            ),
        ),
    ),
    Formula(
        "iso-crushing",
        "ISO 19906, crushing on a vertical face",
        "largest load of crushing ice on a wide vertical face",
        "N",
        "ISO 19906 (2010), global pressure p = C_R (h / 1 m)^n (w / h)^m",
        _ICE_FLOE + ", globalCrushLoadISO, for the form and the exponents",
        (
            _WIDTH,
            _THICKNESS,
            # 2.8 MPa is said to hold in the Arctic, and 1.8 MPa in the Baltic.
            Input("strength_coefficient", "Pa", "C_R, the pressure at h = w = 1 m"),
        ),
        _iso_crushing,
        doubt="The values of C_R were not confirmed in the standard.",
        slopes_count=True,
        similar=False,
    ),
    Formula(
        "full-contact",
        "Compressive strength over the whole face",
        "load of ice that crushes over the whole face",
        "N",
        "definition: strength times width times thickness",
        "no constants",
        (
            _WIDTH,
            _THICKNESS,
            Input("compressive_strength", "Pa", "compressive strength of the ice"),
        ),
        _full_contact,
    ),
    Formula(
        "pressure-area",
        "Pressure that falls with the area",
        "load of ice that crushes over the whole face",
        "N",
        "definition: c A^(1 + e) with A = width times thickness",
        "no constants; ISO 19906 has e = -0.70 for local pressures",
        (
            _WIDTH,
            _THICKNESS,
            Input("coefficient", "Pa", "pressure on an area of 1 m^2"),
            Input("exponent", "1", "exponent of the area", low=-1.0, high=1.0),
        ),
        _pressure_area,
        similar=False,
    ),
)
