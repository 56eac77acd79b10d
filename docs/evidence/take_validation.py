#!/usr/bin/env python3
"""Writes what `nilas validate` found into data/, for the tables of validation-results.md.

usage: take_validation.py FOLDER --revision REVISION --date DATE [--machine TEXT]

FOLDER is the --out of the command. A file of data/ holds a group of cases, those of them that FOLDER has runs of. It
leaves out comparisons that get no verdict, which the command's own page shows.
"""
import argparse
import csv
import pathlib

HERE = pathlib.Path(__file__).resolve().parent

GROUPS = {
    "validate-structures": ["drift-limit", "caisson", "crushing-area", "caisson-broken", "cone", "cone-broken"],
    "validate-scales": ["scale-pack", "scale-breaking"],
    "validate-presawn": ["presawn", "presawn-drift"],
    "validate-pack": ["pack-slender", "pack-blunt", "pack-full"],
    "validate-level": ["level-ice"],
}
COLUMNS = ["case", "point", "quantity", "simulated", "interval", "unit", "runs", "reference", "range", "ratio", "verdict"]
# Names that are too long for a column.
SHORT = {
    "the least of Driving force of a current and Compressive strength over the whole face": "driving force or strength",
    "Compressive strength over the whole face": "strength times face",
    "Driving force of a current": "driving force",
    "Pressure that falls with the area": "law of the scene",
    "ISO 19906, crushing on a vertical face": "ISO 19906",
    "Croasdale without rubble to Croasdale": "Croasdale, bare to full",
    "outside by more than its error": "outside",
}
ROUNDING = 1e-12
UNITS = ((1e6, "MN"), (1e4, "kN"))


def scale_of(row):
    """What the numbers of a row are divided by, and their unit."""
    if row["unit"] != "N":
        return 1, {"1": ""}.get(row["unit"], row["unit"])
    size = max(abs(float(row[name] or 0)) for name in ("simulated", "reference_high"))
    for scale, unit in UNITS:
        if size >= scale:
            return scale if unit == "MN" else 1e3, unit
    return 1, "N"


def no_rounding(number):
    """The number, or 0 where it is only what rounding left of a slope of 0."""
    return number if abs(number) > ROUNDING else 0


def short(text):
    bound = "at most " if text.startswith("at most ") else ""
    rest = text.removeprefix(bound)
    return bound + SHORT.get(rest, rest)


def shown(row):
    """The row of data/ for a row of validation.csv."""
    scale, unit = scale_of(row)

    def number(name, digits=6):
        return f"{no_rounding(float(row[name])) / scale:.{digits}g}" if row[name] else ""

    ends = [end for end in (number("reference_low", 3), number("reference_high", 3)) if end]
    return {
        "case": row["case"], "point": row["point"], "quantity": row["quantity"], "unit": unit, "runs": row["runs"],
        "simulated": number("simulated"), "interval": number("interval_95"), "reference": short(row["reference"]),
        "range": " to ".join(dict.fromkeys(ends)), "ratio": row["ratio"], "verdict": short(row["verdict"]),
    }  # fmt: skip


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("folder", type=pathlib.Path)
    for name in ("revision", "date"):
        parser.add_argument(f"--{name}", required=True)
    parser.add_argument("--machine", default="a shared machine with 2 cores, which was busy")
    given = parser.parse_args()
    with open(given.folder / "validation.csv", newline="", encoding="utf-8") as file:
        found = [row for row in csv.DictReader(file) if row["simulated"] and row["verdict"] != "not judged"]
    for name, cases in GROUPS.items():
        rows = [shown(row) for row in found if row["case"] in cases]
        if not rows:
            continue
        with open(HERE / "data" / f"{name}.csv", "w", newline="", encoding="utf-8") as file:
            there = [case for case in cases if any(row["case"] == case for row in rows)]
            file.write(f"# command: `nilas validate {' '.join(there)}`\n# revision: {given.revision}\n")
            file.write(f"# date: {given.date}\n# machine: {given.machine}\n")
            file.write("# note: The ± is the half width of the interval of 95 %.\n")
            table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
            table.writeheader()
            table.writerows(rows)


if __name__ == "__main__":
    main()
