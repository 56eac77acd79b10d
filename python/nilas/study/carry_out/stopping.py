"""The rule that decides how many seeds a point needs."""

from __future__ import annotations

import math
from collections.abc import Sequence

from nilas.study.describe.study import Seeds


def relative_error(values: Sequence[float]) -> float:
    """Standard error of the mean over the size of the mean; infinite below two values.

    >>> relative_error([1.0, 3.0])
    0.5
    """
    count = len(values)
    if count < 2:
        return math.inf
    mean = math.fsum(values) / count
    deviation = math.sqrt(math.fsum((value - mean) ** 2 for value in values) / (count - 1))
    if deviation == 0.0:
        return 0.0
    return math.inf if mean == 0.0 else deviation / math.sqrt(count) / abs(mean)


def seeds_wanted(seeds: Seeds, results: Sequence[float | None]) -> int:
    """How many seeds a point needs, from the results of its first seeds.

    ``results`` are in the order of the seeds; None is a run that failed. The answer is the first
    number of seeds that is enough, or the next number to try. It depends on the results alone,
    not on the order in which runs ended. So a study on a cluster makes the same runs as one on a
    laptop. Each round adds as many seeds as the scatter so far asks for, and at most doubles them.
    """
    count = seeds.count
    if seeds.until is None:
        return count
    while len(results) >= count and count < seeds.until.most:
        values = [value for value in results[:count] if value is not None]
        error = relative_error(values)
        if error <= seeds.until.relative_error:
            return count
        needed = count * (error / seeds.until.relative_error) ** 2
        more = count if math.isinf(needed) else math.ceil(needed) - count
        count = min(count + max(1, min(more, count)), seeds.until.most)
    return count
