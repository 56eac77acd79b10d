"""The ice of a random scene: single floes, fields, how it varies and how it breaks."""
import json
import xml.etree.ElementTree as ET

from draw import add
from generate.plan import Plan

STRENGTHS = ("flexural_strength", "compressive_strength", "fracture_toughness")


def _outline(plan: Plan, x: float, y: float, size: float) -> list[float]:
    """A convex outline within a square of this size, its corners one on each side."""
    a, b, c, d = (plan.draw.number(-0.4, 0.4) * size for _ in range(4))
    corners = [(x + a, y - size / 2), (x + size / 2, y + b), (x + c, y + size / 2), (x - size / 2, y + d)]
    return [float(f"{value:.6g}") for corner in corners for value in corner]


def _clear(plan: Plan, region: tuple[float, float, float, float]) -> float:
    """Where floes with outlines of their own begin: fields are kept clear of the hull, these are not."""
    return region[0] + (0.26 * plan.length if plan.holder else 0)


def _add_floes(plan: Plan, ice: ET.Element, region: tuple[float, float, float, float], size: float) -> None:
    draw = plan.draw
    # The reference integrator suits few bodies.
    columns, rows = (1, draw.whole(1, 2)) if plan.reference else (draw.whole(1, 3), draw.whole(1, 3))
    x0, y0 = _clear(plan, region), -0.5 * rows * size
    for column in range(columns):
        for row in range(rows):
            fixed = draw.chance(0.1)
            add(ice, "floe", name=draw.maybe(0.3, f"floe {column} {row}"),
                outline=_outline(plan, x0 + (column + 0.5) * size, y0 + (row + 0.5) * size,
                                 size * draw.number(0.9, 0.999)),
                fixed=True if fixed else draw.maybe(0.1, False), breakable=draw.switch(),
                velocity=None if fixed else draw.maybe(0.7, [*draw.vector(plan.speed)[:2], 0.0]),
                thickness=draw.maybe(0.3, plan.length * draw.size(0.003, 0.02)),
                z=draw.maybe(0.1, draw.number(-0.001, 0.001) * plan.length))


def _file_of_floes(plan: Plan, region: tuple[float, float, float, float], size: float) -> str:
    features = []
    for number in range(plan.draw.whole(1, 4)):
        flat = _outline(plan, _clear(plan, region) + (number + 0.5) * size, 0, 0.98 * size)
        ring = [flat[k:k + 2] for k in range(0, len(flat), 2)]
        features.append({"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [ring + ring[:1]]},
                         "properties": {"thickness_m": round(0.01 * plan.length, 5)} if plan.draw.chance(0.5) else {}})
    plan.files["floes.geojson"] = json.dumps({"type": "FeatureCollection", "features": features}).encode()
    return "floes.geojson"


def _add_size(plan: Plan, field: ET.Element, size: float, library: bool) -> None:
    draw = plan.draw
    kind = draw.pick(("fixed", "uniform", "lognormal", "power-law") + (("as-library",) if library else ()))
    element = add(field, "size", distribution=kind)
    if kind in ("fixed", "lognormal"):
        element.set("mean", f"{size:.4g}")
    if kind == "lognormal":
        element.set("sd", f"{size * draw.number(0.05, 0.4):.4g}")
    if kind in ("uniform", "lognormal", "power-law"):
        element.set("min", f"{size * draw.number(0.4, 0.8):.4g}")
        element.set("max", f"{size * draw.number(1.2, 1.8):.4g}")
    if kind == "power-law" and draw.chance(0.5):
        element.set("exponent", f"{draw.number(0.5, 3):.2f}")


def _add_shape(plan: Plan, field: ET.Element, size: float, library: bool) -> None:
    draw = plan.draw
    kind = draw.pick(("polygon", "polygon", "rectangle", "square", "parallelogram", "disc"))
    shape = add(field, "shape", kind=kind)
    if kind == "polygon" and draw.chance(0.5):
        fewest = draw.whole(3, 6)
        shape.set("vertices", f"{fewest} {fewest + draw.whole(0, 4)}")
    if kind in ("rectangle", "parallelogram") and draw.chance(0.5):
        shape.set("aspect", f"{draw.number(1, 2.5):.2f}")
    if library:
        s = round(size / 2, 5)
        plan.files["outlines.json"] = json.dumps([[[-s, -s], [s, -s], [s, s / 2], [0, s]],
                                                  [[-s, -s], [s, -s], [0, s]]]).encode()
        shape.set("library", "outlines.json")


def _add_field(plan: Plan, ice: ET.Element, region: tuple[float, float, float, float], size: float) -> None:
    draw = plan.draw
    kinds = ("packed", "packed", "voronoi", "grid", "level", "channel", "file")
    kind = draw.pick(kinds)
    fixed = draw.chance(0.1)
    field = add(ice, "field", kind=kind, fixed=True if fixed else draw.maybe(0.1, False), breakable=draw.switch(0.6),
                velocity=None if fixed else draw.maybe(0.5, [*draw.vector(plan.speed)[:2], 0.0]),
                thickness=draw.maybe(0.2, plan.length * draw.size(0.003, 0.02)),
                z=draw.maybe(0.05, draw.number(-1e-3, 1e-3) * plan.length))
    if kind == "file":
        field.set("file", _file_of_floes(plan, region, size))
        return
    field.set("region", " ".join(f"{x:.5g}" for x in region))
    library = kind in ("packed", "channel") and draw.chance(0.15)
    bonded = kind == "voronoi" and draw.chance(0.4)
    if kind in ("packed", "voronoi", "channel"):
        field.set("concentration", "1" if bonded else f"{draw.number(0.1, 0.75):.2f}")
        _add_size(plan, field, size, library)
    if kind in ("packed", "channel"):
        _add_shape(plan, field, size, library)
        if draw.chance(0.2):
            field.set("overlap_tolerance", f"{draw.pick((0.0, 1e-3, 5e-3)):.3g}")
        if draw.chance(0.1):
            field.set("shear_deg", f"{draw.number(-30, 30):.3g}")
    if kind == "channel" and draw.chance(0.6):
        field.set("channel_width", f"{(region[3] - region[1]) * draw.number(0.5, 0.8):.4g}")
    if bonded:
        add(field, "bond", strength=draw.number(0.1, 1))
    if kind == "grid":
        field.set("rows", str(draw.whole(1, 4)))
        field.set("columns", str(draw.whole(1, 4)))
        if draw.chance(0.5):
            field.set("gap", f"{size * draw.size(1e-3, 0.05):.4g}")
        if draw.chance(0.4):
            field.set("stagger", "true" if draw.chance(0.7) else "false")
        if draw.chance(0.3):
            field.set("shear_deg", f"{draw.number(-30, 30):.3g}")


