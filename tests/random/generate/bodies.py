"""Free and fixed bodies of a random scene."""
import xml.etree.ElementTree as ET

from draw import add
from generate.plan import Plan


def _shape(plan: Plan, body: ET.Element, size: float) -> tuple[float, float]:
    """Gives the body a shape of about this size; returns its half height and the radius around it."""
    draw = plan.draw
    free = body.get("fixed") != "true"
    shape = draw.pick(("box", "box",
                       "sphere") + (() if plan.reference and free else ("cylinder",
                                                                        )) + (() if plan.adrift else ("mesh",)))
    body.set("shape", shape)
    if shape == "box":
        edges = [size * draw.size(0.1, 1) for _ in range(3)]
        body.set("size", " ".join(f"{edge:.4g}" for edge in edges))
        return edges[2] / 2, sum(edge ** 2 for edge in edges) ** 0.5 / 2
    if shape == "sphere":
        radius = 0.5 * size * draw.size(0.2, 1)
        body.set("radius", f"{radius:.4g}")
        return float(f"{radius:.4g}"), radius
    if shape == "cylinder":
        radius, height = 0.5 * size * draw.size(0.2, 1), size * draw.size(0.1, 1)
        body.set("radius", f"{radius:.4g}")
        body.set("height", f"{height:.4g}")
        return height / 2, (radius ** 2 + height ** 2 / 4) ** 0.5
    body.set("mesh", plan.wedge("wedge.stl", size))
    return size / 4, 0.75 * size


def _mass(plan: Plan, body: ET.Element) -> None:
    draw = plan.draw
    kind = draw.pick(("none", "mass", "density", "density"))
    if kind == "mass":
        body.set("mass", f"{draw.size(1e-2, 1e3):.4g}")
    if kind == "density":
        body.set("density", f"{draw.size(100, 8000):.4g}")
    if kind == "mass" and draw.chance(0.3):
        # The tensor of three masses on the axes, turned nowhere: its moments obey the inequality of a solid.
        a, b, c = (draw.size(1e-2, 10) for _ in range(3))
        body.set("inertia", f"{b + c:.6g} {a + c:.6g} {a + b:.6g} 0 0 0")


def _place(plan: Plan, body: ET.Element, at: tuple[float, float, float], stands: bool) -> None:
    draw = plan.draw
    body.set("position", " ".join(f"{x:.6g}" for x in at))
    if not stands:
        body.set("rotation_deg", " ".join(f"{angle:.4g}" for angle in draw.vector(180)))
    if body.get("fixed") != "true":
        if draw.chance(0.7):
            body.set("velocity", " ".join(f"{v:.4g}" for v in draw.vector(2 * plan.speed)))
        if draw.chance(0.5):
            body.set("angular_velocity", " ".join(f"{w:.4g}" for w in draw.vector(5)))


def add_bodies(plan: Plan, scene: ET.Element, count: int, origin: tuple[float, float], size: float) -> None:
    """Adds a plane at times, and bodies in columns from the origin on, in the direction of -X, near enough to meet."""
    draw = plan.draw
    floor = draw.chance(0.6) and not (plan.holder or plan.ice or plan.adrift)
    if floor:
        tilt = draw.pick((0.0, 0.0, draw.number(-20, 20)))
        add(scene, "body", name="floor", shape="plane", fixed=draw.maybe(0.3, True),
            rotation_deg=[0.0, tilt, 0.0] if tilt else None)
    x, top = origin[0], 0.0
    for number in range(count):
        fixed = not floor and not plan.adrift and draw.chance(0.25)
        body = add(scene, "body", name=draw.maybe(0.7, f"solid {number}"),
                   fixed=True if fixed else draw.maybe(0.2, False))
        if draw.chance(0.3):
            plan.materials.append(f"stuff{number}")
            body.set("material", f"stuff{number}")
        half, radius = _shape(plan, body, size)
        if not fixed:
            _mass(plan, body)
        stands = draw.chance(0.5)
        reach = half if stands else radius
        new_column = draw.chance(0.5)
        if new_column:
            x, top = x - radius - draw.size(1e-3, 0.3) * size - size * (0.0 if stands else 0.5), 0.0
        gap = draw.pick((0.0, 0.0, draw.size(1e-4, 0.1) * size))
        height = top + reach + gap
        _place(plan, body, (x, origin[1], height if floor or not plan.has_water else plan.level + height - size / 4),
               stands)
        top = height + reach
