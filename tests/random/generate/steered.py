"""Thrusters, positioning and manoeuvres of a random vessel."""
import xml.etree.ElementTree as ET

from draw import add
from generate.plan import Plan


def _thruster(plan: Plan, thrusters: ET.Element, name: str, kind: str, at: list[float]) -> None:
    draw = plan.draw
    most = 9.81 * plan.length ** 3 * draw.size(0.05, 0.5)
    thruster = add(thrusters, "thruster", name=name, kind=kind, at=at, max_thrust=most, power=most * plan.speed * 5,
                   max_astern=draw.maybe(0.3, most * draw.number(0, 1)),
                   lag=draw.maybe(0.4, plan.duration * draw.number(0, 2)),
                   rate=draw.maybe(0.3, most / plan.duration * draw.size(0.1, 10)),
                   loss=draw.maybe(0.2, draw.number(0, 0.9)),
                   fails_at=draw.maybe(0.15, plan.start + plan.duration / 2),
                   thrust=draw.maybe(0.5, most * draw.number(0, 0.9)))
    kind_of_loss = draw.pick(("", "", "free_speed", "loss_table"))
    if kind_of_loss == "free_speed":
        thruster.set("free_speed", f"{plan.speed * draw.number(5, 10):.4g}")
    if kind_of_loss == "loss_table":
        thruster.set("loss_table", plan.table("loss.csv", ("speed_m_s", "thrust_share"),
                                              [(0, 1), (5 * plan.speed, 0.5), (10 * plan.speed, 0)]))
    if kind in ("azimuth", "propeller-rudder"):
        if draw.chance(0.4):
            thruster.set("angle_deg", f"{draw.number(-30, 30):.3g}")
        if draw.chance(0.4):
            thruster.set("turn_rate_deg", f"{draw.number(2, 60):.3g}")
    if kind == "azimuth" and draw.chance(0.3):
        thruster.set("forbidden_deg", draw.pick(("80 100", "80 100 -100 -80")))
    if kind == "propeller-rudder":
        for attribute, share in (("rudder_area", 0.02 * plan.length), ("rudder_span", 0.8), ("rudder_distance", 0.5),
                                 ("diameter", 0.7)):
            thruster.set(attribute, f"{share * plan.draught:.4g}")
        if draw.chance(0.4):
            thruster.set("rudder_limit_deg", f"{draw.number(10, 45):.3g}")
    plan.thrusters.append(name)


def add_thrusters(plan: Plan, vessel: ET.Element) -> None:
    """Adds three to five thrusters, and dynamic positioning at times."""
    draw = plan.draw
    thrusters = add(vessel, "thrusters")
    low = 0.4 * plan.draught
    _thruster(plan, thrusters, "bow", draw.pick(("tunnel", "azimuth")), [0.8 * plan.length, 0.0, low])
    _thruster(plan, thrusters, "port", draw.pick(("propeller", "azimuth", "propeller-rudder")),
              [0.0, 0.3 * plan.beam, low])
    _thruster(plan, thrusters, "starboard", draw.pick(("propeller", "azimuth", "propeller-rudder")),
              [0.0, -0.3 * plan.beam, low])
    if draw.chance(0.8):
        _add_control(plan, vessel)


