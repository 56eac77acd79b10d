"""Water, its loads, wind and tank of a random scene."""
import xml.etree.ElementTree as ET

from draw import add
from generate.plan import Plan


# Of the databases of a hemisphere in tests/data/hydro: the depth of the water in the computation [m].
DATABASE_DEPTHS = {"wamit": 50.0, "capytaine": 50.0, "bemio": 200.0}


def _add_current(plan: Plan, water: ET.Element) -> None:
    draw = plan.draw
    current = add(water, "current", velocity=draw.maybe(0.8, [*draw.vector(plan.speed)[:2], 0.0]))
    if plan.uniform_current:
        return
    if draw.chance(0.6):
        current.set("profile", plan.table("profile.csv", ("z_m", "u_m_s", "v_m_s"),
                                          [(0, plan.speed, 0), (-plan.depth, plan.speed / 2, 0.1),
                                           (-3 * plan.length, 0, 0)]))
    if draw.chance(0.6):
        current.set("series", plan.table("series.csv", ("t_s", "u_m_s", "v_m_s"),
                                         [(plan.start, 0, 0),
                                          (plan.start + plan.duration / 2, plan.speed, -plan.speed / 3)]))


def _add_waves(plan: Plan, water: ET.Element, depth: float | None) -> None:
    """Adds waves; depth is that of the database, with which the length of waves must agree [m]."""
    draw = plan.draw
    kind = draw.pick(("regular", "regular", "jonswap", "pierson-moskowitz"))
    # Waves of one to four hull lengths, of a height far from breaking.
    length = plan.length * draw.number(1, 4)
    period = (2 * 3.1416 * length / 9.81) ** 0.5
    attenuation = draw.pick((None, None, "none", "exponential", "meylan"))
    waves = add(water, "waves", kind=kind, height=length * draw.size(1e-4, 0.02), period=period,
                heading_deg=draw.maybe(0.6, draw.number(-180, 180)),
                ramp=draw.maybe(0.3, draw.number(0, plan.duration)),
                depth=depth or draw.maybe(0.2, plan.length * draw.number(1, 10)), attenuation=attenuation)
    if kind == "regular":
        if draw.chance(0.5):
            waves.set("phase_deg", f"{draw.number(-180, 180):.4g}")
    else:
        waves.set("components", str(draw.whole(1, 12)))
        if kind == "jonswap" and draw.chance(0.5):
            waves.set("gamma", f"{draw.number(1, 7):.3g}")
        # Shorter waves than a hull resolves are refused.
        waves.set("shortest_period", f"{period * draw.number(0.7, 0.95):.5g}")
        if draw.chance(0.4):
            waves.set("spreading", f"{draw.size(1, 50):.3g}")
    if attenuation in ("exponential", "meylan"):
        waves.set("ice_edge", f"{draw.number(-1, 1) * plan.length:.4g} 0")
        if draw.chance(0.4):
            waves.set("ice_edge_deg", f"{draw.number(-60, 60):.4g}")
    if attenuation == "exponential" and draw.chance(0.6):
        waves.set("attenuation_rate", f"{draw.size(1e-5, 1e-2):.3g}")


def _add_wave_loads(plan: Plan, hydro: ET.Element, restoring: bool) -> None:
    draw = plan.draw
    vessels = ["none"] + ([] if restoring or not plan.buoyancy else ["froude-krylov"])
    vessels += ["database"] if plan.database else []
    vessel = draw.pick(vessels)
    loads = add(hydro, "wave_loads", vessel=vessel,
                floes="froude-krylov" if plan.buoyancy and draw.chance(0.7) else "none")
    if vessel == "froude-krylov" and draw.chance(0.4):
        loads.set("diffraction", draw.pick(("none", "database") if plan.database else ("none",)))
    # The databases at hand have no drift loads.
    if vessel == "database" and draw.chance(0.6):
        loads.set("drift", "none")


def _add_database(plan: Plan, hydro: ET.Element, kind: str, added: ET.Element | None) -> bool:
    """Names a database and takes something from it; returns whether this includes the hydrostatics."""
    draw = plan.draw
    turned = {"reference": draw.maybe(0.1, [0.0, 0.0, -2.0]), "rotation_deg": draw.maybe(0.2, draw.pick((0.0, 180.0)))}
    if kind == "wamit":
        for ending in ("1", "3", "hst"):
            plan.copy(f"tests/data/hydro/wec-sim/sphere.{ending}")
        add(hydro, "database", file="sphere.1", length=1.0, density=1000.0, gravity=9.81, depth=DATABASE_DEPTHS[kind],
            origin=draw.maybe(0.3, [0.0, 0.0, 0.0]), **turned)
    else:
        file = {"capytaine": "tests/data/hydro/wec-sim/sphere_capytaine.nc",
                "bemio": "tests/data/hydro/hydrochrono/sphere.h5"}[kind]
        add(hydro, "database", file=plan.copy(file), density=draw.maybe(0.2, 1000.0), **turned)
    restoring = plan.holder == "free" and not plan.parts and draw.chance(0.3)
    if restoring:
        add(hydro, "restoring")
    if added is not None and added.get("vessel") == "database" and plan.holder != "fixed" and draw.chance(0.7):
        model = draw.pick(("state-space", "convolution"))
        radiation = add(hydro, "radiation", model=model, highest_frequency=draw.maybe(0.1, 6.0))
        if model == "convolution" and draw.chance(0.5):
            radiation.set("memory", f"{draw.number(5, 30):.3g}")
        if model == "state-space":
            name, value = draw.pick((("error", f"{draw.number(0.005, 0.2):.3g}"), ("order", str(draw.whole(2, 8)))))
            radiation.set(name, value)
    return restoring


