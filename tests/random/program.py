"""Runs the program and reads what it writes."""
import csv
import json
import os
import resource
import shutil
import signal
import subprocess
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

SECONDS = 60.0  # of processor time that a command may take; scenes are built to take less than one
WAITS = 3600.0  # wall time after which a command counts as hanging without computing [s]
TABLES = ("steps", "bodies", "vessel", "parts", "structures", "events")


class Table:
    """A CSV file by columns of text; numbers are read when they are asked for."""

    def __init__(self, path: Path) -> None:
        with path.open(newline="", encoding="utf-8") as file:
            rows = list(csv.reader(file))
        self.names = rows[0]
        self.rows = rows[1:]

    def text(self, name: str) -> list[str]:
        """A column as it is written."""
        at = self.names.index(name)
        return [row[at] for row in self.rows]

    def numbers(self, name: str) -> list[float]:
        """A column of numbers."""
        return [float(value) for value in self.text(name)]

    def without_times(self) -> list[list[str]]:
        """All rows, less the columns of wall times."""
        kept = [k for k, name in enumerate(self.names) if not name.startswith("ms_")]
        return [[row[k] for k in kept] for row in [self.names, *self.rows]]


@dataclass
class Run:
    """A command that has ended, with the folder that it wrote."""

    command: list[str]
    code: int | None  # None: it took too long, or hung
    said: str
    folder: Path

    @cached_property
    def summary(self) -> dict[str, Any]:
        """The object of summary.json; empty where there is none."""
        path = self.folder / "summary.json"
        found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
        return found

    def table(self, name: str) -> Table | None:
        """The table of this name; None where the run has none or it holds no row."""
        if name not in self.__dict__.setdefault("_tables", {}):
            path = self.folder / f"{name}.csv"
            found = Table(path) if path.exists() and path.stat().st_size else None
            self.__dict__["_tables"][name] = found
        table: Table | None = self.__dict__["_tables"][name]
        return table if table and table.rows else None

    def error(self) -> str:
        """What was said, less the warnings: the sentences of an error."""
        lines: list[str] = []
        in_warning = False
        for line in self.said.splitlines():
            in_warning = "warning:" in line or (in_warning and line.startswith("  "))
            if not in_warning:
                lines.append(line)
        return "\n".join(lines).strip()


class Program:
    """The program under test."""

    def __init__(self, path: Path, seconds: float = SECONDS) -> None:
        self._path = path.resolve()
        self._seconds = seconds

    def hurried(self, seconds: float) -> "Program":
        """The same program with less processor time for each command [s]."""
        return Program(self._path, seconds)

    def call(self, *arguments: str, folder: Path) -> Run:
        """Runs a command to its end; folder is what it writes, and its working directory is the one above."""
        command = [str(self._path), *arguments]
        environment = {**os.environ, "TZ": "UTC"}
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=WAITS, check=False,
                                  cwd=folder.parent,
                                  env=environment, preexec_fn=self._limit)
        except subprocess.TimeoutExpired:
            return Run(command, None, "", folder)
        out_of_time = done.returncode in (-signal.SIGXCPU, -signal.SIGKILL)
        return Run(command, None if out_of_time else done.returncode, done.stderr, folder)

    def _limit(self) -> None:
        """Bounds the processor time of the child, which a busy machine does not change."""
        most = max(1, round(self._seconds))
        resource.setrlimit(resource.RLIMIT_CPU, (most, most + 5))

    def run(self, scene: Path, name: str, *flags: str) -> Run:
        """Runs a scene into a new folder of this name beside the folder of the scene."""
        folder = scene.parent.parent / name
        shutil.rmtree(folder, ignore_errors=True)
        return self.call("run", str(scene), "--out", str(folder), "--quiet", *flags, folder=folder)

    def schema(self) -> str:
        """The schema of scenes as XSD."""
        return subprocess.run([self._path, "schema"], capture_output=True, text=True, check=True).stdout
