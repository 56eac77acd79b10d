"""Judges that compare runs: the same bits, or the image of a motion."""
from case import Case
from program import TABLES, Run, Table

# Images differ by rounding before bodies touch: as a share of the largest value of the column.
IMAGE_ROUNDING = 1e-9
ORDER_FREE = ("newton-order-free", "eg-order-free")
Row = dict[str, float]


def same_rows(one: Run, other: Run, what: str) -> str:
    """Whether all tables of two runs have the same text, wall times left out."""
    for name in TABLES:
        a, b = one.table(name), other.table(name)
        if (a is None) != (b is None):
            return f"{what}: only one of the runs has {name}.csv"
        if a is None or b is None:
            continue
        if len(a.rows) != len(b.rows):
            return f"{what}: {name}.csv has {len(b.rows)} rows instead of {len(a.rows)}"
        if a.without_times() == b.without_times():
            continue
        names = a.without_times()[0]
        for x, y in zip(a.without_times(), b.without_times()):
            if x != y:
                column = next((k for k, (u, v) in enumerate(zip(x, y)) if u != v), 0)
                return f"{what}: {name}.csv, {names[column]} at {x[0]} s is {y[column]} instead of {x[column]}"
    return ""


def _first_contact(steps: Table) -> float:
    """The time of the first step with a contact [s]; infinite without one."""
    return next((float(t) for t, n in zip(steps.text("time_s"), steps.text("contacts")) if n != "0"), float("inf"))


def _motions(bodies: Table) -> dict[tuple[str, float], Row]:
    columns = [name for name in bodies.names if name not in ("time_s", "name", "id")]
    values = {name: bodies.numbers(name) for name in columns}
    return {(key, time): {name: values[name][row] for name in columns}
            for row, (key, time) in enumerate(zip(bodies.text("id"), bodies.numbers("time_s")))}


def _mirrored(row: Row) -> Row:
    image = dict(row)
    for name in ("y_m", "qx", "qz", "vy_m_s", "wx_rad_s", "wz_rad_s"):
        image[name] = -row[name]
    return image


def _turned(row: Row) -> Row:
    """Position and velocities turned by 90 degrees; attitudes are judged by their velocities."""
    image = {name: value for name, value in row.items() if not name.startswith("q")}
    for first, second in (("x_m", "y_m"), ("vx_m_s", "vy_m_s"), ("wx_rad_s", "wy_rad_s")):
        image[first], image[second] = -row[second], row[first]
    return image


def _compare(case: Case, kind: str, to_the_bit: bool) -> str | None:
    bodies, steps = case.base.table("bodies"), case.base.table("steps")
    if not case.done or bodies is None or steps is None:
        return None
    run = case.image(kind)
    if run is None:
        return None
    other = run.table("bodies")
    if run.code != 0 or other is None:
        return f"the {kind} scene ends with exit code {run.code}: {run.error()[:200]}"
    until = float("inf") if to_the_bit else _first_contact(steps)
    change = _mirrored if kind == "mirrored" else _turned
    motions, images = _motions(bodies), _motions(other)
    if set(motions) != set(images):
        return f"the {kind} scene has other bodies or times"
    scale: Row = {}
    for row in motions.values():
        for name, value in row.items():
            unit = name.split("_", 1)[1] if "_" in name else "q"
            scale[unit] = max(scale.get(unit, 0.0), abs(value))
    judged = False
    for (body, time), row in motions.items():
        if time >= until:
            continue
        judged = True
        for name, value in change(row).items():
            limit = 0.0 if to_the_bit else IMAGE_ROUNDING * scale[name.split("_", 1)[1] if "_" in name else "q"]
            off = abs(images[(body, time)][name] - value)
            if off > limit:
                return (f"the {kind} scene differs in {name} of body {body} at {time} s by {off:.3g}, the limit is "
                        f"{limit:.3g}")
    return "" if judged else None


def _has_mirror_image(case: Case) -> bool:
    """Whether the pages promise the same bits in the mirror.

    Not so with a pyramid of a stated number of sides, nor for cylinders, whose contacts are found by iteration.
    """
    of_sides = case.attribute("contact", "law").startswith("pyramid-")
    return not of_sides and case.scene.xml.find(".//body[@shape='cylinder']") is None


def mirror(case: Case) -> str | None:
    """The mirrored scene moves as the mirror image: to the bit with order-free solvers, else until bodies touch."""
    exact = case.attribute("contact", "solver") in ORDER_FREE and _has_mirror_image(case)
    return _compare(case, "mirrored", exact)


def turn(case: Case) -> str | None:
    """The scene turned by 90 degrees moves as the turned motion until bodies touch."""
    return _compare(case, "turned", False)
