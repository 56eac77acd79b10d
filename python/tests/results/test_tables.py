"""Tables are read as they stand, with units, in windows of time, and while they grow."""

from __future__ import annotations

import csv
import json
from pathlib import Path

import numpy as np
import pandas as pd
import pytest

import nilas
from nilas.results.tables import column_names
from nilas.results.units import unit_of


def rows_by_hand(file: Path) -> list[dict[str, str]]:
    with file.open(newline="") as stream:
        return list(csv.DictReader(stream))


@pytest.mark.parametrize("name", ["vessel", "steps", "bodies"])
def test_numbers_have_the_bits_of_the_file(small_run: nilas.Run, name: str) -> None:
    """Python's float() rounds correctly, so it has the bits that the program wrote."""
    frame = small_run.table(name).reset_index()
    rows = rows_by_hand(small_run.folder / f"{name}.csv")
    assert len(frame) == len(rows)
    for column in rows[0]:
        texts = [row[column] for row in rows]
        if not pd.api.types.is_numeric_dtype(frame[column]):
            assert list(frame[column]) == texts
        else:
            expected = np.array([float(text) for text in texts])
            assert np.array_equal(frame[column].to_numpy(dtype=float), expected, equal_nan=True)


def test_hashes_stay_texts(own_folder: Path) -> None:
    """A hash of decimal digits alone would else become a number and lose its zeros."""
    file = own_folder / "steps.csv"
    lines = file.read_text().splitlines()
    place = lines[0].split(",").index("state_hash")
    cells = lines[1].split(",")
    cells[place] = "0012345678901234"
    file.write_text("\n".join([lines[0], ",".join(cells)]) + "\n")
    assert nilas.Run(own_folder).steps.state_hash.iloc[0] == "0012345678901234"


def test_time_is_the_index_and_windows_include_both_ends(small_run: nilas.Run) -> None:
    times = small_run.steps.index
    some = small_run.table("steps", between=(times[9], times[19]))
    assert list(some.index) == list(times[9:20])


def test_columns_keep_the_order_asked_for(small_run: nilas.Run) -> None:
    some = small_run.table("vessel", columns=["z_m", "x_m"])
    assert list(some.columns) == ["z_m", "x_m"]
    assert some.attrs["units"] == {"time_s": "s", "z_m": "m", "x_m": "m"}


def test_unknown_columns_and_tables_are_named(small_run: nilas.Run) -> None:
    with pytest.raises(nilas.UnknownName, match=r"no column 'speed_m_s'; "):
        small_run.table("vessel", columns=["speed_m_s"])
    with pytest.raises(nilas.UnknownName, match="no table 'vessels'; did you mean vessel"):
        small_run.table("vessels")
    with pytest.raises(nilas.InputError, match=r"columns=\['x_m'\]"):
        small_run.table("vessel", columns="x_m")
    with pytest.raises(nilas.NoRun, match="no events.csv; runs where floes can break have it"):
        _ = small_run.events


def test_every_column_of_the_run_has_its_unit(small_run: nilas.Run) -> None:
    """Names without a unit are texts. All others are numbers, and have one."""
    texts = {"status", "state_hash", "name", "kind", "pieces"}
    for table in small_run.tables:
        units = small_run.units(table)
        assert {name for name, unit in units.items() if not unit} <= texts


@pytest.mark.parametrize(
    ("name", "unit"),
    [
        ("contact_fx_N", "N"),
        ("contact_mx_Nm", "N m"),
        ("angular_momentum_scale_Nms", "N m s"),
        ("momentum_sqrtJ", "sqrt(J)"),
        ("cell1_tared_N", "N"),
        ("roll_rate_deg_s", "deg/s"),
        ("wx_rad_s", "rad/s"),
        ("propeller_rate_1_s", "1/s"),
        ("thruster_bow_saturation_1", "1"),
        ("inertia_kg_m2", "kg m^2"),
        ("ms_solver", "ms"),
        ("qw", "1"),
        ("state_hash", ""),
    ],
)
def test_units_follow_from_the_names(name: str, unit: str) -> None:
    assert unit_of(name) == unit


