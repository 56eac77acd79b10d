"""Cases for tests, in a folder of their own, with the stand-in for the program.

The load of the stand-in is 10 x + 3 y^2 and noise of deviation 1 that follows from the seed. The
formula full-contact is width times thickness times strength, here x times 1 times 10: the same
load where y is 0, and 3 less where it is 1.
"""

from __future__ import annotations

import contextlib
import csv
import io
from pathlib import Path

from nilas.validate.command import main

STAND_IN = Path(__file__).resolve().parent.parent / "study" / "stand_in.py"
CASE = """\
title: A trial
question: Is the load ten times x?
minutes: 1
study:
  scene: scene.xml
  factors:
    test/@x: [2, 4, 8]
    test/@y: [0, 1]
  design: one-at-a-time
  seeds: 4
  responses: [{channel: ice_load.along.mean_N, name: load}]
inputs: {width: test/@x, thickness: 1, compressive_strength: 10, coefficient: 10, exponent: -0.5}
references:
  - {quantity: load, formula: full-contact}
slopes:
  - {quantity: load, over: x, input: width, formulas: [full-contact]}
slice: {seeds: 3, points: [1]}
"""


class ValidationDesk:
    """A folder with a scene, where cases are written and carried out."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        (folder / "scene.xml").write_text('<scene version="1" name="test"/>')

    def write(self, text: str = CASE, name: str = "trial.yaml") -> Path:
        file = self.folder / name
        file.write_text(text)
        return file

    @property
    def out(self) -> Path:
        return self.folder / "out"

    def run(self, *words: str, files: tuple[str, ...] = ("trial.yaml",)) -> tuple[int, str]:
        """Exit code and all that was printed."""
        told = io.StringIO()
        names = [str(self.folder / name) for name in files]
        program = ["--program", str(STAND_IN), "--out", str(self.out)]
        with contextlib.redirect_stdout(told), contextlib.redirect_stderr(told):
            code = main([*names, *program, *words])
        return code, told.getvalue()

    def rows(self) -> list[dict[str, str]]:
        with open(self.out / "validation.csv", newline="") as stream:
            return list(csv.DictReader(stream))

    def row(self, point: str, reference: str = "") -> dict[str, str]:
        found = [
            row for row in self.rows() if row["point"] == point and reference in row["reference"]
        ]
        assert len(found) == 1, found
        return found[0]
