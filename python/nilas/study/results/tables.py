"""The tables of a study: study.csv with the results, points.csv, runs.csv, and Parquet."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Sequence
from pathlib import Path

from nilas.study.carry_out.record import write_whole
from nilas.study.describe.factor import number_text
from nilas.study.results.collected import Collected
from nilas.study.results.scatter import Scatter, scatter_of


def write_tables(collected: Collected) -> list[Path]:
    """Writes study.csv, points.csv and runs.csv, and study.parquet where pyarrow is installed.

    study.csv and points.csv hold nothing that depends on who ran the study: their bytes are the
    same on one machine, on a cluster, and for any number of runs at a time.
    """
    out = collected.plan.study.out
    header, rows = study_table(collected)
    write_whole(out / "study.csv", csv_text(header, rows))
    write_whole(out / "points.csv", csv_text(*points_table(collected)))
    write_whole(out / "runs.csv", csv_text(*runs_table(collected)))
    written = [out / "study.csv", out / "points.csv", out / "runs.csv"]
    parquet = out / "study.parquet"
    if write_parquet(parquet, header, rows):
        written.append(parquet)
    else:
        # One of an earlier session would be another table than study.csv.
        parquet.unlink(missing_ok=True)
    return written


def study_table(collected: Collected) -> tuple[list[str], list[list]]:
    """A row for each run: its point, values of the factors, seed, status and responses."""
    study = collected.plan.study
    header = [
        "run",
        "point",
        *(factor.name for factor in study.factors),
        "seed",
        "status",
        "exit_code",
        "message",
    ]
    header += [response.name for response in study.responses]
    rows = []
    for row in collected.rows:
        point = row.run.point
        levels = [level.label if level.number is None else level.number for level in point.levels]
        rows.append(
            [
                row.run.name,
                point.number,
                *levels,
                row.run.seed,
                row.status,
                row.exit_code,
                row.message,
                *row.values,
            ]
        )
    return header, rows


def points_table(collected: Collected) -> tuple[list[str], list[list]]:
    """A row for each point: how many runs it has, and mean and scatter of each response."""
    study = collected.plan.study
    header = ["point", *(factor.name for factor in study.factors), "runs", "failed"]
    for response in study.responses:
        header += [
            f"{response.name}_{part}" for part in ("mean", "std", "standard_error", "interval_95")
        ]
    values = [collected.values_of(place) for place in range(len(study.responses))]
    runs = {point.number: 0 for point in collected.plan.points}
    failed = dict(runs)
    for row in collected.rows:
        runs[row.run.point.number] += 1
        failed[row.run.point.number] += row.status != "done"
    rows = []
    for point in collected.plan.points:
        levels = [level.label if level.number is None else level.number for level in point.levels]
        cells: list = [point.number, *levels, runs[point.number], failed[point.number]]
        for of_points in values:
            cells += _cells(scatter_of(of_points[point.number]))
        rows.append(cells)
    return header, rows


def runs_table(collected: Collected) -> tuple[list[str], list[list]]:
    """A row for each run: how long it took, what it stored, and what made it."""
    times = ["wall_s", "processor_s", "begun", "ended", "files", "bytes"]
    made_by = [
        "machine",
        "processor",
        "program",
        "program_sha256",
        "scene_as_run_sha256",
        "resumed",
    ]
    rows = [
        [
            row.run.name,
            *(row.times.get(key) for key in times),
            *(row.made_by.get(key) for key in made_by),
        ]
        for row in collected.rows
    ]
    return ["run", *times, *made_by], rows


def csv_text(header: Sequence[str], rows: Sequence[Sequence]) -> str:
    """A table as CSV. Numbers have as many digits as it takes to read back the same bits."""
    stream = io.StringIO()
    writer = csv.writer(stream, lineterminator="\n")
    writer.writerow(header)
    writer.writerows([_cell(value) for value in row] for row in rows)
    return stream.getvalue()


def why_no_parquet() -> str:
    """Why Parquet cannot be written here, or nothing."""
    try:
        import pyarrow.parquet  # noqa: F401
    except ModuleNotFoundError:
        return "pyarrow is not installed (pip install pyarrow)"
    except ImportError as error:
        # Its newest versions want a newer NumPy than Debian has.
        return f"pyarrow does not work here: {error}"
    return ""


def write_parquet(file: Path, header: list[str], rows: list[list]) -> bool:
    """Writes the table as Parquet with typed columns. False where pyarrow is missing."""
    if why_no_parquet():
        return False
    import pyarrow
    import pyarrow.parquet

    columns = list(zip(*rows, strict=True)) if rows else [()] * len(header)
    arrays = [_array(pyarrow, column) for column in columns]
    other = file.with_name(file.name + ".part")
    pyarrow.parquet.write_table(pyarrow.table(arrays, names=header), other)
    other.replace(file)
    return True


def _array(pyarrow, column: Sequence):
    present = [value for value in column if value is not None]
    if present and all(isinstance(value, int) for value in present):
        return pyarrow.array(column, pyarrow.int64())
    if all(isinstance(value, int | float) for value in present):
        return pyarrow.array(
            [None if value is None else float(value) for value in column], pyarrow.float64()
        )
    return pyarrow.array(
        [None if value is None else _cell(value) for value in column], pyarrow.string()
    )


def _cells(scatter: Scatter) -> list[float | None]:
    numbers = [scatter.mean, scatter.deviation, scatter.standard_error, scatter.interval]
    return [number if math.isfinite(number) else None for number in numbers]


def _cell(value) -> str:
    if value is None:
        return ""
    return number_text(value) if isinstance(value, float) else str(value)
