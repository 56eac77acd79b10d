"""Outlines of floes from a shapefile, as the GeoJSON that ``<field kind="file">`` reads."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from nilas.errors import FileError, InputError
from nilas.names import unknown

_POLYGONS = {5: "POLYGON", 15: "POLYGONZ", 25: "POLYGONM"}


class Converted(NamedTuple):
    """``floes``: floes written. ``filled``: holes that were filled. ``file``: where they are.

    >>> Converted(floes=2, filled=0, file=Path("field.geojson")).floes
    2
    """

    floes: int
    filled: int
    file: Path


def field_from_shapefile(
    shapefile: str | os.PathLike[str],
    geojson: str | os.PathLike[str],
    *,
    scale: float = 1.0,
    origin: tuple[float, float] = (0.0, 0.0),
    thickness: str | None = None,
    density: str | None = None,
    holes: str = "refuse",
) -> Converted:
    """Writes the polygons of a shapefile as floes that a scene can read.

    ``scale``: metres per unit of the file. ``origin``: the point of the file, in its units, that
    becomes x = y = 0. ``thickness``, ``density``: columns of the file with the thickness [m] and
    the density [kg/m^3] of each floe; without them those of the scene hold. ``holes``:
    ``refuse``, or ``fill`` for floes without their holes. A record of several outlines becomes
    several floes. Coordinates in degrees are refused.

    >>> converted = field_from_shapefile(example_shapefile, "field.geojson", thickness="thick")
    >>> converted.floes, converted.file.name
    (2, 'field.geojson')
    """
    if holes not in ("refuse", "fill"):
        raise InputError(f"holes is 'refuse' or 'fill', not {holes!r}.")
    source = Path(shapefile)
    _demand_metres(source)
    columns = {"thickness_m": thickness, "density_kg_m3": density}
    features, filled = [], 0
    for number, points, bounds, record in _records(source):
        properties = {
            name: _value(record, column, number, source)
            for name, column in columns.items()
            if column is not None
        }
        outer, inner = _rings(points, bounds)
        if inner and holes == "refuse":
            raise InputError(
                f"{source}: record {number} has a hole, and a floe has none. holes='fill' fills it."
            )
        filled += inner
        features += [_feature((ring - origin) * scale, properties) for ring in outer]
    target = Path(geojson)
    target.write_text(json.dumps({"type": "FeatureCollection", "features": features}) + "\n")
    return Converted(len(features), filled, target)


def _records(
    source: Path,
) -> Iterator[tuple[int, NDArray[np.float64], list[int], dict[str, Any]]]:
    """Number from 1, points of shape (points, 2), first points of the rings and columns."""
    try:
        import shapefile as pyshp
    except ModuleNotFoundError:
        raise ModuleNotFoundError(
            "Shapefiles need the package pyshp, python3-pyshp of Debian."
        ) from None
    try:
        reader = pyshp.Reader(str(source))
    except pyshp.ShapefileException as fault:
        raise FileError(f"{source}: this cannot be read as a shapefile: {fault}") from None
    with reader:
        if reader.shapeType not in _POLYGONS:
            raise InputError(
                f"{source}: it holds {reader.shapeTypeName} and not polygons, so no outlines."
            )
        for number, item in enumerate(reader.iterShapeRecords(), start=1):
            if item.shape.shapeType in _POLYGONS and item.shape.points:
                points = np.array([point[:2] for point in item.shape.points], dtype=float)
                yield number, points, list(item.shape.parts), item.record.as_dict()


def _demand_metres(source: Path) -> None:
    """Refuses a projection of degrees, which the .prj file beside the shapefile names."""
    projection = source.with_suffix(".prj")
    if projection.is_file() and projection.read_text(errors="replace").lstrip().startswith(
        "GEOGCS"
    ):
        raise InputError(
            f"{source}: its coordinates are degrees of longitude and latitude, as {projection.name}"
            " says. Project it to metres first, as by: ogr2ogr -t_srs EPSG:3413 metres.shp"
            f" {source.name}"
        )


def _rings(points: NDArray[np.float64], bounds: list[int]) -> tuple[list[NDArray[np.float64]], int]:
    """Outlines, which run clockwise in a shapefile, and the number of holes, which do not."""
    ends = [*bounds[1:], len(points)]
    rings = [points[begin:end] for begin, end in zip(bounds, ends)]
    if len(rings) == 1:
        return rings, 0
    outer = [ring for ring in rings if _area(ring) < 0]
    return outer, len(rings) - len(outer)


def _area(ring: NDArray[np.float64]) -> float:
    """Area of a closed ring, above 0 where it runs counter-clockwise."""
    x, y = (ring - ring[0]).T
    return 0.5 * float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))


def _feature(ring: NDArray[np.float64], properties: dict[str, float]) -> dict[str, Any]:
    corners = ring if _area(ring) > 0 else ring[::-1]
    return {
        "type": "Feature",
        "properties": properties,
        "geometry": {"type": "Polygon", "coordinates": [corners.tolist()]},
    }


def _value(record: dict[str, Any], column: str, number: int, source: Path) -> float:
    if column not in record:
        raise unknown(f"{source}: there is no column '{column}'", column, record)
    try:
        return float(record[column])
    except (TypeError, ValueError):
        raise InputError(
            f"{source}: {column} of record {number} is {record[column]!r} and not a number."
        ) from None
