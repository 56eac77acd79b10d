"""Whether the stated error of mean loads holds: a CSV table of studies.

usage: judge_coverage.py STUDY_FOLDER...     the folders that `nilas study coverage-*.yaml` wrote

The truth of a field is the mean over all runs of its settings `finest` and `fine`. A run is
covered where its interval holds the truth. The width is the median of the stated half width over
1.96 times the root mean square of the actual errors, of the runs of the same group and field. The
ratio is the median of the stated half width over the actual error. Shares in per cent are those of
the field's mean horizontal load. Runs that said "at least" are counted apart.
"""

import csv
import sys
from pathlib import Path

import numpy as np
import pandas as pd

TRUTH = ("finest", "fine")
SIDES = ("along", "across")


def main(folders):
    runs = pd.concat([judged(Path(folder)) for folder in folders], ignore_index=True)
    rows = [row_of(*group) for group in groups_of(runs)]
    writer = csv.DictWriter(sys.stdout, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)


def judged(folder):
    """A row per judged run and direction: its error, what it stated, and the scatter of the truth."""
    table = pd.read_csv(folder / "study.csv")
    table = table[table.status == "done"]
    rows = []
    for field, part in table.groupby("field"):
        fine = part[part.setting.isin(TRUTH)]
        size = np.hypot(fine.along.mean(), fine.across.mean())
        for side in SIDES:
            for _, run in part[~part.setting.isin(TRUTH)].iterrows():
                rows.append(
                    {
                        "scene": folder.name.removeprefix("coverage-"),
                        "field": field,
                        "setting": run.setting,
                        "side": side,
                        "truth": fine[side].mean(),
                        "scatter": fine[side].std(),
                        "size": size,
                        "error": run[side] - fine[side].mean(),
                        "stated": run[f"{side}_stated"],
                        "at_least": bool(run.at_least) or bool(run.law_at_least),
                    }
                )
    return pd.DataFrame(rows)


def groups_of(runs):
    """Runs by scene and by setting, those that state a whole interval apart from lower bounds."""
    for scene, part in runs.groupby("scene", sort=False):
        for claim, one in part.groupby("at_least"):
            yield scene, claim, one
    for setting, part in runs.groupby("setting", sort=False):
        for claim, one in part.groupby("at_least"):
            yield f"setting {setting}", claim, one
    for claim, part in runs.groupby("at_least"):
        yield "all", claim, part


def row_of(name, claim, part):
    row = {"group": name, "stated_as": "at least" if claim else "+-"}
    row |= {"fields": part.field.nunique(), "runs": int((part.side == "along").sum())}
    for side in SIDES:
        one = part[part.side == side]
        held = one.error.abs() <= one.stated
        rms = one.groupby("field").error.transform(lambda e: np.sqrt((e**2).mean()))
        row |= {
            f"{side}_covered_percent": f"{100 * held.mean():.0f}",
            f"{side}_width": f"{(one.stated / (1.96 * rms)).median():.2g}",
            f"{side}_ratio": f"{(one.stated / one.error.abs()).median():.2g}",
            f"{side}_stated_percent": f"{100 * (one.stated / one['size']).median():.2g}",
            f"{side}_error_percent": f"{100 * (rms / one['size']).median():.2g}",
            f"{side}_truth_percent": f"{100 * (one.scatter / one['size']).median():.2g}",
        }
    return row


if __name__ == "__main__":
    main(sys.argv[1:])
