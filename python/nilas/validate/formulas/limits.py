"""What limits the load of ice on a fixed structure other than its strength."""

from __future__ import annotations

from nilas.validate.formulas.formula import Formula, Input

_THICKNESS = Input("thickness", "m", "thickness of the ice")
_ICE_DENSITY = Input("ice_density", "kg/m^3", "density of the ice")


def _driving_force(
    current_speed: float,
    form: float,
    skin: float,
    pieces: float,
    piece_length: float,
    piece_width: float,
    thickness: float,
    ice_density: float,
    water_density: float,
) -> float:
    draught = thickness * ice_density / water_density
    rubbed = piece_length * (piece_width + 2 * draught)
    pressed = piece_width * draught
    drag = 0.5 * water_density * current_speed**2 * (skin * rubbed + form * pressed)
    return pieces * drag


def _swept_momentum(
    speed: float, concentration: float, thickness: float, width: float, ice_density: float
) -> float:
    return ice_density * thickness * concentration * width * speed**2


LIMITS = (
    Formula(
        "driving-force",
        "Driving force of a current",
        "load of ice at rest that a current holds against a structure",
        "N",
        "the limit by force of ISO 19906; here the quadratic drag of the water on pieces at rest",
        "no constants but the drag coefficients of the scene",
        (
            Input("current_speed", "m/s", "speed of the current"),
            Input("form", "1", "coefficient of form drag"),
            Input("skin", "1", "coefficient of skin friction"),
            Input("pieces", "1", "number of rectangular pieces, along the current each"),
            Input("piece_length", "m", "their side along the current"),
            Input("piece_width", "m", "their side across the current"),
            _THICKNESS,
            _ICE_DENSITY,
            Input("water_density", "kg/m^3", "density of the water"),
        ),
        _driving_force,
    ),
    Formula(
        "swept-momentum",
        "Momentum of the swept ice",
        "load that gives all ice in the way of a structure its speed once",
        "N",
        "momentum balance: rho_i h C w V^2",
        "no constants",
        (
            Input("speed", "m/s", "speed of the structure through the ice"),
            Input("concentration", "1", "area of ice over area", high=1.0),
            _THICKNESS,
            Input("width", "m", "width of the structure at the waterline"),
            _ICE_DENSITY,
        ),
        _swept_momentum,
        doubt="It is no bound: floes clear before they reach the speed, and others are hit twice.",
    ),
)
