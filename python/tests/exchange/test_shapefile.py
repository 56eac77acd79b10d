"""Outlines of a shapefile become floes that the program reads."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

import nilas
from nilas.exchange.shapefile import field_from_shapefile

pyshp = pytest.importorskip("shapefile", reason="needs pyshp (python3-pyshp of Debian)")

SQUARE = [[0.0, 0.0], [0.0, 4.0], [4.0, 4.0], [4.0, 0.0], [0.0, 0.0]]  # clockwise: an outline
HOLE = [[1.0, 1.0], [2.0, 1.0], [2.0, 2.0], [1.0, 2.0], [1.0, 1.0]]
BESIDE = [[x + 5, y] for x, y in SQUARE]


def write(file: Path, rings: list[list[list[float]]], kind: int = pyshp.POLYGON) -> Path:
    with pyshp.Writer(str(file), shapeType=kind) as writer:
        writer.field("name", "C")
        (writer.poly if kind == pyshp.POLYGON else writer.line)(rings)
        writer.record("a")
    return file


def test_the_program_reads_the_field(
    floe_shapefile: Path, small_scene: Path, tmp_path: Path
) -> None:
    """Floes of 4 m^2 and 1 m^2, 0.5 m and 0.75 m thick, at 920 kg/m^3: 1840 kg and 690 kg."""
    field = tmp_path / "field.geojson"
    converted = field_from_shapefile(floe_shapefile, field, origin=(10, 0), thickness="thick")
    assert converted == (2, 0, field)
    scene = tmp_path / "scene.xml"
    text = small_scene.read_text()
    begin, end = text.index("<field"), text.index("</field>") + len("</field>")
    text = text[:begin] + '<field kind="file" file="field.geojson"/>' + text[end:]
    scene.write_text(text.replace('position="0 0"', 'position="-20 0"'))
    run = nilas.run(scene, out=tmp_path / "run", until=0.01)
    assert run.summary["ice"]["floes"] == 2
    assert run.summary["ice"]["mass_kg"] == pytest.approx(1840 + 690, rel=1e-9)
    first = run.trajectory.surface("ice floes", 0).points
    assert [first[:, 0].min(), first[:, 0].max()] == pytest.approx([0, 11])


def test_units_and_records_of_several_outlines(tmp_path: Path) -> None:
    """The file is in kilometres here. Rings come out counter-clockwise, as GeoJSON wants."""
    source = write(tmp_path / "two.shp", [SQUARE, BESIDE])
    converted = field_from_shapefile(source, tmp_path / "two.geojson", scale=1000)
    assert converted.floes == 2
    features = json.loads((tmp_path / "two.geojson").read_text())["features"]
    ring = features[1]["geometry"]["coordinates"][0]
    assert max(x for x, _ in ring) == 9000
    assert sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, ring[1:])) == 2 * 4000**2


def test_holes_are_refused_or_filled(tmp_path: Path) -> None:
    source = write(tmp_path / "hole.shp", [SQUARE, HOLE])
    with pytest.raises(nilas.InputError, match="record 1 has a hole.*holes='fill'"):
        field_from_shapefile(source, tmp_path / "hole.geojson")
    converted = field_from_shapefile(source, tmp_path / "hole.geojson", holes="fill")
    assert (converted.floes, converted.filled) == (1, 1)


def test_what_cannot_be_floes_is_refused(tmp_path: Path) -> None:
    lines = write(tmp_path / "lines.shp", [SQUARE], pyshp.POLYLINE)
    with pytest.raises(nilas.InputError, match="holds POLYLINE and not polygons"):
        field_from_shapefile(lines, tmp_path / "x.geojson")
    source = write(tmp_path / "one.shp", [SQUARE])
    with pytest.raises(nilas.UnknownName, match="no column 'thick'; allowed: name"):
        field_from_shapefile(source, tmp_path / "x.geojson", thickness="thick")
    with pytest.raises(nilas.InputError, match="name of record 1 is 'a' and not a number"):
        field_from_shapefile(source, tmp_path / "x.geojson", thickness="name")
    with pytest.raises(nilas.FileError, match="cannot be read as a shapefile"):
        field_from_shapefile(tmp_path / "none.shp", tmp_path / "x.geojson")
    source.with_suffix(".prj").write_text('GEOGCS["WGS 84",DATUM["WGS_1984"]]')
    with pytest.raises(nilas.InputError, match="degrees of longitude and latitude"):
        field_from_shapefile(source, tmp_path / "x.geojson")
    assert not (tmp_path / "x.geojson").exists()
