"""The vessel of a random scene and what holds it."""
import xml.etree.ElementTree as ET

from draw import add
from generate.attached import add_parts, add_rods
from generate.moored import add_mooring
from generate.plan import Plan
from generate.steered import add_manoeuvring, add_thrusters

SHIP_TYPES = ("car-carrier", "cargo-loaded", "cargo-container-on-deck", "container-loaded", "destroyer",
              "diving-support",
              "drilling", "ferry", "fishing", "lng-tanker", "offshore-supply", "passenger-liner", "research",
              "speed-boat",
              "tanker-loaded", "tanker-in-ballast", "tender")


def _add_hull(plan: Plan, vessel: ET.Element) -> None:
    draw = plan.draw
    form = draw.pick(("icebreaker", "icebreaker", "wedge"))
    hull = add(vessel, "hull", generate=form, length=plan.length, triangles=draw.whole(300, 900),
               beam=draw.maybe(0.3, plan.beam),
               draught=plan.draught, depth=plan.depth, bow_length=draw.maybe(0.2, 0.3 * plan.length))
    if form == "icebreaker":
        for name, low, high in (("stem_angle_deg", 18, 40), ("entrance_angle_deg", 20, 40), ("flare_angle_deg", 2, 15)):
            if draw.chance(0.3):
                hull.set(name, f"{draw.number(low, high):.3g}")
        if draw.chance(0.2):
            hull.set("stern_length", f"{draw.number(0.05, 0.2) * plan.length:.4g}")


def _add_mass(plan: Plan, vessel: ET.Element) -> None:
    """The mass of a floating hull: by value, by draught or from the displaced water."""
    draw = plan.draw
    by_value = plan.parts or not plan.has_water or draw.chance(0.5)
    block = 0.55 * plan.length * plan.beam * plan.draught * 1000
    mass = add(vessel, "mass")
    if by_value:
        mass.set("value", f"{block * draw.number(0.7, 1.1):.5g}")
    else:
        mass.set("draught", f"{plan.draught * draw.number(0.8, 1.1):.4g}")
    if draw.chance(0.5):
        mass.set("cog", f"{0.43 * plan.length:.4g} 0 {0.5 * plan.draught:.4g}")
    if by_value and draw.chance(0.3):
        across, along = block * plan.beam ** 2 / 9, block * plan.length ** 2 / 16
        mass.set("inertia", f"{across:.5g} {along:.5g} {along * 1.02:.5g} 0 0 0")


def _add_carriage(plan: Plan, vessel: ET.Element) -> None:
    draw = plan.draw
    free = draw.some(("surge", "sway", "heave", "roll", "pitch", "yaw")) if draw.chance(0.6) else []
    kind = draw.pick(("rigid", "six-cells", "six-cells", "prismatic"))
    loose = not plan.buoyancy or plan.rods
    carriage = add(vessel, "carriage", speed=draw.maybe(0.8, plan.speed * draw.number(-0.5, 2)),
                   heading_deg=draw.maybe(0.3, draw.number(-30, 30)),
                   ramp=draw.maybe(0.5, draw.number(0, plan.duration)),
                   ramp_shape=draw.pick((None, "linear", "smooth")),
                   free=" ".join(free) if free and kind != "prismatic" else None,
                   joint=draw.maybe(0.4, [0.45 * plan.length, 0.0, plan.draught]),
                   start="as-placed" if loose or draw.chance(0.3) else draw.maybe(0.3, "equilibrium"))
    if draw.chance(0.2):
        end = plan.duration * 1.5
        add(carriage, "path", file=plan.table("course.csv", ("t_s", "x_m", "y_m", "yaw_deg"),
                                              [(0, 0, 0, 0), (end / 2, plan.speed * end / 2, 0, 2),
                                               (end, plan.speed * end, 0.01 * plan.length, 5)]))
    if draw.chance(0.9):
        balance = add(carriage, "force_balance", kind=kind)
        if kind == "six-cells" and draw.chance(0.5):
            balance.set("stiffness", f"{1e7 * (plan.length / 6) ** 2 * draw.size(0.01, 100):.4g}")
            balance.set("damping", f"{1e4 * (plan.length / 6) ** 2.5 * draw.size(0.01, 10):.4g}")
        if kind == "six-cells" and draw.chance(0.3):
            a = 0.2 * plan.length
            cells = [(0, 0, 0, 1, 0, 0), (a, 0, 0, 0, 1, 0), (-a, 0, 0, 0, 1, 0), (a, 0, 0, 0, 0, 1),
                     (-a, a / 2, 0, 0, 0, 1), (-a, -a / 2, 0, 0, 0, 1)]
            balance.set("layout", plan.table("cells.csv", ("x_m", "y_m", "z_m", "ax", "ay", "az"), cells))


