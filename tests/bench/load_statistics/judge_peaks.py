"""How statistics of the ice load change with step, contacts and tolerance: a CSV table of studies.

usage: judge_peaks.py STUDY_FOLDER...     the folders that `nilas study peaks-*.yaml` wrote

A row is a setting of a scene. `mean_change` and so on are the relative difference from the first
reference of the scene: the finest step with the same contacts, or for tolerances the tightest one.
Differences are taken between runs of the same ice; the interval is Student's over them. Columns
that end in `_falls` hold by how much a figure falls where steps are averaged in pairs, which a run
knows from itself (docs/theory/load-error.md#which-figures-to-use).
"""

import csv
import json
import re
import sys
from pathlib import Path

import numpy as np
import pandas as pd
from scipy import stats

from nilas.loads.series import LoadSeries, filtered

STATISTICS = ("mean", "p99", "filtered_peak", "raw_peak")


def main(folders):
    rows = [row for folder in folders for row in rows_of(Path(folder))]
    writer = csv.DictWriter(sys.stdout, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)


def rows_of(folder):
    table = pd.read_csv(folder / "study.csv")
    table = table[table.status == "done"]
    by_setting = {name: part.set_index("seed") for name, part in table.groupby("setting")}
    for part in by_setting.values():
        falls = [falls_in_pairs(folder / "runs" / run) for run in part.run]
        for statistic, values in zip(STATISTICS[1:], zip(*falls, strict=True), strict=True):
            part[f"{statistic}_falls"] = values
    for name in dict.fromkeys(table.setting):
        part, reference = by_setting[name], by_setting.get(reference_of(name, by_setting))
        row = {"scene": folder.name.removeprefix("peaks-"), "setting": name, "runs": len(part)}
        row["mean_N"] = f"{part['mean'].mean():.5g}"
        row["mean_scatter_percent"] = percent(part["mean"].std() / abs(part["mean"].mean()))
        for statistic in STATISTICS:
            change, interval = changes(part, reference, statistic)
            row[f"{statistic}_change_percent"] = percent(change)
            row[f"{statistic}_interval_percent"] = percent(interval)
        for statistic in STATISTICS[1:]:
            row[f"{statistic}_falls_percent"] = percent(part[f"{statistic}_falls"].median())
        yield row


def reference_of(name, settings):
    """The finest step with the same contacts; for a tolerance or a repetition the base step."""
    kind, step, rest = re.fullmatch(r"(rigid|elastic)_([\d.]+)ms(.*)", name).groups()
    if rest == "_again":
        return f"{kind}_{step}ms"
    if rest:
        tolerances = [one for one in settings if one.startswith(f"{kind}_{step}ms_") and "again" not in one]
        return min(tolerances, key=lambda one: float(one.rsplit("_", 1)[1]))
    steps = [one for one in settings if re.fullmatch(rf"{kind}_[\d.]+ms", one)]
    return min(steps, key=lambda one: float(one.removeprefix(f"{kind}_").removesuffix("ms")))


def changes(part, reference, statistic):
    """Mean relative difference between runs of the same ice, and its interval of 95 %."""
    shared = part.index.intersection(reference.index)
    change = part.loc[shared, statistic] / reference.loc[shared, statistic] - 1
    if len(change) < 2:
        return change.mean(), np.nan
    error = change.std() / np.sqrt(len(change))
    return change.mean(), stats.t.ppf(0.975, len(change) - 1) * error


def falls_in_pairs(run):
    """By how much 99th percentile, filtered peak and raw peak fall where steps are averaged in pairs."""
    summary = json.loads((run / "summary.json").read_text())
    window, width = summary["window"], summary["ice_load"]["peaks"]["filter_s"]
    table = pd.read_csv(run / "vessel.csv", usecols=["time_s", "ice_resistance_N"])
    inside = (table.time_s > window["from_s"] + 1e-9) & (table.time_s <= window["to_s"] + 1e-9)
    load = table.ice_resistance_N[inside].to_numpy()
    step = (window["to_s"] - window["from_s"]) / window["steps"]
    single = figures_of(LoadSeries(load, 0.0, step, width), width)
    pairs = 0.5 * (load[: len(load) // 2 * 2 : 2] + load[1::2])
    paired = figures_of(LoadSeries(pairs, 0.0, 2 * step, width), max(width, 2 * step))
    return 1 - paired / single


def figures_of(load, width):
    peak = np.abs(filtered(load, width)[1]).max()
    size = np.abs(load.values)
    return np.array([np.quantile(size, 0.99), peak, size.max()])


def percent(share):
    rounding = 1e-9
    return "" if np.isnan(share) else f"{100 * share:.2g}" if abs(share) > rounding else "0"


if __name__ == "__main__":
    main(sys.argv[1:])
