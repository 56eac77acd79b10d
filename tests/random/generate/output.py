"""What a random scene stores and how it is first seen."""
import xml.etree.ElementTree as ET

from draw import add
from generate.plan import Plan


def add_output(plan: Plan, scene: ET.Element) -> None:
    """Adds the output element. Every state of all bodies is stored, so that judges can read it."""
    draw = plan.draw
    output = add(scene, "output", trajectory_every=plan.step,
                 bodies=draw.pick((None, None, None, None, True, True, True, True, True, False)),
                 folder=draw.maybe(0.1, "stored"))
    kinds = ["hull", "none"] + ([] if plan.reference else ["all"])
    if draw.chance(0.5):
        output.set("contacts", draw.pick(kinds))
    if not plan.rolling and draw.chance(0.2):
        output.set("problems", draw.pick(("never", "worst", "failed", "every")))
    if draw.chance(0.2):
        output.set("tank_walls", "true" if draw.chance(0.5) else "false")
    if draw.chance(0.2):
        output.set("statistics", f"{plan.start + plan.duration * 0.2:.5g} {plan.start + plan.duration:.5g}")
    if draw.chance(0.2):
        output.set("peak_filter", f"{plan.step * draw.number(1, 10):.4g}")
    if draw.chance(0.3):
        output.set("load_checks", str(draw.pick((0, 1, 10))))
    if not plan.reference and draw.chance(0.1):
        output.set("checkpoint_every", f"{plan.step * draw.whole(1, 8):.5g}")


def add_view(plan: Plan, scene: ET.Element) -> None:
    """Adds the first view, which must change nothing."""
    draw = plan.draw
    add(scene, "view", camera_elevation_deg=draw.maybe(0.5, draw.number(-90, 90)),
        camera_heading_deg=draw.maybe(0.5, draw.number(-360, 360)),
        camera_distance=draw.maybe(0.5, draw.size(1, 1000)), target=draw.maybe(0.5, draw.vector(10)),
        mesh=draw.pick((None, "collision", "fluid")), wireframe=draw.switch(), normals=draw.switch())
