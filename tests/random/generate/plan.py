"""What the parts of a random scene have to know of each other."""
import csv
import io
from dataclasses import dataclass, field
from pathlib import Path
from typing import Sequence

from draw import Draw

SOURCE = Path(__file__).resolve().parents[3]


@dataclass
class Plan:
    """Choices that rule the parts of one scene. Lengths in m, times in s, speeds in m/s."""

    draw: Draw
    length: float  # of the hull, or the size of the scene where there is none
    step: float
    steps: int
    start: float
    gravity: float  # downwards [m/s^2]
    integrator: str
    law: str
    has_water: bool = False
    buoyancy: bool = False
    drag: bool = False
    holder: str = ""  # of the vessel: carriage, fixed or free; empty: there is no vessel
    adrift: bool = False  # nothing acts from outside
    ice: bool = False
    fracture: bool = False
    tank: bool = False
    level: float = 0.0
    origin: float = 0.0  # x of the vessel's stern, within the walls of a tank
    rolling: bool = False
    parts: bool = False
    rods: bool = False
    manoeuvring: bool = False
    database: bool = False
    endless: bool = False  # the database has the added mass of infinite frequency
    waves: bool = False
    uniform_current: bool = True
    materials: list[str] = field(default_factory=list)
    thrusters: list[str] = field(default_factory=list)
    files: dict[str, bytes] = field(default_factory=dict)

    @property
    def reference(self) -> bool:
        """Whether the integrator is the one that takes few modules."""
        return self.integrator == "reference"

    @property
    def beam(self) -> float:
        """The beam of generated hulls, 1.2 m for 6 m."""
        return 0.2 * self.length

    @property
    def draught(self) -> float:
        """The draught of generated hulls, 0.35 m for 6 m."""
        return 0.35 / 6 * self.length

    @property
    def depth(self) -> float:
        """The height of generated hulls from keel to deck, 0.6 m for 6 m."""
        return 0.1 * self.length

    @property
    def speed(self) -> float:
        """A moderate speed: a Froude number of 0.1."""
        return 0.1 * (9.81 * self.length) ** 0.5

    @property
    def duration(self) -> float:
        """The simulated time [s]."""
        return self.step * self.steps

    def table(self, name: str, columns: Sequence[str], rows: Sequence[Sequence[float]]) -> str:
        """Adds a CSV file beside the scene; gives its name."""
        lines = io.StringIO()
        writer = csv.writer(lines, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows([[f"{value:.6g}" for value in row] for row in rows])
        self.files[name] = lines.getvalue().encode()
        return name

    def wedge(self, name: str, size: float) -> str:
        """Adds the surface of a wedge, size long and wide and half as high, in ASCII STL; gives its name."""
        a, b, c = size / 2, size / 2, size / 4
        p = [(-a, -b, -c), (a, -b, -c), (a, b, -c), (-a, b, -c), (-a, -b, c), (-a, b, c)]
        faces = [(0, 2, 1), (0, 3, 2), (0, 4, 5), (0, 5, 3), (0, 1, 4), (3, 5, 2), (1, 2, 5), (1, 5, 4)]
        lines = ["solid wedge"]
        for face in faces:
            lines += ["facet normal 0 0 0", "outer loop", *(f"vertex {x:.6g} {y:.6g} {z:.6g}" for x, y,
                                                            z in (p[k] for k in face)), "endloop", "endfacet"]
        self.files[name] = ("\n".join(lines) + "\nendsolid wedge\n").encode()
        return name

    def copy(self, path: str) -> str:
        """Adds a file of the source tree beside the scene; gives its name."""
        name = Path(path).name
        self.files[name] = (SOURCE / path).read_bytes()
        return name
