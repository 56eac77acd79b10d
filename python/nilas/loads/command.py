"""The command line of load statistics: ``nilas statistics``."""

from __future__ import annotations

import argparse
import json
import math
import sys
import textwrap
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from nilas.errors import NilasError
from nilas.loads.ice_ahead import load_and_ice_ahead
from nilas.loads.peaks import LoadPeaks, load_peaks
from nilas.loads.series import CHANNEL
from nilas.loads.spectrum import load_spectrum
from nilas.results.folder import NoRun
from nilas.results.run import Run
from nilas.results.runs import runs as runs_of

_DONE = 0
_WRONG_INPUT = 2
_FILE = 4
# As the program has them at the end of a run.
_WIDTH, _INDENT = 80, 22


def main(arguments: Sequence[str] | None = None) -> int:
    """Prints the statistics of runs and returns the exit code.

    0: done. 2: an argument or a run does not fit. 4: a file could not be read or written.

    >>> main([str(example_folder), "--period", "10"])  # doctest: +ELLIPSIS
    peaks                 2 independent peaks above ...
    0
    """
    options = _parser().parse_args(arguments)
    try:
        members = _members(options.runs)
        found = _found(members, options)
        if options.out:
            _write(Path(options.out), found)
        print(json.dumps(_json(found), indent=1) if options.json else _text(found))
    except (NilasError, NoRun) as error:
        print(f"error: {error}", file=sys.stderr)
        return _WRONG_INPUT
    except OSError as error:
        print(f"error: {error.filename or ''}: {error.strerror}", file=sys.stderr)
        return _FILE
    return _DONE


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog="nilas statistics",
        description="Finds independent peaks of the ice load in one run or several, the load that"
        " returns in a given time with its interval, the spectrum, and how the load follows the ice"
        " ahead.",
    )
    parser.add_argument("runs", nargs="+", metavar="RUN", help="a run folder, or a folder of runs")
    parser.add_argument("--channel", default=CHANNEL, help="column of vessel.csv or structures.csv")
    parser.add_argument("--period", nargs="+", type=_positive, metavar="S",
                        help="return periods [s]; without it the length of a run and that of all runs")  # fmt: skip
    parser.add_argument("--filter", type=_positive, metavar="S",
                        help="averaging time of the load [s]; without it that of the runs")  # fmt: skip
    parser.add_argument("--threshold", type=float, metavar="N", help="threshold of peaks [N]")
    parser.add_argument("--statistics", type=_window, metavar="FROM:TO",
                        help="window [s]; without it that of each run")  # fmt: skip
    parser.add_argument("--out", metavar="FOLDER", help="writes tables as CSV into this folder")
    parser.add_argument("--json", action="store_true", help="prints JSON")
    return parser


def _members(folders: Sequence[str]) -> list[Run]:
    return [run for folder in folders for run in runs_of(folder)]


def _found(members: list[Run], options: argparse.Namespace) -> dict[str, Any]:
    """Peaks, levels, spectrum and correlations; where one cannot be had, the reason as a text."""
    peaks = load_peaks(
        members,
        options.channel,
        filter_s=options.filter,
        threshold=options.threshold,
        between=options.statistics,
    )
    periods = options.period or sorted({peaks.exposure_s / len(members), peaks.exposure_s})
    return {
        "runs": len(members),
        "peaks": peaks,
        "levels": [peaks.return_level(period) for period in periods],
        "spectrum": _or_reason(load_spectrum, members, options.channel, between=options.statistics),
        "ice_ahead": [_or_reason(load_and_ice_ahead, run, options.channel) for run in members],
    }


def _or_reason(function, *arguments, **named):
    try:
        return function(*arguments, **named)
    except (NilasError, NoRun) as error:
        return str(error)


def _text(found: dict[str, Any]) -> str:
    peaks: LoadPeaks = found["peaks"]
    lines = [_line("peaks", _peaks_text(peaks, found["runs"]))]
    for level in found["levels"]:
        title = f"  in {level.period_s:.4g} s"
        if level.is_known:
            text = f"{level.level:.4g} N is exceeded once on average; interval of 95 %: "
            text += f"{level.low:.4g} to {level.high:.4g} N. {level.reason}"
        else:
            text = f"not known. {level.reason}"
        lines.append(_line(title, text))
    lines += [_line("  doubt", remark) for remark in peaks.remarks]
    lines.append(_line("spectrum", _spectrum_text(found["spectrum"])))
    for text in dict.fromkeys(_ahead_text(one) for one in found["ice_ahead"]):
        lines.append(_line("ice ahead", text))
    return "\n".join(lines)


