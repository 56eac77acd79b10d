"""What made a run: program, build, scene and machine."""

from __future__ import annotations

import functools
import hashlib
import os
import platform
import subprocess
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from nilas.study.carry_out.named_file import naming
from nilas.study.describe.faults import StudyError


def find_program(named: str | None) -> Path:
    """The program of a study: the one that the user names, else the one that ``nilas`` finds."""
    if named:
        path = Path(named).absolute()
        if not (path.is_file() and os.access(path, os.X_OK)):
            raise StudyError(f"{path} is no program that can be run.", 4)
        return path
    from nilas.program import NotFound, program

    try:
        return program()
    except NotFound as error:
        raise StudyError(str(error), 4) from error


def file_hash(path: Path) -> str:
    """SHA-256 of a file."""
    digest = hashlib.sha256()
    with naming(path), open(path, "rb") as stream:
        while block := stream.read(1 << 20):
            digest.update(block)
    return digest.hexdigest()


@functools.cache
def program_facts(program: Path) -> dict[str, str]:
    """Version and hash of the program. The hash tells two builds of one version apart."""
    try:
        answer = subprocess.run(
            [program, "--version"], capture_output=True, text=True, check=True, timeout=60
        )
    except (OSError, subprocess.SubprocessError) as error:
        raise StudyError(f"{program} does not tell its version: {error}.", 4) from error
    return {"version": answer.stdout.partition("\n")[0], "sha256": file_hash(program), "path": str(program)}


@functools.cache
def machine_facts() -> dict[str, str | int]:
    """Name, processor, cores and system of this machine."""
    return {
        "name": platform.node(),
        "processor": _processor(),
        "cores": os.cpu_count() or 1,
        "system": platform.platform(),
        "python": platform.python_version(),
    }


def scene_hash(scene: Path) -> str:
    """SHA-256 of a scene file and of all files and folders that its attributes name.

    A study so sees that a hull or a table of currents has changed since its runs were made.
    """
    with naming(scene):
        text = scene.read_bytes()
    digest = hashlib.sha256(text)
    try:
        root = ElementTree.fromstring(text)
    except ElementTree.ParseError:
        # The program says what is wrong, in its own words.
        return digest.hexdigest()
    values = {value for element in root.iter() for value in element.attrib.values()}
    for value in sorted(values):
        digest.update(input_hash(scene.parent, value).encode())
    return digest.hexdigest()


@functools.cache
def input_hash(folder: Path, value: str) -> str:
    """SHA-256 of the file or folder that an attribute's value names, or nothing."""
    if not value.strip() or len(value) > 1000 or value.strip(" ./") == "":
        return ""
    path = folder / value
    try:
        if path.is_file():
            return file_hash(path)
        if path.is_dir():
            files = sorted(one for one in path.iterdir() if one.is_file())
            return "".join(one.name + file_hash(one) for one in files)
    except (OSError, ValueError):
        pass
    return ""


def _processor() -> str:
    try:
        for line in Path("/proc/cpuinfo").read_text().splitlines():
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    except OSError:
        pass
    return platform.processor() or platform.machine()
