"""How often intervals of return levels hold the true level: a CSV table of synthetic samples.

usage: judge_return_levels.py [SAMPLES]     default 300 for each row

Excesses follow a generalised Pareto distribution of known shape, and their number is Poisson's.
"""

import csv
import math
import sys

import numpy as np
from scipy import stats

from nilas.loads.tail import fit_tail

# Shape, mean number of events, and period over the observed time.
CASES = [(0.0, 20, 1), (0.0, 60, 1), (0.0, 60, 5), (0.2, 60, 3), (-0.2, 60, 3), (0.2, 150, 3)]


def main(samples):
    rows = [row_of(*case, samples) for case in CASES]
    writer = csv.DictWriter(sys.stdout, rows[0].keys(), lineterminator="\n")
    writer.writeheader()
    writer.writerows(rows)


def row_of(shape, events, periods, samples):
    random = np.random.default_rng(11)
    count = periods * events
    true = math.log(count) if shape == 0 else (count**shape - 1) / shape
    below = above = known = 0
    for _ in range(samples):
        excess = stats.genpareto.rvs(shape, size=random.poisson(events), random_state=random)
        found = fit_tail(excess, float(events), 10.0).return_level(float(count))
        if found.is_known:
            known += 1
            below += 10 + true < found.low
            above += 10 + true > found.high
    share = {name: f"{100 * number / known:.1f}" for name, number in (("below", below), ("above", above))}
    return {
        "shape": shape, "events": events, "periods": periods, "samples": samples,
        "covered_percent": f"{100 * (1 - (below + above) / known):.1f}",
        "below_percent": share["below"], "above_percent": share["above"],
        "refused_percent": f"{100 * (1 - known / samples):.1f}",
    }  # fmt: skip


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 300)
