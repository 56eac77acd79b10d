"""A random scene with the runs of it that judges ask for."""
import shutil
import xml.etree.ElementTree as ET
from functools import cached_property
from pathlib import Path

from generate.scene import RandomScene
from images import mirrored, turned
from program import Program, Run


class Case:
    """Runs are made when a judge asks for them, and once."""

    def __init__(self, program: Program, scene: RandomScene, folder: Path) -> None:
        self.program = program
        self.scene = scene
        self.folder = folder
        shutil.rmtree(folder, ignore_errors=True)
        self.path = scene.write(folder / "scene")

    def attribute(self, element: str, name: str, default: str = "") -> str:
        """An attribute of the first element of this name."""
        found = self.scene.xml.find(f".//{element}")
        return default if found is None else found.get(name, default)

    def has(self, element: str) -> bool:
        """Whether the scene names the element."""
        return self.scene.xml.find(f".//{element}") is not None

    @property
    def step(self) -> float:
        """The time step [s]."""
        return float(self.attribute("time", "step"))

    @cached_property
    def resolved(self) -> ET.Element:
        """The scene as run, with every default."""
        return ET.parse(self.base.folder / "scene.xml").getroot()

    @cached_property
    def base(self) -> Run:
        """The run that all others are compared with."""
        return self.program.run(self.path, "base")

    @property
    def done(self) -> bool:
        """Whether that run came to its end."""
        return self.base.code == 0

    @cached_property
    def check(self) -> Run:
        """What `nilas check` says of the scene."""
        return self.program.call("check", str(self.path), "--quiet", folder=self.folder / "check")

    @cached_property
    def threads(self) -> Run:
        """The same on two threads."""
        return self.program.run(self.path, "threads", "--threads", "2")

    @cached_property
    def again(self) -> Run:
        """The scene that the run folder holds, run once more."""
        return self.program.run(self.base.folder / "scene.xml", "again")

    @cached_property
    def resumed(self) -> Run:
        """Stopped after half of the steps, and resumed."""
        time = self.resolved.find("time")
        assert time is not None
        start, end = float(time.get("start", "0")), time.get("end", "0")
        half = len(self.base.table("steps").rows) // 2 if self.base.table("steps") else 1  # type: ignore[union-attr]
        first = self.program.run(self.path, "resumed", "--until",
                                 repr(start + max(half, 1) * self.step - 0.5 * self.step),
                                 "--checkpoint-every", repr(self.step * 3))
        if first.code != 0:
            return first
        return self.program.call("run", "--resume", str(first.folder), "--until", end, "--quiet", folder=first.folder)

    def image(self, kind: str) -> Run | None:
        """The run of the mirrored or turned scene; None where the scene has no such image."""
        image = {"mirrored": mirrored, "turned": turned}[kind](self.scene)
        if image is None:
            return None
        return self.program.run(image.write(self.folder / f"{kind}-scene"), kind)