def _add_added_mass(plan: Plan, hydro: ET.Element) -> ET.Element:
    draw = plan.draw
    added = add(hydro, "added_mass", floes=draw.pick((None, "none", "auto", "disc", "plate")))
    kinds = ["none"]
    if plan.holder and not plan.manoeuvring:
        kinds += ["matrix"] + (["database", "database", "database"] if plan.endless else [])
    kind = draw.pick(kinds)
    added.set("vessel", kind)
    if kind == "matrix":
        mass = 100 * plan.length ** 3 * 0.01
        diagonal = [mass * draw.number(0, 1) for _ in range(3)]
        diagonal += [mass * plan.length ** 2 * draw.number(0, 0.1) for _ in range(3)]
        full = [diagonal[row] if row == column else 0.0 for row in range(6) for column in range(6)]
        added.set("matrix", " ".join(f"{entry:.5g}" for entry in (diagonal if draw.chance(0.6) else full)))
        if draw.chance(0.4):
            added.set("at", f"{0.4 * plan.length:.4g} 0 {0.3 * plan.depth:.4g}")
    return added


def add_hydro(plan: Plan, scene: ET.Element) -> None:
    """Adds water with current and waves, and the loads of the water."""
    draw = plan.draw
    water = add(scene, "water", density=draw.maybe(0.6, draw.number(995, 1030)),
                level=plan.level or draw.maybe(0.2, 0.0))
    kind = draw.pick(tuple(DATABASE_DEPTHS))
    if draw.chance(0.6):
        _add_current(plan, water)
    if plan.waves:
        for _ in range(draw.whole(1, 2)):
            _add_waves(plan, water, DATABASE_DEPTHS[kind] if plan.database else None)
    if not (plan.buoyancy or plan.drag):
        return
    hydro = add(scene, "hydro")
    if plan.buoyancy:
        add(hydro, "buoyancy")
    if plan.drag:
        add(hydro, "drag", form=draw.maybe(0.5, draw.number(0, 2)), skin=draw.maybe(0.5, draw.size(1e-4, 0.1)))
    added = None
    plan.endless = plan.database and kind != "capytaine"
    if not plan.reference and plan.uniform_current and draw.chance(0.9 if plan.database else 0.35):
        added = _add_added_mass(plan, hydro)
    restoring = _add_database(plan, hydro, kind, added) if plan.database else False
    if plan.waves and not plan.reference and draw.chance(0.7):
        _add_wave_loads(plan, hydro, restoring)
    if draw.chance(0.15):
        add(hydro, "virtual_drag", coefficient=draw.maybe(0.8, draw.size(1e-2, 1e3)),
            velocity=draw.maybe(0.7, [*draw.vector(plan.speed)[:2], 0.0]))
    if plan.holder and not plan.reference and draw.chance(0.15):
        _add_wash(plan, hydro)


def _add_wash(plan: Plan, hydro: ET.Element) -> None:
    draw = plan.draw
    wash = add(hydro, "propeller_wash")
    for _ in range(draw.whole(1, 2)):
        jet = add(wash, "jet", diameter=0.3 * plan.draught, position=[0.0, 0.0, 0.4 * plan.draught])
        if plan.thrusters and draw.chance(0.7):
            jet.set("thruster", draw.pick(plan.thrusters))
        else:
            jet.set("thrust", f"{draw.number(-20, 50) * plan.length ** 2:.4g}")
            if draw.chance(0.4):
                jet.set("direction", f"-1 {draw.number(-0.5, 0.5):.3g} 0")


def add_wind(plan: Plan, scene: ET.Element) -> None:
    """Adds wind over floes and vessel."""
    draw = plan.draw
    profile = draw.pick((None, "uniform", "power", "log"))
    add(scene, "wind", speed=draw.number(0, 30), direction_deg=draw.maybe(0.7, draw.number(-180, 180)),
        density=draw.maybe(0.3, draw.number(1.1, 1.5)), profile=profile,
        exponent=draw.maybe(0.5, draw.number(0, 0.3)) if profile == "power" else None,
        gusts=draw.pick((None, "none", "npd")), floe_drag=draw.maybe(0.5, draw.number(0, 0.01)))


def add_tank(plan: Plan, scene: ET.Element, length: float) -> None:
    """Adds walls around a basin of this length along X [m]."""
    draw = plan.draw
    add(scene, "tank", length=length, width=length, depth=plan.length * draw.number(0.4, 2),
        wall_thickness=draw.maybe(0.4, plan.length * draw.number(0.02, 0.1)), floor=draw.switch())
