"""The contact element of a random scene, with friction."""
import xml.etree.ElementTree as ET

from draw import Draw, add
from generate.plan import Plan

# The laws of each solver, as `nilas solvers` lists them.
ALL = ("coulomb", "ccp", "pyramid", "pyramid-k", "frictionless")
CONES = ("coulomb", "ccp", "frictionless")
LAWS = {"pgs": ("pyramid", "coulomb", "frictionless"), "nsgs": ALL,
        "eg": ("coulomb", "ccp", "pyramid-k", "frictionless"),
        "apgd": ("coulomb", "ccp", "pyramid-k", "frictionless"), "enumerate": CONES, "admm": CONES, "ipm": CONES,
        "eg-order-free": ("coulomb", "ccp", "pyramid-k", "frictionless"), "newton": ALL,
        "newton-order-free": ("coulomb", "ccp", "pyramid-k", "frictionless"), "auto": ALL}
WITH_MOMENTS = ("nsgs", "auto")


def draw_law(draw: Draw, integrator: str) -> str:
    """A law that the integrator takes; pyramids with three facets and more."""
    if integrator == "reference":
        return draw.pick(("coulomb", "frictionless"))
    law = draw.pick(("coulomb", "coulomb", "coulomb") + ALL)
    return f"pyramid-{draw.whole(3, 12)}" if law == "pyramid-k" else law


def _solver(plan: Plan, few_contacts: bool) -> str:
    name = "pyramid-k" if plan.law.startswith("pyramid-") else plan.law
    solvers = [solver for solver, laws in LAWS.items() if name in laws and (few_contacts or solver != "enumerate")]
    if plan.rolling:
        solvers = [solver for solver in solvers if solver in WITH_MOMENTS]
    # The default, and the one whose bits mirror, more often than the others.
    return plan.draw.pick(solvers + [name for name in ("auto", "auto", "newton-order-free") if name in solvers])


def _stabilisation(plan: Plan, contact: ET.Element) -> None:
    draw = plan.draw
    kind = draw.pick(("projection", "projection", "none", "baumgarte", "split-impulse", "tasora"))
    contact.set("stabilisation", kind)
    if kind in ("baumgarte", "split-impulse") and draw.chance(0.5):
        contact.set("erp", f"{draw.number(0.05, 1):.2f}")
    if kind != "none" and draw.chance(0.3):
        contact.set("slop", f"{draw.size(1e-6, 1e-4) * plan.length:.2g}")
    if kind in ("baumgarte", "split-impulse", "tasora") and draw.chance(0.4):
        contact.set("max_speed", f"{draw.size(0.01, 2):.2g}")


def _detection(plan: Plan, contact: ET.Element) -> None:
    draw = plan.draw
    kind = draw.pick(("continuous", "continuous", "continuous", "speculative", "discrete"))
    contact.set("detection", kind)
    contact.set("narrow_phase", draw.pick(("nilas", "nilas", "nilas", "fcl", "nilas-alone")))
    if plan.integrator == "semi-implicit-euler" and kind == "continuous" and draw.chance(0.3):
        contact.set("substeps", str(draw.whole(0, 6)))
    if draw.chance(0.15):
        contact.set("margin", f"{draw.size(1e-4, 1e-2) * plan.length:.2g}")


def _friction(plan: Plan, contact: ET.Element, between: str) -> None:
    draw = plan.draw
    kinetic = draw.pick((0.0, draw.number(0, 1), draw.number(0, 0.3), draw.number(0, 3)))
    static = draw.pick((None, kinetic, kinetic + draw.number(0, 0.5)))
    friction = add(contact, "friction", between=between, static=static,
                   kinetic=draw.maybe(0.7, kinetic) if static else kinetic)
    if plan.rolling:
        friction.set("rolling", f"{draw.size(1e-4, 1e-2) * plan.length:.2g}")
        if draw.chance(0.5):
            friction.set("spinning", f"{draw.size(1e-4, 1e-2) * plan.length:.2g}")
    if not plan.reference and draw.chance(0.2):
        friction.set("elastic", "true")
        if "ice" not in between or draw.chance(0.6):
            friction.set("stiffness", f"{draw.size(1e3, 1e8):.3g}")
        elif draw.chance(0.5):
            friction.set("edge_factor", f"{draw.number(0.1, 1.5):.2f}")
        if draw.chance(0.3):
            friction.set("tangential_ratio", f"{draw.number(0.2, 1.2):.2f}")
        if draw.chance(0.5):
            friction.set("damping_ratio", f"{draw.number(0, 1.5):.2f}")
    elif draw.chance(0.4):
        friction.set("restitution", f"{draw.pick((0.0, 1.0, draw.number(0, 1))):.2f}")
        if draw.chance(0.2):
            friction.set("elastic", "false")


def add_contact(plan: Plan, scene: ET.Element, few_contacts: bool) -> None:
    """Adds the contact element; few_contacts: the solver that tries all combinations may serve."""
    draw = plan.draw
    if not plan.reference and not plan.rolling and not plan.parts and not plan.rods and draw.chance(0.04):
        contact = add(scene, "contact", preset="metrikin-2014")
        plan.integrator, plan.law = "semi-implicit-euler", "pyramid"
    else:
        contact = add(scene, "contact", law=plan.law, integrator=plan.integrator, solver=_solver(plan, few_contacts),
                      tolerance=draw.maybe(0.7, draw.size(1e-10, 1e-4)),
                      max_iterations=draw.maybe(0.3, draw.whole(1, 5000)),
                      on_failure=draw.pick((None, None, "record", "retry", "stop")), warm_start=draw.switch(),
                      axes_deg=draw.maybe(0.1, draw.number(-90, 90)))
        if plan.integrator == "moreau" and draw.chance(0.2):
            contact.set("theta", f"{draw.pick((0.0, 0.5, 1.0, draw.number(0, 1))):.2f}")
        if not plan.reference and not plan.parts and not plan.rods:
            gyroscopic = draw.switch(0.2)
            if gyroscopic is not None:
                contact.set("gyroscopic", str(gyroscopic).lower())
        _stabilisation(plan, contact)
        _detection(plan, contact)
    names = ["ice", "hull", "wall", "structure", *plan.materials]
    pairs = {"* *"} if draw.chance(0.5) else set()
    pairs.update(" ".join(sorted((draw.pick(names), draw.pick(names)))) for _ in range(draw.whole(0, 3)))
    for pair in sorted(pairs):
        _friction(plan, contact, pair)
