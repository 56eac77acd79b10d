"""The mirror image of a scene in the plane y = 0, and the scene turned by 90 degrees about Z."""
import copy
import xml.etree.ElementTree as ET
from typing import Callable

from generate.scene import RandomScene

# Elements with an image here. Random fields have none: their floes are drawn anew. The walls of a tank change places.
# Files are not changed.
WITH_IMAGE = {"scene", "time", "gravity", "seed", "contact", "friction", "water", "current", "waves", "hydro",
              "buoyancy",
              "drag", "added_mass", "virtual_drag", "wave_loads", "wind", "vessel", "hull", "mass", "fixed",
              "carriage", "force_balance", "rod", "mooring", "line", "spring_line", "turret", "thrusters", "thruster",
              "ice", "floe",
              "fracture", "crushing", "bending", "splitting", "cracks", "damage", "weak_line", "body", "output", "view"}
WITH_FILES = {"profile", "series", "file", "mesh", "layout", "library", "loss_table", "table"}
Numbers = list[float]


def _mirror(p: Numbers) -> Numbers:
    return [p[0], -p[1], *p[2:]]


def _mirror_spin(w: Numbers) -> Numbers:
    return [-w[0], w[1], -w[2]]


def _turn(p: Numbers) -> Numbers:
    return [-p[1], p[0], *p[2:]]


def _pairs(image: Callable[[Numbers], Numbers], reverse: bool) -> Callable[[Numbers], Numbers]:
    """The image of a list of points in the plane; a mirror turns their sense, which must stay counter-clockwise."""
    def of(flat: Numbers) -> Numbers:
        points = [image(flat[k:k + 2]) for k in range(0, len(flat), 2)]
        return [x for point in (points[::-1] if reverse else points) for x in point]
    return of


def _negated(a: Numbers) -> Numbers:
    return [-x for x in a]


def _rotations_mirrored(a: Numbers) -> Numbers:
    return [-a[0], a[1], -a[2]]


def _tensor_mirrored(i: Numbers) -> Numbers:
    return [i[0], i[1], i[2], -i[3], i[4], -i[5]]


def _plus_90(a: Numbers) -> Numbers:
    return [a[0] + 90, *a[1:]]


GROUND_VECTORS = [("current", "velocity"), ("virtual_drag", "velocity"), ("vessel", "position"), ("vessel", "velocity"),
                  ("floe", "velocity"), ("body", "position"), ("body", "velocity"), ("rod", "to"), ("line", "anchor"),
                  ("spring_line", "anchor"), ("waves", "ice_edge")]
VESSEL_VECTORS = [("mass", "cog"), ("carriage", "joint"), ("rod", "at"), ("line", "fairlead"),
                  ("spring_line", "fairlead"),
                  ("turret", "at"), ("thruster", "at"), ("added_mass", "at")]
SPINS = [("vessel", "angular_velocity"), ("body", "angular_velocity")]
HEADINGS = [("vessel", "heading_deg"), ("carriage", "heading_deg"), ("waves", "heading_deg"), ("waves", "ice_edge_deg"),
            ("wind", "direction_deg")]

MIRROR: dict[tuple[str, str], Callable[[Numbers], Numbers]] = {
    **{key: _mirror for key in GROUND_VECTORS + VESSEL_VECTORS}, **{key: _mirror_spin for key in SPINS},
    **{key: _negated for key in HEADINGS}, ("body", "rotation_deg"): _rotations_mirrored,
    ("mass", "inertia"): _tensor_mirrored,
    ("body", "inertia"): _tensor_mirrored, ("floe", "outline"): _pairs(_mirror, True),
    ("weak_line", "points"): _pairs(_mirror, False),
    ("thruster", "angle_deg"): _negated}

TURN: dict[tuple[str, str], Callable[[Numbers], Numbers]] = {
    **{key: _turn for key in GROUND_VECTORS + SPINS}, **{key: _plus_90 for key in HEADINGS},
    ("body", "rotation_deg"): _plus_90,
    ("floe", "outline"): _pairs(_turn, False), ("weak_line", "points"): _pairs(_turn, False)}
# Attributes that a turn changes although the scene leaves them out.
TURNED_DEFAULTS = {("vessel", "heading_deg"): "0", ("carriage", "heading_deg"): "0", ("waves", "heading_deg"): "0",
                   ("wind", "direction_deg"): "0",
                   ("body", "rotation_deg"): "0 0 0"}


def _image(scene: RandomScene, changes: dict[tuple[str, str], Callable[[Numbers], Numbers]],
           defaults: dict[tuple[str, str], str]) -> RandomScene:
    xml = copy.deepcopy(scene.xml)
    for element in xml.iter():
        for (tag, name), value in defaults.items():
            if element.tag == tag and name not in element.attrib:
                element.set(name, value)
        for name in list(element.attrib):
            change = changes.get((element.tag, name))
            if change is not None:
                numbers = change([float(word) for word in element.attrib[name].split()])
                element.set(name, " ".join(repr(x + 0.0) for x in numbers))
    return RandomScene(xml, scene.files)


def _has_image(xml: ET.Element) -> bool:
    if any(element.tag not in WITH_IMAGE or WITH_FILES & set(element.attrib) for element in xml.iter()):
        return False
    # Each of these draws its own random numbers, or has a side.
    return not (xml.find("seed[@twin]") is not None or xml.find(".//thruster[@kind='azimuth']") is not None
                or xml.find(".//thruster[@forbidden_deg]") is not None
                or xml.find(".//added_mass[@vessel='matrix']") is not None
                or any(waves.get("spreading") for waves in xml.iter("waves")))


def mirrored(scene: RandomScene) -> RandomScene | None:
    """The image in y = 0; None where the scene has parts whose image is not known here."""
    xml = scene.xml
    if not _has_image(xml) or xml.find("contact[@axes_deg]") is not None or xml.find(".//thruster") is not None:
        return None
    return _image(scene, MIRROR, {})


def turned(scene: RandomScene) -> RandomScene | None:
    """The scene turned by 90 degrees about Z; None where it has parts whose image is not known here."""
    if not _has_image(scene.xml):
        return None
    return _image(scene, TURN, TURNED_DEFAULTS)
