"""Bearing capacity and buckling of floating ice, as plates and wedges on an elastic foundation."""

from __future__ import annotations

import math

from nilas.validate.formulas.formula import Formula, Input, gravity
from nilas.validate.formulas.structures import flexural_length

_THICKNESS = Input("thickness", "m", "thickness of the ice")
_STRENGTH = Input("flexural_strength", "Pa", "flexural strength of the ice")
_MODULUS = Input("youngs_modulus", "Pa", "Young's modulus of the ice")
_POISSON = Input("poisson", "1", "Poisson's ratio of the ice", high=0.5, default=0.3)
_WATER_DENSITY = Input("water_density", "kg/m^3", "density of the water")
_RATIO = Input(
    "load_ratio", "1", "length of the loaded tip over the characteristic length", 0.0, 1.0
)
_NEVEL = "Nevel (1961), as quoted by Kerr (1975)"
_CHECKED = (
    "not confirmed in the paper; finite elements agree within 2 % for load ratios of 0.02 to 0.7, "
    "and 5 % at 1"
)


def nevel_factor(load_ratio: float) -> float:
    """6 P / (b0 sigma h^2) of a wedge whose tip carries P: 1.05 + 2 a/l + 0.5 (a/l)^3."""
    return 1.05 + 2 * load_ratio + 0.5 * load_ratio**3


def _wedge(
    thickness: float, flexural_strength: float, wedge_angle: float, load_ratio: float
) -> float:
    spread = 2 * math.tan(wedge_angle / 2)
    return spread * flexural_strength * thickness**2 / 6 * nevel_factor(load_ratio)


def _sheet(thickness: float, flexural_strength: float, load_ratio: float) -> float:
    return 2 * math.pi * flexural_strength * thickness**2 / 6 * nevel_factor(load_ratio)


def _edge(thickness: float, flexural_strength: float, width_ratio: float) -> float:
    return flexural_strength * thickness**2 / (0.95 - 1.505 * math.log(width_ratio))


def _buckling(
    thickness: float, youngs_modulus: float, poisson: float, water_density: float, gravity: float
) -> float:
    length = flexural_length(
        thickness=thickness,
        youngs_modulus=youngs_modulus,
        poisson=poisson,
        water_density=water_density,
        gravity=gravity,
    )
    return water_density * gravity * length**2


PLATES = (
    Formula(
        "nevel-wedge",
        "Nevel, one wedge",
        "vertical load that breaks a wedge at its tip",
        "N",
        _NEVEL,
        _CHECKED,
        (
            _THICKNESS,
            _STRENGTH,
            Input("wedge_angle", "rad", "angle of the wedge", high=math.pi / 2),
            _RATIO,
        ),
        _wedge,
    ),
    Formula(
        "nevel-sheet",
        "Nevel, many wedges around a load",
        "vertical load that breaks through a large sheet",
        "N",
        _NEVEL,
        _CHECKED,
        (_THICKNESS, _STRENGTH, _RATIO),
        _sheet,
    ),
    Formula(
        "plate-edge",
        "Edge of a half-infinite plate",
        "vertical load at which the edge cracks radially",
        "N",
        "Nevel (1965), Westergaard (1948)",
        "a fit of the solution by Fourier integrals, within 2 % for width ratios up to 0.5",
        (
            _THICKNESS,
            _STRENGTH,
            Input(
                "width_ratio",
                "1",
                "half width of the load over the characteristic length",
                0.01,
                0.5,
            ),
        ),
        _edge,
    ),
    Formula(
        "edge-buckling",
        "Buckling of a sheet with a free edge",
        "load per width at which a sheet buckles",
        "N/m",
        "Hetenyi (1946): a half-infinite beam on an elastic foundation with a free end, k l^2",
        "derived; a test solves the characteristic equation",
        (_THICKNESS, _MODULUS, _POISSON, _WATER_DENSITY, gravity()),
        _buckling,
    ),
)
