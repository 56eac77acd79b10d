"""A random scene as a whole."""
import xml.etree.ElementTree as ET
from dataclasses import dataclass
from pathlib import Path

from draw import Draw, add
from generate.bodies import add_bodies
from generate.contact import add_contact, draw_law
from generate.ice import add_ice
from generate.output import add_output, add_view
from generate.plan import Plan
from generate.vessel import add_vessel
from generate.water import add_hydro, add_tank, add_wind

# Elements in the order of the reference.
ORDER = ("time", "gravity", "seed", "contact", "water", "hydro", "tank", "wind", "vessel", "ice", "fracture", "body",
         "output", "view")


@dataclass
class RandomScene:
    """The XML of a scene and the files that it names."""

    xml: ET.Element
    files: dict[str, bytes]

    def write(self, folder: Path) -> Path:
        """Writes scene.xml and its files into the folder; gives the path of the scene."""
        for name, content in self.files.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(content)
        folder.mkdir(parents=True, exist_ok=True)
        ET.indent(self.xml)
        (folder / "scene.xml").write_bytes(ET.tostring(self.xml, encoding="UTF-8", xml_declaration=True) + b"\n")
        return folder / "scene.xml"


def _plan(draw: Draw) -> Plan:
    theme = draw.pick(("bodies", "adrift", "ice", "ice", "vessel", "vessel", "vessel", "vessel"))
    integrator = draw.pick(("moreau",) * 5 + ("semi-implicit-euler",) * 4 + ("reference",))
    weightless = theme == "adrift" or (theme != "vessel" and draw.chance(0.2))
    plan = Plan(draw, length=draw.pick((6.0, 2.0, draw.size(1, 20), draw.size(50, 320))), step=0.01,
                steps=draw.whole(8, 30),
                start=draw.pick((0.0, 0.0, draw.number(-5, 50))),
                gravity=0.0 if weightless else draw.pick((9.81, 9.81, 9.80665)),
                integrator=integrator, law=draw_law(draw, integrator))
    plan.start = float(f"{plan.start:.5g}")
    plan.length = float(f"{plan.length:.4g}")
    plan.ice = theme == "ice" or (theme == "vessel" and draw.chance(0.7))
    plan.has_water = theme == "vessel" or (plan.ice and not weightless) or (theme == "bodies" and draw.chance(0.5))
    plan.adrift = theme == "adrift"
    if theme == "vessel":
        _plan_vessel(plan)
    if plan.has_water and not weightless:
        plan.buoyancy = theme == "vessel" or draw.chance(0.85)
        plan.drag = draw.chance(0.7)
        plan.level = draw.pick((0.0, 0.0, 0.0, float(f"{draw.number(-2, 2):.4g}")))
        plan.waves = draw.chance(0.6 if plan.database else 0.25)
        plan.uniform_current = plan.manoeuvring or plan.database or draw.chance(0.7)
    plan.step = float(f"{0.01 * (plan.length / 6) ** 0.5 * draw.size(0.2, 2):.2g}")
    plan.fracture = plan.ice and not plan.reference and draw.chance(0.5)
    plan.rolling = not plan.reference and plan.law in ("coulomb", "pyramid", "frictionless") and draw.chance(0.12)
    plan.tank = not plan.database and bool((plan.holder or plan.ice) and draw.chance(0.2))
    plan.origin = float(f"{0.3 * plan.length:.4g}") if plan.tank else 0.0
    return plan


def _plan_vessel(plan: Plan) -> None:
    draw = plan.draw
    plan.holder = draw.pick(("carriage", "carriage", "free", "free", "fixed"))
    if plan.holder == "free" and not plan.reference and draw.chance(0.2):
        plan.manoeuvring = True
    elif not plan.reference and draw.chance(0.22):
        plan.database, plan.length = True, 70.0
    else:
        plan.parts = plan.holder != "fixed" and draw.chance(0.25)
        plan.rods = plan.holder == "free" and not plan.reference and draw.chance(0.1)


def _region(plan: Plan) -> tuple[float, float, float, float]:
    """Where the ice lies: ahead of the vessel and beside its bow, else around the origin."""
    size = plan.length
    ahead = 0.3 if plan.database else 0.75
    if not plan.holder:
        return (plan.origin + 0.05 * size, -0.3 * size, plan.origin + 0.8 * size, 0.3 * size)
    return (plan.origin + ahead * size, -0.3 * size, plan.origin + (ahead + 0.8) * size, 0.3 * size)


def random_scene(seed: int) -> RandomScene:
    """The scene of a seed."""
    draw = Draw(seed)
    plan = _plan(draw)
    scene = ET.Element("scene", version="1")
    if draw.chance(0.5):
        scene.set("name", f"random {seed}")
    time = add(scene, "time", step=plan.step, end=plan.start + plan.duration)
    time.set("end", f"{plan.start + plan.duration:.10g}")
    if plan.start:
        time.set("start", f"{plan.start:.10g}")
    if plan.gravity != 9.81 or draw.chance(0.5):
        add(scene, "gravity", value=[0.0, 0.0, -plan.gravity])
    if draw.chance(0.6):
        add(scene, "seed", value=draw.whole(0, 10 ** 6), twin=draw.maybe(0.2, draw.whole(0, 9)))
    count = draw.whole(0, 2) if plan.holder or plan.ice else draw.whole(1, 7)
    if plan.holder:
        add_vessel(plan, scene)
    if plan.ice:
        add_ice(plan, scene, _region(plan))
    add_bodies(plan, scene, count, (-0.6 * plan.length if plan.holder or plan.ice else 0.0, 0.0), 0.1 * plan.length)
    if plan.has_water:
        add_hydro(plan, scene)
    if draw.chance(0.25) and (plan.holder or plan.ice):
        add_wind(plan, scene)
    if plan.tank:
        add_tank(plan, scene, 3 * plan.length)
    add_contact(plan, scene, few_contacts=count <= 2 and not plan.ice and not plan.holder)
    add_output(plan, scene)
    if draw.chance(0.1):
        add_view(plan, scene)
    scene[:] = sorted(scene, key=lambda element: ORDER.index(element.tag))
    return RandomScene(scene, plan.files)
