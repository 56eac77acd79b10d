"""Power spectrum of a load over one run or several, with its interval."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
import pandas as pd
from scipy import signal, stats

from nilas.errors import InputError
from nilas.loads.series import CHANNEL, LoadSeries, load_series
from nilas.results.run import Run

_LEAST_SEGMENTS = 8
_LEAST_LENGTH = 16


def load_spectrum(
    runs: Run | Sequence[Run],
    channel: str = CHANNEL,
    *,
    between: tuple[float, float] | None = None,
) -> pd.DataFrame:
    """Spectral density of a load by frequency [Hz], with its interval of 95 % [N^2/Hz].

    Several runs are averaged, each with its own mean deducted. They need the same time step.

    >>> spectrum = load_spectrum(example_run)
    Traceback (most recent call last):
    nilas.errors.InputError: A spectrum needs 72 steps in the window, and there are 29.
    """
    members = [runs] if isinstance(runs, Run) else list(runs)
    return spectrum_of_series([load_series(run, channel, between) for run in members])


def spectrum_of_series(loads: Sequence[LoadSeries]) -> pd.DataFrame:
    """The same from series of a load: columns ``density``, ``low`` and ``high``.

    ``attrs["freedom"]``: degrees of freedom of the estimate.

    >>> spectrum = spectrum_of_series([example_load])
    >>> variance = spectrum.density.sum() * spectrum.index[1]
    >>> bool(abs(variance / example_load.values.var() - 1) < 0.05)
    True
    """
    if not loads:
        raise InputError("There is no load whose spectrum could be found.")
    step = loads[0].step
    if any(abs(one.step - step) > 1e-9 * step for one in loads):
        raise InputError("The runs have different time steps, so they have no common spectrum.")
    shortest = min(len(one.values) for one in loads)
    least = _LEAST_LENGTH * (_LEAST_SEGMENTS + 1) // 2
    if shortest < least:
        raise InputError(f"A spectrum needs {least} steps in the window, and there are {shortest}.")
    length = _LEAST_LENGTH
    while (_LEAST_SEGMENTS + 1) * length <= shortest:
        length *= 2
    densities, segments = [], []
    for one in loads:
        frequency, density = signal.welch(
            one.values - one.values.mean(), 1 / step, window="hann", nperseg=length,
            noverlap=length // 2, detrend=False,
        )  # fmt: skip
        densities.append(density)
        segments.append(2 * len(one.values) // length - 1)
    weights = np.array(segments) / sum(segments)
    mean = weights @ np.array(densities)
    freedom = sum(2 * count / (1 + (1 - 1 / count) / 18) for count in segments)
    low, high = (freedom / stats.chi2.ppf(q, freedom) for q in (0.975, 0.025))
    frame = pd.DataFrame(
        {"density": mean, "low": low * mean, "high": high * mean},
        index=pd.Index(frequency, name="frequency_Hz"),
    )
    frame.attrs["freedom"] = freedom
    return frame
