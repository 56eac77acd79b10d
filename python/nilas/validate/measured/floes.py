"""Floes of a measured run: outlines or positions from a table, as GeoJSON for a scene."""

from __future__ import annotations

import csv
import json
import math
from collections.abc import Mapping
from pathlib import Path

import numpy as np

_CORNERS = ("floe", "x_m", "y_m")
_BLOCKS = ("floe", "x_m", "y_m", "heading_deg", "length_m", "width_m")
# A layout read from photographs overlaps a little; more than this share of a floe is a mistake.
_MOST_OVERLAP = 0.02


class FloesError(ValueError):
    """A table of floes that cannot be used as it is."""


def floes_from_table(
    table: str | Path,
    geojson: str | Path,
    *,
    thickness: float | None = None,
    origin: tuple[float, float] = (0.0, 0.0),
    heading_deg: float = 0.0,
) -> int:
    """Writes the floes of a table as GeoJSON, which ``<field kind="file">`` reads, and counts them.

    The table is CSV, of one of two kinds:

    - corners: ``floe, x_m, y_m``, a row for each corner, in their order around the floe;
    - blocks: ``floe, x_m, y_m, heading_deg, length_m, width_m``, a row for each rectangle with its
      centre. ``heading_deg`` turns its length from x towards y.

    A column ``thickness_m`` gives each floe its own; else ``thickness`` [m] holds for all, or that
    of the scene. ``origin`` [m] is the point of the table that becomes x = y = 0 of the scene, and
    ``heading_deg`` the direction of the table that becomes its x axis. Raises ``FloesError`` with
    the line of a floe that has no area, or that is covered by another by more than 2 %.
    """
    path = Path(table)
    rows, names = _rows(path)
    if set(_BLOCKS) <= set(names):
        floes = [_block(path, line, row) for line, row in rows]
    elif set(_CORNERS) <= set(names):
        floes = _polygons(path, rows)
    else:
        raise FloesError(
            f"{path}:1: the columns are {', '.join(names)}. Corners need {', '.join(_CORNERS)}, "
            f"and blocks {', '.join(_BLOCKS)}."
        )
    placed = [
        (line, name, _turned(outline, origin, heading_deg), own)
        for line, name, outline, own in floes
    ]
    _check_overlaps(path, placed)
    features = []
    for _, name, outline, own in placed:
        properties: dict[str, float | str] = {"name": name}
        if own is not None or thickness is not None:
            properties["thickness_m"] = own if own is not None else float(thickness or 0.0)
        ring = [*outline.tolist(), outline[0].tolist()]
        geometry = {"type": "Polygon", "coordinates": [ring]}
        features.append({"type": "Feature", "properties": properties, "geometry": geometry})
    Path(geojson).write_text(json.dumps({"type": "FeatureCollection", "features": features}) + "\n")
    return len(features)


def _rows(path: Path) -> tuple[list[tuple[int, Mapping[str, str]]], list[str]]:
    try:
        with open(path, newline="", encoding="utf-8") as stream:
            reader = csv.DictReader(stream)
            rows = list(enumerate(reader, 2))
            names = list(reader.fieldnames or [])
    except OSError as error:
        raise FloesError(f"{path} cannot be read: {error.strerror}.") from error
    if not rows:
        raise FloesError(f"{path} has no rows.")
    return rows, names


def _block(path: Path, line: int, row: Mapping[str, str]):
    x, y, degrees, length, width = (_number(path, line, row, name) for name in _BLOCKS[1:])
    if length <= 0 or width <= 0:
        raise FloesError(f"{path}:{line}: a block has a length and a width above 0.")
    corners = 0.5 * np.array(
        [[-length, -width], [length, -width], [length, width], [-length, width]]
    )
    turned = corners @ _rotation(math.radians(degrees)).T + (x, y)
    return line, row["floe"], turned, _thickness(path, line, row)


