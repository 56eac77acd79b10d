"""Parquet holds the same table as CSV."""

import csv
import sys

import pytest

from nilas.study.results.tables import csv_text, write_parquet

HEADER = ["run", "point", "speed", "hull", "load", "note"]
ROWS = [
    ["a/seed-1", 1, 0.1, "slim", 1.0 / 3.0, ""],
    ["b/seed-1", 2, 2.0, "full, wide", None, 'says "no"'],
]


def test_numbers_and_texts_survive_csv():
    rows = list(csv.DictReader(csv_text(HEADER, ROWS).splitlines()))
    assert float(rows[0]["load"]) == 1.0 / 3.0 and rows[1]["load"] == ""
    assert rows[1]["hull"] == "full, wide" and rows[1]["note"] == 'says "no"'


def test_parquet_has_the_same_values_with_types(tmp_path):
    parquet = pytest.importorskip(
        "pyarrow.parquet", reason="pyarrow is not installed (pip install pyarrow)"
    )
    assert write_parquet(tmp_path / "study.parquet", HEADER, ROWS)
    table = parquet.read_table(tmp_path / "study.parquet")
    assert [list(row.values()) for row in table.to_pylist()] == ROWS
    types = {name: str(kind) for name, kind in zip(table.column_names, table.schema.types)}
    assert types["point"] == "int64" and types["load"] == "double" and types["hull"] == "string"


def test_without_pyarrow_no_parquet_is_written(tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "pyarrow", None)
    assert not write_parquet(tmp_path / "study.parquet", HEADER, ROWS)
    assert not list(tmp_path.iterdir())
