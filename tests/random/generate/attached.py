"""Parts and rods of a random vessel."""
import xml.etree.ElementTree as ET

from draw import add
from generate.plan import Plan


def add_parts(plan: Plan, vessel: ET.Element) -> None:
    """Adds bodies that joints hold astern of the hull."""
    draw = plan.draw
    names: list[str] = []
    for number in range(draw.whole(1, 2)):
        size = plan.length * draw.number(0.02, 0.06)
        joint = draw.pick(("hinge", "slider", "ball", "free", "weld"))
        back = -(number + 1) * 0.15 * plan.length
        part = add(vessel, "part", name=f"part{number}", joint=joint, to=draw.maybe(0.4, names[-1]) if names else None,
                   position=[back, 0.0, 0.5 * plan.draught], at=draw.maybe(0.5,
                                                                           [back + 0.05 * plan.length, 0.0,
                                                                            0.5 * plan.draught]),
                   rotation_deg=draw.maybe(0.2, draw.vector(20)))
        shape = draw.pick(("box", "sphere", "mesh") + (() if plan.reference else ("cylinder",)))
        part.set("shape", shape)
        if shape == "box":
            part.set("size", f"{size:.4g} {size / 2:.4g} {size:.4g}")
        if shape in ("sphere", "cylinder"):
            part.set("radius", f"{size / 2:.4g}")
        if shape == "cylinder":
            part.set("height", f"{size:.4g}")
        if shape == "mesh":
            part.set("mesh", plan.wedge("part.stl", size))
            if draw.chance(0.3):
                part.set("cog", f"{-0.1 * size:.4g} 0 0")
        if draw.chance(0.3):
            plan.materials.append(f"steel{number}")
            part.set("material", f"steel{number}")
        if draw.chance(0.5):
            part.set("density", f"{draw.number(300, 8000):.4g}")
        else:
            if shape == "box" and draw.chance(0.3):
                inertia = 80 * size ** 5
                part.set("inertia", f"{inertia:.4g} {inertia:.4g} {inertia:.4g} 0 0 0")
            part.set("mass", f"{1000 * size ** 3 * draw.size(0.3, 5):.4g}")
        _set_joint(plan, part, joint)
        names.append(f"part{number}")


def _set_joint(plan: Plan, part: ET.Element, joint: str) -> None:
    draw = plan.draw
    weight = plan.length ** 3
    if joint in ("hinge", "slider"):
        part.set("axis", draw.pick(("0 0 1", "0 1 0", "1 0 0", "1 1 0")))
    if joint in ("hinge", "slider", "ball"):
        part.set("stiffness", f"{weight * draw.size(1e-1, 1e3):.3g}")
        part.set("damping", f"{weight * draw.size(1e-2, 10):.3g}")
    if joint == "hinge":
        for name, size in (("angle_deg", 20), ("rest_angle_deg", 20), ("rate_deg", 20)):
            if draw.chance(0.4):
                part.set(name, f"{draw.number(-size, size):.3g}")
    if joint == "slider":
        for name in ("travel", "rest_travel", "speed"):
            if draw.chance(0.4):
                part.set(name, f"{draw.number(-0.01, 0.01) * plan.length:.3g}")


def add_rods(plan: Plan, vessel: ET.Element) -> None:
    """Adds links from the sides of the hull to fixed points beside it."""
    draw = plan.draw
    for number, side in enumerate(draw.pick(((1,), (1, -1)))):
        x, y = 0.4 * plan.length, side * 0.5 * plan.beam
        add(vessel, "rod", name=f"rod{number}", at=[x, y, plan.draught], on=draw.maybe(0.3, vessel.get("name", "ship")),
            to=[plan.origin + x + draw.number(-0.1, 0.1) * plan.length, y + side * plan.length,
                plan.level + draw.number(0, 0.2) * plan.length])
