"""Measured tables, towing records and floes. All files here are synthetic: nobody measured them."""

import json
import math
import shutil
from pathlib import Path

import numpy as np
import pytest
from validation_desk import CASE

from nilas.validate.measured.floes import FloesError, floes_from_table
from nilas.validate.measured.record import RecordError, towing_record
from nilas.validate.measured.rows import MeasuredError, read_measured

DATA = Path(__file__).parent / "data"
MEASURED = CASE.replace("test/@x: [2, 4, 8]", "test/@x: {from: 1, to: 10}").replace(
    "test/@y: [0, 1]", "test/@y: {from: 0, to: 2}"
).replace("  design: one-at-a-time\n", "") + "measured: synthetic-measured.csv\n"  # fmt: skip


@pytest.fixture
def measured_desk(desk):
    for file in DATA.glob("synthetic-*"):
        shutil.copy(file, desk.folder)
    desk.write(MEASURED)
    return desk


def test_the_points_are_those_of_the_table_and_are_judged_by_it(measured_desk):
    code, text = measured_desk.run("-j", "2")
    assert code == 0, text
    rows = {row["reference"]: row for row in measured_desk.rows() if "measured" in row["reference"]}
    assert set(rows) == {f"measured, test s{k}" for k in (1, 2, 3, 4)}
    first = rows["measured, test s1"]
    assert first["point"] == "x 2, y 0" and first["verdict"] == "within"
    assert float(first["reference_low"]) == 18.5 and float(first["reference_high"]) == 20.5
    off = rows["measured, test s2"]
    assert off["verdict"] == "outside by more than its error" and "Four too much." in off["remark"]
    assert "does not state how well" in rows["measured, test s3"]["remark"]
    # 10 x + 3 y^2 = 23 N is not the 20 N of the record.
    record = rows["measured, test s4"]
    assert float(record["reference_value"]) == pytest.approx(20, abs=1)
    assert record["source"] == "synthetic"


def test_a_record_gives_mean_and_interval_of_its_window():
    record = towing_record(DATA / "synthetic-record.csv", 10, 40)
    forces = np.loadtxt(DATA / "synthetic-record.csv", delimiter=",", skiprows=1)
    inside = forces[forces[:, 0] >= 10, 1]
    assert record.mean_N == pytest.approx(inside.mean())
    assert record.max_N == inside.max() and record.from_s == 10 and record.to_s == 40
    # The noise has a deviation of 2.3 N and forgets itself within 19 samples.
    expected = 2.365 * 2.3 * math.sqrt(19 / len(inside))
    assert record.interval_N == pytest.approx(expected, rel=0.6)
    assert abs(record.mean_N - 20) < record.interval_N
    assert record.speed_m_s == pytest.approx(0.3)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("time_s,load\n1,2\n", "no column force_N"),
        ("time_s,force_N\n1,2\n1,3\n", ":3: time does not rise"),
        ("time_s,force_N\n1,two\n", ":2: force_N is 'two'"),
        ("time_s,force_N\n1,2\n2,3\n", "needs 16"),
        ("time_s,force_N\n", "has no rows"),
    ],
)
def test_faults_of_a_record_are_told_with_their_line(tmp_path, text, message):
    file = tmp_path / "record.csv"
    file.write_text(text)
    with pytest.raises(RecordError, match=message):
        towing_record(file)


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("x,source\n1,s\n", "columns y are missing"),
        ("x,y,source,lod\n1,1,s,2\n", "no factor and no response 'lod'"),
        ("x,y,load,source\n1,,3,s\n", ":2: y is empty"),
        ("x,y,load,source\n1,1,3\n", "not as many cells"),
        ("x,y,load,source\n1,1,much,s\n", "load is 'much'"),
        ("x,y,load,source\n1,1,,s\n", "no measured number"),
        ("# nothing\n", "has no rows"),
        ("x,y,load,record,source\n1,1,,none.csv,s\n", "cannot be read"),
    ],
)
def test_faults_of_a_measured_table_are_told_with_their_line(tmp_path, text, message):
    file = tmp_path / "measured.csv"
    file.write_text(text)
    with pytest.raises(MeasuredError, match=message):
        read_measured(file, ["x", "y"], ["load"])


def area(ring):
    x, y = np.array(ring[:-1]).T
    return 0.5 * float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def test_blocks_become_floes_at_their_places(tmp_path):
    out = tmp_path / "field.geojson"
    assert floes_from_table(DATA / "synthetic-blocks.csv", out, thickness=0.02) == 3
    features = json.loads(out.read_text())["features"]
    rings = [one["geometry"]["coordinates"][0] for one in features]
    assert [area(ring) for ring in rings] == pytest.approx([0.08, 0.08, 0.09])
    assert [one["properties"]["thickness_m"] for one in features] == [0.03, 0.02, 0.03]
    # The second lies across: 0.2 m along x, 0.4 m along y, about its centre.
    low, high = np.min(rings[1], axis=0), np.max(rings[1], axis=0)
    assert low == pytest.approx([1.9, 0.3]) and high == pytest.approx([2.1, 0.7])


def test_origin_and_heading_turn_the_table_into_the_scene(tmp_path):
    out = tmp_path / "field.geojson"
    floes_from_table(DATA / "synthetic-corners.csv", out, origin=(1.0, 0.0), heading_deg=90.0)
    features = json.loads(out.read_text())["features"]
    # The table's y axis is the scene's x axis; the first corner is the origin.
    assert features[0]["geometry"]["coordinates"][0][0] == pytest.approx([0.0, 0.0], abs=1e-12)
    assert features[0]["geometry"]["coordinates"][0][2] == pytest.approx([1.0, -1.0])
    # Corners that were given clockwise are turned.
    assert all(area(one["geometry"]["coordinates"][0]) > 0 for one in features)
    assert "thickness_m" not in features[0]["properties"]


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("floe,x_m\na,1\n", "the columns are floe, x_m"),
        ("floe,x_m,y_m\na,0,0\na,1,1\n", ":2: floe a has no area"),
        ("floe,x_m,y_m,heading_deg,length_m,width_m\na,0,0,0,0,1\n", "above 0"),
        ("floe,x_m,y_m,heading_deg,length_m,width_m\na,0,0,0,1,1\nb,0.5,0,0,1,1\n",
         ":3: floe b is covered by floe a by 50 %"),
        ("floe,x_m,y_m,heading_deg,length_m,width_m\na,0,zero,0,1,1\n", "y_m is 'zero'"),
        ("floe,x_m,y_m,heading_deg,length_m,width_m,thickness_m\na,0,0,0,1,1,-1\n", "above 0"),
    ],
)  # fmt: skip
def test_faults_of_floes_are_told_with_their_line(tmp_path, text, message):
    file = tmp_path / "floes.csv"
    file.write_text(text)
    with pytest.raises(FloesError, match=message):
        floes_from_table(file, tmp_path / "field.geojson")


def test_floes_that_touch_or_overlap_by_a_reading_error_are_taken(tmp_path):
    file = tmp_path / "floes.csv"
    file.write_text(
        "floe,x_m,y_m,heading_deg,length_m,width_m\na,0,0,0,1,1\nb,1,0,0,1,1\nc,0,0.99,0,1,1\n"
    )
    assert floes_from_table(file, tmp_path / "field.geojson") == 3
