"""What must hold of the tables of a long run. They are read row by row, since they are long."""
import csv
import json
import math
from collections import Counter
from dataclasses import dataclass
from itertools import zip_longest
from pathlib import Path
from typing import Callable, Iterator

# Rounding of sums over many steps, as a share of the largest term.
ROUNDING = 1e-9
TABLES = ("steps", "vessel", "events", "bodies")
# What the summary makes of the numbers of all steps.
STATISTICS = ("window", "loads", "ice_load", "tow_force", "load_error", "structures")


@dataclass
class Verdict:
    """Figures of a run, and what does not hold."""

    figures: dict[str, object]
    faults: list[str]


def _rows(path: Path) -> Iterator[dict[str, str]]:
    with path.open(newline="", encoding="utf-8") as file:
        yield from csv.DictReader(file)


def judge_rows(folder: Path, steps: int, time_after: Callable[[int], float]) -> Verdict:
    """Counts, times and accounts of a run of so many steps."""
    faults: list[str] = []
    statuses: Counter[str] = Counter()
    drift, energy, scale, momentum, most_contacts, most_floes, count = 0.0, 0.0, 0.0, 0.0, 0, 0, 0
    for count, row in enumerate(_rows(folder / "steps.csv"), 1):
        statuses[row["status"]] += 1
        drift = max(drift, abs(float(row["time_s"]) - time_after(count)))
        energy = max(energy, abs(float(row["imbalance_J"])))
        scale = max(scale, *(abs(float(value)) for name, value in row.items()
                             if name.endswith("_J") and name not in ("imbalance_J", "complementarity_J",
                                                                     "bipotential_J")))
        of, off = float(row["momentum_scale_Ns"]), float(row["momentum_imbalance_Ns"])
        momentum = max(momentum, off / of if of > 0 else 0.0 if off == 0 else math.inf)
        most_contacts, most_floes = max(most_contacts, int(row["contacts"])), max(most_floes, int(row["floes"]))
    summary = json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    in_vessel = sum(1 for _ in _rows(folder / "vessel.csv"))
    for what, found in (("steps.csv", count), ("vessel.csv", in_vessel), ("summary.json", summary["steps"])):
        if found != steps:
            faults.append(f"{what} has {found} steps instead of {steps}")
    if drift != 0:
        faults.append(f"a time is off by {drift:.3g} s")
    if not energy <= ROUNDING * scale:
        faults.append(f"the energy ledger is off by {energy:.3g} J, its largest term is {scale:.3g} J")
    if not momentum <= ROUNDING:
        faults.append(f"the momentum balance is off by {momentum:.3g} of its scale")
    short = count - statuses["converged"]
    if summary["shortfalls"]["unconverged_steps"] != short:
        faults.append(f"the summary counts {summary['shortfalls']['unconverged_steps']} steps short of the tolerance, "
                      f"the table {short}")
    return Verdict({"simulated_s": time_after(steps), "most_contacts": most_contacts, "most_floes": most_floes,
                    "short_steps": short, "time_drift_s": drift,
                    "energy_share_1": f"{energy / scale if scale else 0:.2g}", "momentum_share_1": f"{momentum:.2g}"},
                   faults)


def same_bits(one: Path, other: Path) -> str:
    """What differs first in the tables of two runs, wall times left out, or in their statistics; or nothing."""
    for name in TABLES:
        paths = [folder / f"{name}.csv" for folder in (one, other)]
        if not any(path.exists() for path in paths):
            continue
        for number, (a, b) in enumerate(zip_longest(*map(_rows, paths)), 1):
            if a is None or b is None:
                return f"{name}.csv of one run ends at row {number}"
            differing = [key for key in a if a[key] != b.get(key) and not key.startswith("ms_")]
            if differing:
                return f"{name}.csv, row {number}: {differing[0]} is {b.get(differing[0])} instead of {a[differing[0]]}"
    first, second = (json.loads((folder / "summary.json").read_text(encoding="utf-8")) for folder in (one, other))
    other_statistics = [key for key in STATISTICS if first.get(key) != second.get(key)]
    return f"summary.json: {', '.join(other_statistics)} differ" if other_statistics else ""
