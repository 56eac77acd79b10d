"""The page of all cases: verdicts in words, pictures, and where every number comes from."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import jinja2
from markupsafe import Markup

import nilas.study.results as study_results
from nilas.study.carry_out.record import write_whole
from nilas.study.words import duration
from nilas.validate.formulas import Formula
from nilas.validate.judge.simulated import CaseResult
from nilas.validate.judge.slopes import Slope
from nilas.validate.judge.verdicts import Row, Verdict
from nilas.validate.page.pictures import plot_factors, plot_points, plot_slopes

_MARKS_TEXT = (
    "Large marks: means with intervals of 95 %. Small marks: single runs. Lines: formulas inside "
    "of their range. Broken lines are those of formulas that are not judged."
)
# Classes of the style sheet by verdict.
_KINDS = {Verdict.WITHIN: "good", Verdict.OUTSIDE: "off"}


@dataclass(frozen=True)
class Judged:
    """A case with its comparisons."""

    result: CaseResult
    rows: tuple[Row, ...]
    slopes: tuple[Slope, ...]

    @property
    def all_rows(self) -> list[Row]:
        return [*self.rows, *(one.row for one in self.slopes)]


def write_page(file: Path, judged: Sequence[Judged], left_out: Sequence[str]) -> None:
    """Writes the page, which needs no other file and no network."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(Path(__file__).parent),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["number"] = number_text
    style = (Path(study_results.__file__).parent / "page.css").read_text(encoding="utf-8")
    own = (Path(__file__).parent / "page.css").read_text(encoding="utf-8")
    rows = [row for one in judged for row in one.all_rows]
    text = environment.get_template("page.html").render(
        style=Markup(style + own),
        headline=_headline(rows, left_out),
        cards=_cards(judged, rows),
        cases=[_section(one) for one in judged],
        left_out=left_out,
        formulas=_formulas(judged),
        made_by=_made_by(judged),
    )
    write_whole(file, text)


def number_text(value: float) -> str:
    """A number with as many digits as a reader needs.

    >>> number_text(15.4321), number_text(1234567.0), number_text(float("nan"))
    ('15.4', '1.23e+06', '')
    """
    return f"{value:.3g}" if math.isfinite(value) else ""


def _headline(rows: Sequence[Row], left_out: Sequence[str]) -> list[str]:
    counts = Counter(row.verdict for row in rows)
    judged = counts[Verdict.WITHIN] + counts[Verdict.OUTSIDE]
    sentences = [
        f"{counts[Verdict.WITHIN]} of {judged} comparisons that could be judged are within."
        if judged
        else "No comparison could be judged yet."
    ]
    others = [
        f"{counts[verdict]} {words}"
        for verdict, words in (
            (Verdict.OUT_OF_RANGE, "are outside of the range of their formula"),
            (Verdict.FEW, "have not enough runs"),
            (Verdict.UNJUDGED, "are shown and not judged"),
        )
        if counts[verdict]
    ]
    if others:
        sentences.append(f"Of the others, {', and '.join(others)}.")
    if left_out:
        sentences.append("The budget did not hold all runs; the end of this page says which.")
    return sentences


def _cards(judged: Sequence[Judged], rows: Sequence[Row]) -> list[tuple[str, str, str]]:
    counts = Counter(row.verdict for row in rows)
    runs = [row for one in judged for row in one.result.collected.rows]
    wall_s = sum(float(row.times.get("wall_s") or 0) for row in runs)
    return [
        ("cases", str(len(judged)), ""),
        ("runs", str(len(runs)), ""),
        ("runs failed", str(sum(row.status != "done" for row in runs)), ""),
        ("within", str(counts[Verdict.WITHIN]), ""),
        ("outside", str(counts[Verdict.OUTSIDE]), "bad" if counts[Verdict.OUTSIDE] else ""),
        ("time of all runs", duration(wall_s), ""),
    ]


def _section(one: Judged) -> dict:
    case = one.result.case
    figures = []
    for quantity in dict.fromkeys(row.quantity for row in one.rows):
        picture = plot_factors(one.result, quantity) if case.study.design.kind != "table" else None
        if picture:
            figures.append((picture, _MARKS_TEXT))
        of_quantity = [row for row in one.rows if row.quantity == quantity]
        measured = [row for row in of_quantity if row.reference.startswith("measured")]
        bars = plot_points(measured, f"{case.name}: measured") if measured else None
        if bars:
            figures.append((bars, "Marks: simulated. Bars: measured, with its interval."))
    picture = plot_slopes(one.slopes, case.name)
    if picture:
        figures.append((picture, "Slopes with intervals of 95 % by leaving out each seed. "
                        "Bands: from the smallest to the largest slope that counts."))  # fmt: skip
    return {
        "case": case,
        "sentences": _sentences(one),
        "figures": [{"svg": Markup(svg), "caption": caption} for svg, caption in figures],
        "rows": [_cells(row) for row in one.all_rows],
        "runs": len(one.result.collected.rows),
        "failed": [row for row in one.result.collected.rows if row.status != "done"][:20],
        "text": case.file.read_text(encoding="utf-8", errors="replace"),
    }


def _sentences(one: Judged) -> list[str]:
    """What the comparisons say, a sentence for each reference."""
    groups: dict[tuple[str, str], list[Row]] = {}
    for row in one.all_rows:
        is_slope = row.quantity.startswith("d ln")
        title = row.reference if not row.reference.startswith("same as") else "the base"
        title = "measured" if title.startswith("measured") else title
        groups.setdefault((row.quantity if not is_slope else "slopes", title), []).append(row)
    return [_sentence(quantity, title, rows) for (quantity, title), rows in groups.items()]


def _sentence(quantity: str, title: str, rows: Sequence[Row]) -> str:
    counts = Counter(row.verdict for row in rows)
    judged = counts[Verdict.WITHIN] + counts[Verdict.OUTSIDE]
    text = f"{quantity.replace('_', ' ').capitalize()} against {title}: "
    if judged:
        text += f"{counts[Verdict.WITHIN]} of {judged} within"
    else:
        text += "no verdict"
    apart = [row.ratio for row in rows if math.isfinite(row.ratio) and row.ratio > 0]
    if apart and not rows[0].quantity.startswith("d ln"):
        text += f", ratios {min(apart):.2f} to {max(apart):.2f}"
    rest = [
        f"{counts[verdict]} {verdict.value}"
        for verdict in (Verdict.OUT_OF_RANGE, Verdict.FEW, Verdict.UNJUDGED)
        if counts[verdict]
    ]
    return text + (f" ({', '.join(rest)})." if rest else ".")


def _cells(row: Row) -> dict:
    return {"row": row, "kind": _KINDS.get(row.verdict, "none"), "verdict": row.verdict.value}


def _formulas(judged: Sequence[Judged]) -> list[Formula]:
    used = [
        formula
        for one in judged
        for reference in (*one.result.case.references, *one.result.case.slopes)
        for formula in reference.formulas
    ]
    return list(dict.fromkeys(used))


def _made_by(judged: Sequence[Judged]) -> list[dict]:
    """Program, machine and number of runs, a line for each pair of both."""
    counts = Counter(
        (made["program"], made["program_sha256"][:12], made["machine"], made["processor"])
        for one in judged
        for made in (row.made_by for row in one.result.collected.rows)
    )
    names = ("program", "sha256", "machine", "processor")
    return [dict(zip(names, key, strict=True)) | {"runs": count} for key, count in counts.items()]
