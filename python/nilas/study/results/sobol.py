"""Sobol indices from the samples of Saltelli: which factor makes how much of the variance."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

_RESAMPLES = 500


@dataclass(frozen=True)
class SobolIndices:
    """``first``: share of a factor alone. ``total``: with all that it does together with others.
    The intervals are half widths of about 95 %, by resampling. ``samples``: base points used."""

    first: np.ndarray
    first_interval: np.ndarray
    total: np.ndarray
    total_interval: np.ndarray
    samples: int


def sobol_indices(values: Sequence[float | None], factors: int) -> SobolIndices | None:
    """Indices from values in the order of the design ``saltelli``; None is a point without value.

    First order by Saltelli et al. (2010, Computer Physics Communications 181, table 2 b), total
    by Jansen (1999). Base points with a missing value are left out. None where less than four are
    left, or nothing scatters.
    """
    rows = np.array([np.nan if value is None else value for value in values], dtype=float)
    blocks = rows.reshape(-1, factors + 2)
    blocks = blocks[np.isfinite(blocks).all(axis=1)]
    if len(blocks) < 4:
        return None
    found = _indices(blocks)
    if found is None:
        return None
    random = np.random.default_rng(1)
    tries = [
        _indices(blocks[random.integers(0, len(blocks), len(blocks))]) for _ in range(_RESAMPLES)
    ]
    kept = [one for one in tries if one is not None]
    spread = np.std(np.array(kept), axis=0) * 1.96
    return SobolIndices(found[0], spread[0], found[1], spread[1], len(blocks))


def _indices(blocks: np.ndarray) -> np.ndarray | None:
    first, mixed, last = blocks[:, 0], blocks[:, 1:-1], blocks[:, -1]
    both = np.concatenate([first, last])
    variance = both.var()
    if variance == 0.0:
        return None
    # The mean is taken off first, which keeps the estimate of first order from scattering.
    centre = both.mean()
    alone = ((last - centre)[:, None] * (mixed - first[:, None])).mean(axis=0) / variance
    total = ((first[:, None] - mixed) ** 2).mean(axis=0) / (2 * variance)
    return np.array([alone, total])