def test_half_a_row_of_a_growing_file_is_left_out(own_folder: Path) -> None:
    file = own_folder / "vessel.csv"
    content = file.read_bytes()
    whole = content.count(b"\n") - 1
    run = nilas.Run(own_folder)
    assert len(run.vessel) == whole
    last = content.rstrip(b"\n").rfind(b"\n")
    file.write_bytes(content[: last + 30])
    assert len(run.vessel) == whole - 1
    file.write_bytes(content)
    assert len(run.vessel) == whole


def test_a_file_of_half_a_header_has_no_rows_yet(own_folder: Path) -> None:
    (own_folder / "vessel.csv").write_text("time_s,contact_fx")
    with pytest.raises(nilas.NoRun, match="no whole row yet"):
        _ = nilas.Run(own_folder).vessel
    (own_folder / "vessel.csv").write_text("time_s,contact_fx_N\n")
    assert len(nilas.Run(own_folder).vessel) == 0


def test_events_read_lists_of_pieces_as_texts(own_folder: Path) -> None:
    (own_folder / "events.csv").write_text(
        "time_s,kind,floe_id,x_m,y_m,z_m,energy_J,length_m,pieces,radius_m,load_ratio,brash_kg,"
        "extruded_kg\n0.1,bending,3,1,2,0,0.5,2,17;18,1.5,1.01,0,0\n0.2,crushing,4,1,2,0,0,0,,0,1,0,2\n"
    )
    events = nilas.Run(own_folder).events
    assert list(events.pieces) == ["17;18", ""]
    assert events.attrs["units"]["energy_J"] == "J"
    assert events.attrs["units"]["load_ratio"] == "1"


def test_names_that_are_numbers_or_nan_stay_names(own_folder: Path) -> None:
    (own_folder / "bodies.csv").write_text(
        ",".join(column_names(own_folder / "bodies.csv"))
        + "\n0,1,nan,0,0,0,1,0,0,0,0,0,0,0,0,0\n0,2,007,1,0,0,1,0,0,0,nan,0,0,0,0,0\n"
    )
    bodies = nilas.Run(own_folder).table("bodies")
    assert list(bodies.name) == ["nan", "007"]
    assert np.isnan(bodies.vx_m_s[1])


def test_datasets_have_units(small_run: nilas.Run) -> None:
    pytest.importorskip("xarray", reason="needs xarray (python3-xarray of Debian)")
    data = small_run.dataset("vessel", columns=["yaw_deg", "vx_m_s"])
    assert data.sizes == {"time_s": len(small_run.vessel)}
    assert data.yaw_deg.attrs == {"units": "deg"}
    assert data.time_s.attrs == {"units": "s"}
    assert np.array_equal(data.vx_m_s.values, small_run.vessel.vx_m_s.to_numpy())


def test_statistics_are_those_of_the_program(small_run: nilas.Run) -> None:
    """Means over the window can be taken again from the table, as the outputs page says."""
    start, end = small_run.window
    vessel = small_run.vessel
    window = vessel[(vessel.index > start + 1e-9) & (vessel.index <= end + 1e-9)]
    loads = small_run.loads
    for channel in ("ice_resistance_N", "contact_fz_N", "hydro_fx_N"):
        scale = window[channel].abs().max()
        assert loads.loc[channel, "mean"] == pytest.approx(window[channel].mean(), abs=1e-9 * scale)
        assert loads.loc[channel, "max"] == pytest.approx(window[channel].abs().max(), rel=1e-9)
    figures = json.loads((small_run.folder / "summary.json").read_text())
    assert loads.loc["hull_fx_N", "std"] == figures["loads"]["hull_fx_N"]["std"]
    assert small_run.figures["ice_load.along.mean_N"] == figures["ice_load"]["along"]["mean_N"]


def test_a_table_is_read_again_only_when_its_file_changed(small_run: nilas.Run) -> None:
    assert small_run.vessel is small_run.vessel
    assert isinstance(small_run.vessel, pd.DataFrame)
