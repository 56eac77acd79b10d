"""validation.csv: all comparisons of all cases in one table."""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path

from nilas.study.carry_out.record import write_whole
from nilas.study.results.tables import csv_text
from nilas.validate.judge.verdicts import Row

HEADER = (
    "case", "point", "quantity", "unit", "simulated", "interval_95", "runs", "interval_from",
    "reference", "reference_value", "reference_low", "reference_high", "ratio", "verdict",
    "source", "remark",
)  # fmt: skip


def write_table(file: Path, rows: Iterable[Row]) -> None:
    """Writes the table. Cells of numbers that are not known are empty."""
    write_whole(file, csv_text(HEADER, [_cells(row) for row in rows]))


def _cells(row: Row) -> list:
    simulated = row.simulated
    return [
        row.case,
        row.point,
        row.quantity,
        row.unit,
        _number(simulated.mean),
        _number(simulated.interval),
        simulated.runs,
        simulated.by,
        row.reference,
        _number(row.value),
        _number(row.low),
        _number(row.high),
        _number(row.ratio),
        row.verdict.value,
        row.source,
        row.remark,
    ]


def _number(value: float) -> float | None:
    """Six digits: more would say more than is known."""
    return float(f"{value:.6g}") if math.isfinite(value) else None
