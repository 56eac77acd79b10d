"""Studies for tests: in a folder of their own, with the stand-in for the program."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import time
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[2]
STAND_IN = Path(__file__).with_name("stand_in.py")
STUDY = """\
name: trial
scene: scene.xml
factors:
  test/@x: [1, 2, 3]
  test/@y: [0, 1]
seeds: 2
responses:
  - {channel: ice_load.along.mean_N, name: load}
"""
SLOW = STUDY + "set: {test/@steps: 25}\nrun: {checkpoint_every: 1}\n"


class Desk:
    """A folder with a scene, where studies are written and carried out."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        (folder / "scene.xml").write_text('<scene version="1" name="test"/>')

    def write(self, text: str = STUDY, name: str = "study.yaml") -> Path:
        file = self.folder / name
        file.write_text(text)
        return file

    def start(
        self,
        *words: str,
        program: Path = STAND_IN,
        file: str = "study.yaml",
        stdout: int = subprocess.PIPE,
        stderr: int = subprocess.PIPE,
    ) -> subprocess.Popen:
        return subprocess.Popen(
            [sys.executable, "-m", "nilas.study", file, "--program", str(program), *words],
            cwd=self.folder,
            env=os.environ | {"PYTHONPATH": str(PACKAGE)},
            stdout=stdout,
            stderr=stderr,
            text=True,
        )

    def run(
        self, *words: str, program: Path = STAND_IN, file: str = "study.yaml", page: bool = False
    ) -> tuple[int, str]:
        """Exit code and all that was printed. Pages take seconds, so few tests write one."""
        words += () if page else ("--no-page",)
        process = self.start(*words, program=program, file=file)
        output, errors = process.communicate(timeout=300)
        return process.returncode, output + errors

    def table(self, out: str = "runs/trial", name: str = "study.csv") -> str:
        return (self.folder / out / name).read_text()


def records(desk, out="runs/trial"):
    """The records of all runs that ended, by their folders."""
    return {
        str(file.parent.relative_to(desk.folder / out / "runs")): json.loads(file.read_text())
        for file in (desk.folder / out / "runs").rglob("record.json")
    }


def wait_for(condition, seconds=120.0):
    """Returns once the condition holds, and fails after so many seconds."""
    end = time.monotonic() + seconds
    while not condition():
        assert time.monotonic() < end, "nothing happened in time"
        time.sleep(0.02)