def _add_wind_area(plan: Plan, vessel: ET.Element) -> None:
    draw = plan.draw
    area = add(vessel, "wind_area", frontal=plan.beam * plan.depth, lateral=plan.length * plan.depth,
               length=draw.maybe(0.3, plan.length),
               midship=draw.maybe(0.3, plan.length / 2),
               lateral_centroid=draw.maybe(0.3, draw.number(-0.1, 0.1) * plan.length),
               height=draw.maybe(0.3, plan.depth))
    if draw.chance(0.7):
        area.set("ship_type", draw.pick(SHIP_TYPES))
        if draw.chance(0.3):
            area.set("model", "blendermann")
    else:
        area.set("model", "coefficients")
        area.set("file", plan.table("wind.csv", ("angle_deg", "cx", "cy", "cn"),
                                    [(0, -0.6, 0, 0), (90, 0, 0.9, 0.05), (180, 0.6, 0, 0)]))


def add_vessel(plan: Plan, scene: ET.Element) -> None:
    """Adds the vessel that the plan asks for, with its keel near the depth at which it floats."""
    draw = plan.draw
    vessel = add(scene, "vessel", name=draw.maybe(0.3, "tested ship"),
                 heading_deg=draw.maybe(0.3, draw.number(-20, 20)))
    afloat = plan.buoyancy and not plan.parts
    height = plan.level - plan.draught
    if plan.database:
        vessel.set("hull", plan.copy("apps/scenes/hulls/cone.stl"))
        add(vessel, "mass", value=2.8e7, cog=[0.0, 0.0, 10.0], inertia=[1.2e10, 1.2e10, 1.6e10, 0.0, 0.0, 0.0])
        vessel.set("position", f"{plan.origin:.5g} 0")
    else:
        if abs(plan.length - 6) < 1e-9 and draw.chance(0.7):
            plan.files.update(icebreaker_folder())
            vessel.set("hull", "icebreaker")
        else:
            _add_hull(plan, vessel)
        _add_mass(plan, vessel)
        vessel.set("position",
                   f"{plan.origin:.5g} 0" if afloat and draw.chance(0.7) else f"{plan.origin:.5g} 0 {height:.5g}")
    if plan.holder == "carriage":
        _add_carriage(plan, vessel)
    elif plan.holder == "fixed":
        add(vessel, "fixed")
    else:
        # A rod keeps its length from the start on.
        if not plan.rods and draw.chance(0.7):
            vessel.set("velocity", " ".join(f"{v:.4g}" for v in (plan.speed * draw.number(0, 2),
                                                                 0.1 * plan.speed * draw.number(-1, 1), 0.0)))
        if not plan.rods and draw.chance(0.2):
            vessel.set("angular_velocity", f"0 0 {draw.number(-0.1, 0.1):.3g}")
        if plan.manoeuvring:
            add_manoeuvring(plan, vessel)
        elif not plan.reference and draw.chance(0.5):
            add_thrusters(plan, vessel)
        if not plan.reference and draw.chance(0.35) and not plan.database:
            add_mooring(plan, vessel)
    if plan.parts:
        add_parts(plan, vessel)
    if plan.rods:
        add_rods(plan, vessel)
    if draw.chance(0.3):
        _add_wind_area(plan, vessel)


def icebreaker_folder() -> dict[str, bytes]:
    """The files of the shipped hull folder of 6 m."""
    from generate.plan import SOURCE
    folder = SOURCE / "apps/scenes/hulls/icebreaker"
    return {f"icebreaker/{path.name}": path.read_bytes() for path in sorted(folder.iterdir())}
