"""Judges of the accounts of energy and momentum."""
import math

from case import Case
from program import Table

# Rounding of sums over steps and bodies, as a share of the largest term. The shipped scenes close to 1e-13.
ROUNDING = 1e-9
# vessel.csv has twelve digits after the point.
DIGIT = 1e-12
AXES = "xyz"
KEEPS_OVERLAPS = "integrator reference removes no overlap"  # a warning that its ledger does not close


def energy(case: Case) -> str | None:
    """The energy ledger closes to rounding."""
    steps = case.base.table("steps")
    if not case.done or steps is None or KEEPS_OVERLAPS in str(case.base.summary.get("warnings")):
        return None
    no_terms = ("imbalance_J", "complementarity_J", "bipotential_J")
    terms = [name for name in steps.names if name.endswith("_J") and name not in no_terms]
    scale = max(abs(value) for name in terms for value in steps.numbers(name))
    for time, value in zip(steps.text("time_s"), steps.numbers("imbalance_J")):
        if abs(value) > ROUNDING * scale:
            return f"at {time} s the energy ledger is off by {value:.3g} J, its largest term is {scale:.3g} J"
    return ""


def momentum(case: Case) -> str | None:
    """The momentum balance closes to rounding in each step."""
    steps = case.base.table("steps")
    if not case.done or steps is None:
        return None
    for kind in ("momentum", "angular_momentum"):
        unit = "Ns" if kind == "momentum" else "Nms"
        for time, off, scale in zip(steps.text("time_s"), steps.numbers(f"{kind}_imbalance_{unit}"),
                                    steps.numbers(f"{kind}_scale_{unit}")):
            if off > ROUNDING * scale:
                return f"at {time} s the {kind.replace('_', ' ')} is off by {off:.3g} of {scale:.3g} {unit}"
    return ""


def _masses(case: Case) -> dict[str, float] | None:
    """Masses of the bodies of a scene that nothing holds and nothing pulls; None for all other scenes."""
    scene = case.resolved
    gravity = scene.find("gravity")
    if any(case.has(tag) for tag in ("vessel", "ice", "hydro", "tank",
                                     "wind")) or gravity is None or gravity.get("value") not in ("0 0 0", "0 0 -0"):
        return None
    masses: dict[str, float] = {}
    for body in scene.iter("body"):
        size, radius = body.get("size", ""), float(body.get("radius", "nan"))
        volume = {"box": math.prod(float(x) for x in size.split()), "sphere": 4 / 3 * math.pi * radius ** 3,
                  "cylinder": math.pi * radius ** 2 * float(body.get("height",
                                                                     "nan"))}.get(body.get("shape", "box"), math.nan)
        if body.get("fixed") == "true" or body.get("shape") in ("mesh", "plane"):
            return None
        masses[body.get("name", "")] = float(body.get("mass") or float(body.get("density") or 1000) * volume)
    return masses


def bodies_momentum(case: Case) -> str | None:
    """Where nothing acts from outside, the momenta of bodies.csv keep their sum."""
    bodies = case.base.table("bodies")
    masses = _masses(case) if case.done else None
    if bodies is None or not masses:
        return None
    sums: dict[str, list[float]] = {}
    scale = 0.0
    names, times = bodies.text("name"), bodies.text("time_s")
    velocities = [bodies.numbers(f"v{axis}_m_s") for axis in AXES]
    for row, name in enumerate(names):
        terms = [masses[name] * velocities[k][row] for k in range(3)]
        sums[times[row]] = [a + b for a, b in zip(sums.get(times[row], [0.0] * 3), terms)]
        scale = max([scale, *map(abs, terms)])
    first = next(iter(sums.values()))
    for time, total in sums.items():
        off = max(abs(a - b) for a, b in zip(total, first))
        if off > ROUNDING * scale:
            return (f"at {time} s the momenta of the bodies sum to {off:.3g} N s more than at the start, of "
                    f"{scale:.3g} N s")
    return ""


def _forces(vessel: Table) -> list[str]:
    """The stems of the force columns; hull_* repeats carriage_*."""
    return [name[:-len("_fx_N")] for name in vessel.names if name.endswith("_fx_N") and not name.startswith("hull_")]


def newton(case: Case) -> str | None:
    """The change of the vessel's momentum is the sum of the loads of vessel.csv and its weight."""
    vessel = case.base.table("vessel")
    if not case.done or vessel is None or len(vessel.rows) < 2:
        return None
    if any(case.has(tag) for tag in ("fixed", "part", "rod")):
        return None
    if case.attribute("contact", "integrator") == "reference":
        return None
    mass, h = case.base.summary["vessel"]["mass_kg"], case.step
    gravity = case.resolved.find("gravity")
    weight = [mass * float(g) for g in (gravity.get("value", "") if gravity is not None else "0 0 0").split()]
    times = vessel.text("time_s")
    for k, axis in enumerate(AXES):
        v = vessel.numbers(f"v{axis}_m_s")
        loads = [vessel.numbers(f"{stem}_f{axis}_N") for stem in _forces(vessel)]
        for row in range(1, len(v)):
            terms = [load[row] for load in loads] + [weight[k]]
            off = mass * (v[row] - v[row - 1]) / h - sum(terms)
            limit = ROUNDING * sum(map(abs, terms)) + 4 * DIGIT * mass / h + DIGIT
            if abs(off) > limit:
                return f"at {times[row]} s Newton's law along {axis} is off by {off:.3g} N, the limit is {limit:.3g} N"
    return ""