def _add_control(plan: Plan, vessel: ET.Element) -> None:
    draw = plan.draw
    if draw.chance(0.1):
        add(vessel, "control", mode="none")
        return
    rate = (76.2 / plan.length) ** 0.5
    bands = [0.1 * rate, 0.1 * rate, 0.2 * rate]
    control = add(vessel, "control", mode="dp", bandwidth=draw.maybe(0.4, bands),
                  damping_ratio=draw.maybe(0.3, draw.number(0.3, 1.5)),
                  filter_bandwidth=draw.maybe(0.2, bands),
                  observer_bandwidth=draw.maybe(0.2, [5 * band for band in bands]),
                  wave_period=draw.maybe(0.2, draw.number(3, 12)), added_mass=draw.maybe(0.2, [10.0, 20.0]),
                  added_inertia=draw.maybe(0.2, 50.0),
                  damping=draw.maybe(0.2, [1.0, 2.0]), yaw_damping=draw.maybe(0.2, 3.0),
                  wind_feed_forward=draw.switch(),
                  sensor_period=draw.maybe(0.4, plan.step * draw.number(1, 5)),
                  sensor_delay=draw.maybe(0.3, plan.step * draw.number(0, 4)),
                  position_noise=draw.maybe(0.3, 1e-3 * plan.length), heading_noise_deg=draw.maybe(0.3, 0.1),
                  watch_circle=draw.maybe(0.4, 0.01 * plan.length), most_offset=draw.maybe(0.2, 3 * plan.length))
    if draw.chance(0.25):
        control.set("path", plan.table("track.csv", ("t_s", "x_m", "y_m", "heading_deg"),
                                       [(plan.start, plan.origin + 0.4 * plan.length, 0, 0),
                                        (plan.start + plan.duration, plan.origin + 0.42 * plan.length,
                                         0.01 * plan.length, 3)]))
        return
    if draw.chance(0.4):
        control.set("setpoint", f"{plan.origin + 0.43 * plan.length:.4g} {0.01 * plan.length:.4g}")
    if draw.chance(0.4):
        control.set("heading_deg", f"{draw.number(-5, 5):.3g}")


def add_manoeuvring(plan: Plan, vessel: ET.Element) -> None:
    """Adds the forces of hull, propeller and rudder, and a manoeuvre at times."""
    draw = plan.draw
    kind = draw.pick(("kvlcc2", "supply", "file"))
    element = add(vessel, "manoeuvring", midship=draw.maybe(0.3, 0.5 * plan.length),
                  max_rudder_deg=draw.maybe(0.3, draw.number(36, 45)),
                  rudder_rate_deg_s=draw.maybe(0.3, draw.number(1, 20)),
                  propeller_rate=draw.maybe(0.2, draw.number(0.01, 1)))
    if kind == "file":
        element.set("file", plan.copy("apps/scenes/icebreaker-91m.csv"))
        element.set("propulsion", "thrust-curve")
    else:
        element.set("preset", kind)
        element.set("length", f"{plan.length:.5g}")
    if kind == "supply" or draw.chance(0.3):
        element.set("model", "derivatives" if kind == "supply" else "mmg")
    if kind == "kvlcc2" and draw.chance(0.3):
        element.set("propeller", f"{draw.number(0.2, 1) * (320 / plan.length) ** 0.5:.3g}")
    if kind != "supply" and draw.chance(0.7):
        _add_manoeuvre(plan, vessel)


def _add_manoeuvre(plan: Plan, vessel: ET.Element) -> None:
    draw = plan.draw
    kind = draw.pick(("straight", "turning-circle", "zigzag", "course"))
    manoeuvre = add(vessel, "manoeuvre", kind=kind, start=draw.maybe(0.4, plan.start + plan.duration / 3))
    if kind in ("turning-circle", "zigzag"):
        manoeuvre.set("angle_deg", f"{draw.pick((-1, 1)) * draw.number(1, 35):.3g}")
    if kind == "zigzag" and draw.chance(0.5):
        manoeuvre.set("heading_deg", f"{draw.number(1, 20):.3g}")
    if kind != "course":
        return
    if draw.chance(0.3):
        manoeuvre.set("file", plan.table("orders.csv", ("t_s", "heading_deg", "speed_m_s"),
                                         [(plan.start, 0, plan.speed),
                                          (plan.start + plan.duration / 2, 10, 1.5 * plan.speed)]))
    else:
        manoeuvre.set("heading_deg", f"{draw.number(-20, 20):.3g}")
        manoeuvre.set("speed", f"{plan.speed * draw.number(0.5, 2):.4g}")
    for name, low, high in (("heading_gain", 0, 5), ("yaw_rate_gain", 0, 100), ("heading_time", 1, 500),
                            ("speed_gain", 0, 5), ("speed_time", 1, 300)):
        if draw.chance(0.3):
            manoeuvre.set(name, f"{draw.number(low, high):.3g}")
