"""What must hold of every scene. A judge gives None where it does not apply, "" where all is well, else a sentence."""
import math
import re
from typing import Callable

from accounts import bodies_momentum, energy, momentum, newton
from case import Case
from program import TABLES, Run
from refusals import documented
from same import mirror, same_rows, turn

REFUSED, FAILED = 2, 3  # exit codes of a scene that is refused, and of numerics that fail
THINNEST_SHARE = 0.5  # bodies that are not followed on their path may overlap by this share of the thinner one


def ends(case: Case) -> str | None:
    """The run ends by itself, at its end time or with a documented error."""
    run = case.base
    if run.code is None:
        return "the run does not end within a minute of processor time"
    if run.code == 0:
        return "" if run.summary.get("status") == "done" else f"exit code 0 with status {run.summary.get('status')}"
    error = run.error()
    if run.code not in (REFUSED, FAILED) or "report" in error or not error:
        return f"exit code {run.code}: {error[:300]}"
    return "" if documented(error) else f"undocumented error, exit code {run.code}: {error[:300]}"


def checked(case: Case) -> str | None:
    """`nilas check` takes what `nilas run` takes, and refuses what it refuses at the start."""
    refused = case.base.code == REFUSED
    if case.base.code is None:
        return None
    if (case.check.code == 0) == (not refused):
        return ""
    error = (case.check.error() or case.base.error())[:200]
    return f"check ends with {case.check.code}, run with {case.base.code}: {error}"


def finite(case: Case) -> str | None:
    """No number of any table or of the summary is NaN or infinite."""
    for name in TABLES:
        table = case.base.table(name)
        for row in table.rows if table else []:
            for column, value in zip(table.names if table else [], row):
                if value.lower().strip("+-") in ("nan", "inf", "infinity"):
                    return f"{name}.csv: {column} is {value}"
    path = case.base.folder / "summary.json"
    if not path.exists():
        return None
    found = re.search(r"[:\[,]\s*-?(NaN|Infinity|inf|nan)\b", path.read_text(encoding="utf-8"))
    return f"summary.json holds {found.group(1)}" if found else ""


def honest(case: Case) -> str | None:
    """The summary counts the steps that fell short, and names the worst values of the table."""
    steps, contact = case.base.table("steps"), case.resolved.find("contact") if case.done else None
    if steps is None or contact is None:
        return None
    summary = case.base.summary
    if summary["steps"] != len(steps.rows):
        return f"the summary counts {summary['steps']} steps, steps.csv has {len(steps.rows)}"
    tolerance = float(contact.get("tolerance", "0"))
    residuals, statuses = steps.numbers("law_map_m_s"), steps.text("status")
    for residual, status, time in zip(residuals, statuses, steps.text("time_s")):
        if status == "converged" and residual > tolerance:
            return f"at {time} s the status is converged with a residual of {residual} above {tolerance} m/s"
    short = sum(1 for residual in residuals if residual > tolerance) if tolerance > 0 else 0
    counted = summary["shortfalls"]["unconverged_steps"]
    if counted != short:
        return f"the summary counts {counted} steps above the tolerance, steps.csv has {short}"
    for name, worst in summary["worst"].items():
        if name not in steps.names:
            continue
        largest = max(abs(value) for value in steps.numbers(name))
        if not math.isclose(largest, abs(worst["value"]), rel_tol=1e-12, abs_tol=0):
            return f"worst {name} is {worst['value']} in the summary and {largest} in steps.csv"
    return ""


def _thinnest(case: Case) -> float | None:
    """The least thickness of what can move or be met [m]; None where it varies."""
    sizes: list[float] = []
    scene = case.resolved
    if any(scene.find(path) is not None for path in ("ice/vary", "ice/field[@file]", ".//part")):
        return None
    ice = scene.find("ice")
    for element in [*scene.iter("floe"), *scene.iter("field"), *scene.iter("tank")]:
        of_ice = ice.get("thickness", "") if ice is not None else ""
        sizes.append(float(element.get("thickness") or element.get("wall_thickness") or of_ice))
    for body in scene.iter("body"):
        if body.get("shape") == "mesh":
            return None
        if body.get("shape") != "plane":
            words = {"box": body.get("size", ""), "sphere": body.get("radius", ""),
                     "cylinder": f"{body.get('radius')} {body.get('height')}"}
            sizes.append(min(float(word) for word in words[body.get("shape", "box")].split()))
    return min(sizes) if sizes else None


def penetration(case: Case) -> str | None:
    """Bodies overlap by less than half the thinner one's thickness more than at the start."""
    steps = case.base.table("steps")
    contact = case.resolved.find("contact") if case.done else None
    if steps is None or contact is None:
        return None
    if contact.get("detection") != "continuous" or contact.get("stabilisation") != "projection":
        return None
    elastic = case.scene.xml.find(".//friction[@elastic='true']") is not None
    short = sum(case.base.summary["shortfalls"][key] for key in ("unconverged_steps", "uncorrected_steps"))
    thinnest = _thinnest(case)
    if elastic or short or thinnest is None or case.attribute("contact", "integrator") == "reference":
        return None
    depths = steps.numbers("penetration_max_m")
    limit = depths[0] + THINNEST_SHARE * thinnest
    return "" if max(depths) <= limit else f"bodies overlap by {max(depths):.3g} m, the limit is {limit:.3g} m"


def _same(case: Case, other: Run, what: str) -> str:
    if other.code != 0:
        return f"{what} ends with exit code {other.code}: {other.error()[:200]}"
    return same_rows(case.base, other, what)


def again(case: Case) -> str | None:
    """The scene.xml of the run folder gives the same bits."""
    return _same(case, case.again, "the run of scene.xml") if case.done else None


def threads(case: Case) -> str | None:
    """Two threads give the same bits as one."""
    return _same(case, case.threads, "the run on 2 threads") if case.done else None


def resumed(case: Case) -> str | None:
    """A run that was stopped and resumed gives the same bits."""
    steps = case.base.table("steps")
    # The integrator `reference` has no checkpoints.
    if not case.done or steps is None or len(steps.rows) < 4 or case.attribute("contact", "integrator") == "reference":
        return None
    return _same(case, case.resumed, "the resumed run")


Judge = Callable[[Case], str | None]
# In the order of the table; the first ones need no run but the first.
JUDGES: dict[str, Judge] = {
    "ends": ends, "check": checked, "finite": finite, "honest": honest, "energy": energy, "momentum": momentum,
    "bodies": bodies_momentum, "newton": newton, "penetration": penetration, "again": again, "threads": threads,
    "resumed": resumed, "mirror": mirror, "turn": turn}