def _polygons(path: Path, rows):
    corners: dict[str, list[tuple[float, float]]] = {}
    first: dict[str, tuple[int, Mapping[str, str]]] = {}
    for line, row in rows:
        name = row["floe"]
        first.setdefault(name, (line, row))
        point = (_number(path, line, row, "x_m"), _number(path, line, row, "y_m"))
        corners.setdefault(name, []).append(point)
    floes = []
    for name, points in corners.items():
        line, row = first[name]
        outline = np.array(points)
        area = _area(outline)
        if len(points) < 3 or abs(area) < 1e-9:
            raise FloesError(f"{path}:{line}: floe {name} has no area; it needs three corners.")
        outline = outline if area > 0 else outline[::-1]
        floes.append((line, name, outline, _thickness(path, line, row)))
    return floes


def _thickness(path: Path, line: int, row: Mapping[str, str]) -> float | None:
    if not row.get("thickness_m"):
        return None
    value = _number(path, line, row, "thickness_m")
    if value <= 0:
        raise FloesError(f"{path}:{line}: thickness_m is {value:g}, and must be above 0.")
    return value


def _turned(outline: np.ndarray, origin: tuple[float, float], heading_deg: float) -> np.ndarray:
    return (outline - origin) @ _rotation(-math.radians(heading_deg)).T


def _rotation(angle: float) -> np.ndarray:
    return np.array([[math.cos(angle), -math.sin(angle)], [math.sin(angle), math.cos(angle)]])


def _area(outline: np.ndarray) -> float:
    x, y = outline.T
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def _check_overlaps(path: Path, floes) -> None:
    """Refuses floes that cover each other by more than what reading them off explains."""
    boxes = [(outline.min(axis=0), outline.max(axis=0)) for _, _, outline, _ in floes]
    for first in range(len(floes)):
        for second in range(first + 1, len(floes)):
            low = np.maximum(boxes[first][0], boxes[second][0])
            high = np.minimum(boxes[first][1], boxes[second][1])
            if (low >= high).any():
                continue
            line, name, one, _ = floes[second]
            other = floes[first][2]
            if not _is_convex(other):
                one, other = other, one
            if not _is_convex(other):
                continue  # Two concave floes: the program itself looks at them.
            covered = _clipped_area(one, other) / min(abs(_area(one)), abs(_area(other)))
            if covered > _MOST_OVERLAP:
                raise FloesError(
                    f"{path}:{line}: floe {name} is covered by floe {floes[first][1]} by "
                    f"{100 * covered:.0f} %. Nothing overlaps in a tank; correct the positions."
                )


def _is_convex(outline: np.ndarray) -> bool:
    sides = np.roll(outline, -1, axis=0) - outline
    after = np.roll(sides, -1, axis=0)
    return bool((sides[:, 0] * after[:, 1] - sides[:, 1] * after[:, 0] >= -1e-12).all())


def _clipped_area(subject: np.ndarray, clip: np.ndarray) -> float:
    """Area of a polygon inside of a convex one, by clipping at each side (Sutherland, Hodgman)."""
    points = list(subject)
    for start, end in zip(clip, np.roll(clip, -1, axis=0), strict=True):
        side = end - start
        kept: list[np.ndarray] = []
        for here, there in zip(points, points[1:] + points[:1], strict=True):
            inner = side[0] * (here - start)[1] - side[1] * (here - start)[0]
            outer = side[0] * (there - start)[1] - side[1] * (there - start)[0]
            if inner >= 0:
                kept.append(here)
            if (inner >= 0) != (outer >= 0):
                kept.append(here + inner / (inner - outer) * (there - here))
        points = kept
        if len(points) < 3:
            return 0.0
    return abs(_area(np.array(points)))


def _number(path: Path, line: int, row: Mapping[str, str], name: str) -> float:
    try:
        value = float(row[name])
    except (TypeError, ValueError):
        value = math.nan
    if not math.isfinite(value):
        raise FloesError(
            f"{path}:{line}: {name} is '{row[name]}', and a number should stand there."
        )
    return value