def _add_variation(plan: Plan, ice: ET.Element) -> None:
    draw = plan.draw
    properties = draw.some(draw.pick((("thickness", "density"), tuple(reversed(STRENGTHS)),
                                      ("thickness", *STRENGTHS))) if plan.fracture else ("thickness", "density"))
    correlated = draw.chance(0.4)
    length = draw.maybe(0.3, plan.length * draw.number(0.1, 1))
    for place, name in enumerate(properties):
        strength = name in STRENGTHS
        vary = add(ice, "vary", property=name, cov=draw.number(0, 0.3), correlation_length=length,
                   distribution=draw.pick(("normal", "lognormal", "uniform") + (("weibull",) if strength else ())))
        if strength and draw.chance(0.5):
            vary.set("mean", f"{draw.size(1e5, 1e6):.3g}")
        if correlated and place > 0:
            vary.set("with", properties[place - 1 if draw.chance(0.5) else 0])
            vary.set("correlation", f"{draw.number(-0.6, 0.6):.2f}")


def _add_fracture(plan: Plan, scene: ET.Element) -> None:
    draw = plan.draw
    scale = plan.length / 6
    fracture = add(scene, "fracture", flexural_strength=draw.maybe(0.7, scale * draw.size(1e3, 1e5)),
                   compressive_strength=draw.maybe(0.7, scale * draw.size(1e3, 1e6)),
                   fracture_toughness=draw.maybe(0.5, scale ** 1.5 * draw.size(1e2, 1e4)),
                   min_area=draw.maybe(0.4, plan.length ** 2 * draw.size(1e-5, 1e-3)),
                   small_pieces=draw.pick((None, "brash", "refuse")), max_aspect=draw.maybe(0.2, draw.number(2, 12)))
    if draw.chance(0.7):
        crushing = add(fracture, "crushing", model=draw.pick(("explicit", "compliant", "pressure-area")),
                       between_floes=draw.switch(),
                       clear_volume=draw.maybe(0.3, plan.length ** 3 * draw.size(1e-8, 1e-5)))
        if crushing.get("model") == "pressure-area" and draw.chance(0.6):
            crushing.set("coefficient", f"{scale * draw.size(1e3, 1e6):.3g}")
            crushing.set("exponent", f"{draw.number(-0.9, 0.5):.2f}")
    if not plan.buoyancy or plan.gravity == 0:
        return
    if draw.chance(0.7):
        add(fracture, "bending", model=draw.maybe(0.3, "nevel"), wedge_angle_deg=draw.maybe(0.3, draw.number(20, 60)),
            speed_slope=draw.maybe(0.3, draw.number(-5, 5)))
    if draw.chance(0.6):
        model = draw.pick(("geometric", "lefm"))
        add(fracture, "splitting", model=model,
            multiplier=draw.maybe(0.5, draw.number(1.5, 5)) if model == "geometric" else None)
    if draw.chance(0.5):
        path = draw.pick(("straight", "curved"))
        add(fracture, "cracks", path=path,
            segment_thicknesses=draw.maybe(0.3, draw.number(0.5, 10)) if path == "curved" else None)
    if draw.chance(0.4):
        add(fracture, "damage", exponent=draw.maybe(0.5, draw.number(1, 20)),
            endurance=draw.maybe(0.5, draw.number(0.05, 1)))


def add_ice(plan: Plan, scene: ET.Element, region: tuple[float, float, float, float]) -> None:
    """Adds the ice of a region, with strengths where the plan lets it break."""
    draw = plan.draw
    size = plan.length * draw.size(0.06, 0.2)
    ice = add(scene, "ice", thickness=draw.maybe(0.7 if plan.length > 50 else 1, plan.length * draw.size(0.002, 0.02)),
              preset=draw.maybe(0.3, draw.pick(("model", "full-scale sea ice", "full-scale freshwater ice"))),
              density=draw.maybe(0.5, draw.number(850, 930)), youngs_modulus=draw.maybe(0.4, draw.size(1e7, 9e9)),
              poisson=draw.maybe(0.4, draw.number(0, 0.5)))
    if plan.reference or draw.chance(0.4):
        _add_floes(plan, ice, region, 2 * size)
    else:
        _add_field(plan, ice, region, size)
    if draw.chance(0.2):
        middle = (region[0] + region[2]) / 2
        add(ice, "weak_line", points=[middle, region[1], middle, region[3]], strength=draw.number(0.1, 1))
    if draw.chance(0.3):
        _add_variation(plan, ice)
    if plan.fracture:
        _add_fracture(plan, scene)
