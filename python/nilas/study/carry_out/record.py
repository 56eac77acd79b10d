"""What came of a run, as one JSON object in the run's folder."""

from __future__ import annotations

import errno
import json
import math
import os
from dataclasses import asdict, dataclass, field
from pathlib import Path
from typing import Any

from nilas.study.carry_out.named_file import naming

RECORD = "record.json"  # written last: a run with this file is finished
BEGUN = "begun.json"  # written first, and removed at the end
# Keys of summary.json that differ from run to run of the same scene.
VOLATILE = {
    "wall_s", "processor_s", "real_time_factor", "resuming_s", "exit_code", "threads", "versions",
    "seed", "ms_per_step", "memory",
}  # fmt: skip


@dataclass
class Record:
    """A finished run.

    ``key``: hash of what the run was made of. ``status``: done or failed. ``values``: every
    number of summary.json by its path. ``columns``: what responses took from tables, by name.
    """

    run: str
    point: str
    seed: int
    key: str
    status: str
    exit_code: int
    message: str = ""
    values: dict[str, float] = field(default_factory=dict)
    columns: dict[str, float] = field(default_factory=dict)
    overrides: dict[str, str] = field(default_factory=dict)
    times: dict[str, Any] = field(default_factory=dict)
    provenance: dict[str, Any] = field(default_factory=dict)

    def text(self) -> str:
        """The record as one line of JSON. Floats have all digits that they need."""
        return json.dumps(asdict(self), separators=(",", ":"), allow_nan=False)


def record_of(text: str) -> Record:
    """The record that a line of JSON holds."""
    return Record(**json.loads(text))


def write_whole(path: Path, text: str) -> None:
    """Writes a file so that others see all of it or nothing, even after a crash."""
    other = path.with_name(path.name + ".part")
    with naming(path), open(other, "w", encoding="utf-8") as stream:
        stream.write(text)
        stream.flush()
        os.fsync(stream.fileno())
    os.replace(other, path)
    _flush_names(path.parent)


def _flush_names(folder: Path) -> None:
    """Waits until the names in a folder are on the disk. Some file systems refuse it."""
    try:
        descriptor = os.open(folder, os.O_RDONLY)
    except PermissionError:
        return
    try:
        os.fsync(descriptor)
    except OSError as error:
        if error.errno not in (errno.EINVAL, errno.ENOTSUP, errno.EBADF):
            raise OSError(error.errno, error.strerror, str(folder)) from error
    finally:
        os.close(descriptor)


def flat_numbers(value: Any, path: str = "") -> dict[str, float]:
    """All numbers of a JSON value by their path with points. Parts of lists are named.

    >>> flat_numbers({"a": {"b_N": 1.5}, "list": [{"name": "pier", "x": 2}], "on": True})
    {'a.b_N': 1.5, 'list.pier.x': 2.0, 'on': 1.0}
    """
    if isinstance(value, bool):
        return {path: float(value)}
    if isinstance(value, int | float):
        return {path: float(value)} if math.isfinite(value) else {}
    flat: dict[str, float] = {}
    for key, one in parts_of(value):
        flat.update(flat_numbers(one, f"{path}.{key}" if path else key))
    return flat


def parts_of(value: Any) -> list[tuple[str, Any]]:
    """The parts of a JSON object or list with their names, without those that differ by chance.

    >>> parts_of({"wall_s": 3, "list": [5]}), parts_of([{"name": "pier"}, 7]), parts_of(None)
    ([('list', [5])], [('pier', {'name': 'pier'}), ('2', 7)], [])
    """
    if isinstance(value, dict):
        return [(key, one) for key, one in value.items() if key not in VOLATILE]
    if isinstance(value, list):
        return [(_name_in_list(one, place), one) for place, one in enumerate(value, 1)]
    return []


def _name_in_list(value: Any, place: int) -> str:
    name = value.get("name") if isinstance(value, dict) else None
    return str(name) if name else str(place)
