"""Compares what commands left on the disk."""

from __future__ import annotations

import csv
import json
import re
from pathlib import Path
from xml.etree import ElementTree

try:
    import h5py
except ImportError:  # the datasets of HDF5 files are then not compared
    h5py = None

# What differs between two runs of one scene.
_TIMES = {
    "wall_s", "processor_s", "resuming_s", "real_time_factor", "slowdown", "ms_per_step", "threads",
}  # fmt: skip
_OWN = {"nilas.log", "checkpoint.h5", "replay.bin"}
_INDEX = "contacts"


def difference(run: Path, reference: Path) -> str:
    """The first difference of two run folders but for times and logs, or nothing."""
    names, wanted = _names(run), _names(reference)
    if names != wanted:
        return f"files {sorted(names ^ wanted)} are not in both"
    for name in sorted(wanted):
        if not _same(run / name, reference / name):
            return f"{name} differs"
    return ""


def half_files(run: Path, reference: Path) -> str:
    """The first file of a stopped run that is neither whole, nor a beginning, nor marked."""
    for name in sorted(_names(run)):
        file = run / name
        if name.endswith(".part") or name in _OWN or name.endswith("contacts.h5"):
            continue
        if not (reference / name).exists():
            continue
        if name.endswith((".csv", ".pvd")):
            if not _is_beginning(file, reference / name):
                return f"{name} holds other rows than those of a run that did not fail"
        elif name == "statistics.bin":
            if not (reference / name).read_bytes().startswith(file.read_bytes()):
                return f"{name} holds other numbers than those of a run that did not fail"
        elif name.endswith(".json"):
            try:
                json.loads(file.read_text())
            except ValueError:
                return f"{name} is no JSON"
        elif not _same(file, reference / name) and not name.endswith(".hdf5"):
            return f"{name} is half"
    return ""


def status(run: Path) -> str:
    """The status in summary.json, or nothing."""
    try:
        return str(json.loads((run / "summary.json").read_text()).get("status", ""))
    except (OSError, ValueError):
        return ""


def hashes(run: Path) -> list[str]:
    """The hash of the state after each step."""
    return [row["state_hash"] for row in _rows(run / "steps.csv")]


def table(file: Path, without: str = "$^") -> list[dict[str, str]]:
    """The rows of a table without the columns whose names match a pattern."""
    wanted = re.compile(without)
    return [{k: v for k, v in row.items() if not wanted.search(k)} for row in _rows(file)]


def _names(run: Path) -> set[str]:
    return {str(path.relative_to(run)) for path in run.rglob("*") if path.is_file()}


def _rows(file: Path) -> list[dict[str, str]]:
    with open(file, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream))


def _untimed(value: object) -> object:
    if isinstance(value, dict):
        return {key: _untimed(part) for key, part in value.items() if key not in _TIMES}
    return [_untimed(part) for part in value] if isinstance(value, list) else value


def _same(file: Path, other: Path) -> bool:
    if file.name in _OWN:
        return file.stat().st_size > 0
    if file.suffix in (".h5", ".hdf5"):
        return _same_hdf5(file, other)
    if file.name == "steps.csv":
        return table(file, "^ms_") == table(other, "^ms_")
    if file.name == "summary.json":
        try:
            return _untimed(json.loads(file.read_text())) == _untimed(json.loads(other.read_text()))
        except ValueError:
            return False
    return file.read_bytes() == other.read_bytes()


def _is_beginning(file: Path, other: Path) -> bool:
    if file.suffix == ".pvd":
        try:
            ElementTree.parse(file)
        except ElementTree.ParseError:
            return file.stat().st_size == 0
        lines, wanted = file.read_text().splitlines(), other.read_text().splitlines()
        return all(line in wanted for line in lines)
    text = file.read_text()
    if file.name != "steps.csv":
        return other.read_text().startswith(text) and (not text or text.endswith("\n"))
    rows, wanted_rows = table(file, "^ms_"), table(other, "^ms_")
    return (not text or text.endswith("\n")) and rows == wanted_rows[: len(rows)]


def _same_hdf5(file: Path, other: Path) -> bool:
    if h5py is None:
        return file.stat().st_size > 0
    try:
        return _datasets(file) == _datasets(other)
    except OSError:
        return False


def _datasets(file: Path) -> dict[str, bytes]:
    found: dict[str, bytes] = {}

    def take(name: str, item: object) -> None:
        if isinstance(item, h5py.Dataset):
            found[name] = repr(item[()]).encode() if item.dtype == object else item[()].tobytes()

    with h5py.File(file, "r", locking=False) as source:
        source.visititems(take)
    return found