def _peaks_text(peaks: LoadPeaks, runs: int) -> str:
    share = "" if math.isnan(peaks.share) else f", the load's {100 * peaks.share:g} % level"
    text = f"{len(peaks.events)} independent peaks above {peaks.threshold:.4g} N{share}, in"
    text += f" {peaks.exposure_s:.4g} s of {runs} run{'s' if runs > 1 else ''}"
    text += f"; means over {peaks.filter_s:.2g} s"
    if len(peaks.events):
        text += f"; largest {peaks.events['peak'].max():.4g} N"
    if peaks.tail.has_shape:
        text += f"; tail of scale {peaks.tail.scale:.3g} N and shape {peaks.tail.shape:.2f}"
    return text + "."


def _spectrum_text(spectrum) -> str:
    if isinstance(spectrum, str):
        return spectrum
    width = spectrum.index[1]
    half = (spectrum["density"].cumsum() >= 0.5 * spectrum["density"].sum()).idxmax()
    freedom = spectrum.attrs["freedom"]
    return (
        f"Half of the variance lies below {half:.3g} Hz. The resolution is {width:.3g} Hz with"
        f" {freedom:.0f} degrees of freedom."
    )


def _ahead_text(found) -> str:
    if isinstance(found, str):
        return found
    best = found.table.loc[found.best_delay_s]
    return (
        f"The load follows the concentration ahead by {found.best_delay_s:.3g} s with a correlation of"
        f" {best.correlation:.2f}, interval of 95 % {best.low:.2f} to {best.high:.2f}."
        f" The series are worth {best.independent:.0f} independent pairs."
    )


def _line(title: str, text: str) -> str:
    """A line with its title, broken at the width of the program's other lines."""
    return textwrap.fill(
        text.strip(), _WIDTH, initial_indent=f"{title:<{_INDENT}}", subsequent_indent=" " * _INDENT
    )


def _json(found: dict[str, Any]) -> dict[str, Any]:
    peaks: LoadPeaks = found["peaks"]
    return {
        "runs": found["runs"],
        "peaks": {
            "count": len(peaks.events),
            "threshold_N": peaks.threshold,
            "filter_s": peaks.filter_s,
            "exposure_s": peaks.exposure_s,
            "scale_N": _number(peaks.tail.scale),
            "shape_1": peaks.tail.shape,
            "remarks": list(peaks.remarks),
        },
        "return_levels": [
            {
                "period_s": one.period_s,
                "level_N": _number(one.level),
                "low_N": _number(one.low),
                "high_N": _number(one.high),
                "reason": one.reason,
            }
            for one in found["levels"]
        ],
    }


def _number(value: float) -> float | None:
    return value if math.isfinite(value) else None


def _write(folder: Path, found: dict[str, Any]) -> None:
    folder.mkdir(parents=True, exist_ok=True)
    found["peaks"].events.to_csv(folder / "peaks.csv", index=False)
    rows = ["period_s,level_N,low_N,high_N,reason"]
    for one in found["levels"]:
        numbers = ["" if math.isnan(x) else f"{x:.10g}" for x in (one.level, one.low, one.high)]
        rows.append(f'{one.period_s:.10g},{",".join(numbers)},"{one.reason}"')
    (folder / "return-levels.csv").write_text("\n".join(rows) + "\n", encoding="utf-8")
    if not isinstance(found["spectrum"], str):
        found["spectrum"].to_csv(folder / "spectrum.csv")
    for number, one in enumerate(found["ice_ahead"]):
        if not isinstance(one, str):
            one.table.to_csv(folder / f"ice-ahead-{number}.csv")


def _positive(text: str) -> float:
    value = float(text)
    if not value > 0:
        raise argparse.ArgumentTypeError(f"'{text}' is not above 0")
    return value


def _window(text: str) -> tuple[float, float]:
    begin, _, end = text.partition(":")
    try:
        return float(begin), float(end)
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is not FROM:TO in seconds") from None
