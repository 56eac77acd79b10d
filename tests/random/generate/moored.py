"""Mooring lines of a random vessel."""
import xml.etree.ElementTree as ET

from draw import add
from generate.plan import Plan


def _line(plan: Plan, mooring: ET.Element, number: int, side: tuple[int, int], on_turret: bool) -> None:
    draw = plan.draw
    bed = 2 * plan.length
    fairlead = [plan.length * (0.45 + 0.4 * side[0]), 0.3 * plan.beam * side[1], 0.9 * plan.depth]
    if on_turret:
        fairlead = [plan.length * 0.5, 0.1 * plan.beam * side[1], 0.0]
    away = plan.length * draw.number(3, 5)
    anchor = [plan.origin + fairlead[0] + side[0] * away, fairlead[1] + side[1] * away, plan.level - 0.99 * bed]
    span = sum((a - b) ** 2 for a, b in zip(anchor, [plan.origin + fairlead[0], fairlead[1], plan.level])) ** 0.5
    weight = plan.length ** 3 * 1000 * 0.006
    common = {"name": f"line{number}", "fairlead": fairlead, "anchor": anchor,
              "damping": draw.maybe(0.4, weight * draw.size(1e-3, 1)),
              "break_load": draw.maybe(0.2, weight * draw.size(10, 1e4)),
              "break_time": draw.maybe(0.2, plan.start + plan.duration / 2),
              "turret": on_turret or draw.maybe(0.2, False)}
    if draw.chance(0.5):
        add(mooring, "line", length=span * draw.number(0.98, 1.1),
            weight=weight / plan.length * draw.number(0.05, 0.3) * draw.pick((1, 1, 1, -0.2)),
            stiffness=weight * draw.size(10, 1e4), bed_friction=draw.maybe(0.4, draw.number(0, 1)),
            diameter=draw.maybe(0.3, 1e-3 * plan.length), **common)
        return
    spring = add(mooring, "spring_line", length=span * draw.number(0.9, 1.05), **common)
    if draw.chance(0.7):
        stiffness = weight / plan.length * draw.size(0.1, 100)
        spring.set("stiffness", f"{stiffness:.4g}")
        if draw.chance(0.3):
            spring.set("knee", f"{0.05 * plan.length:.4g}")
            spring.set("second_stiffness", f"{stiffness * draw.number(0, 5):.4g}")
    else:
        spring.set("table", plan.table("line.csv", ("stretch_m", "tension_N"),
                                       [(0, 0), (0.1 * plan.length, 0.01 * weight), (plan.length, weight)]))


def add_mooring(plan: Plan, vessel: ET.Element) -> None:
    """Adds three or four lines that spread to all sides; a turret at times, or a file that holds them."""
    draw = plan.draw
    as_placed = not plan.buoyancy or plan.gravity == 0 or draw.chance(0.4)
    mooring = add(vessel, "mooring", model=draw.maybe(0.3, "quasi-static"),
                  start="as-placed" if as_placed else draw.maybe(0.4, "equilibrium"))
    if draw.chance(0.8) or plan.tank:
        mooring.set("depth", f"{2 * plan.length:.5g}")
    holder = mooring
    if draw.chance(0.15):
        mooring.set("file", "lines.xml")
        holder = ET.Element("mooring")
    turret = draw.chance(0.3)
    for number, side in enumerate(((1, 1), (1, -1), (-1, 1), (-1, -1))):
        _line(plan, holder, number, side, turret and number < 3)
    if turret:
        add(holder, "turret", at=[plan.length * 0.5, 0.0, 0.0], friction=draw.maybe(0.4, plan.length ** 3))
    if holder is not mooring:
        plan.files["lines.xml"] = ET.tostring(holder)
