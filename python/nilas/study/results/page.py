"""Writes study.html, the page that shows a study. It needs no other file and no network."""

from __future__ import annotations

import math
from pathlib import Path

import jinja2
from markupsafe import Markup

from nilas.study.carry_out.record import write_whole
from nilas.study.results.anova import Anova
from nilas.study.results.bars import plot_seeds, plot_shares, plot_slopes, plot_sobol
from nilas.study.results.collected import Collected
from nilas.study.results.drawing import own_style
from nilas.study.results.findings import findings, headline, with_interval
from nilas.study.results.plots import plot_curves, plot_levels, plot_map
from nilas.study.results.response_data import ResponseData, response_data
from nilas.study.results.scatter import scatter_of
from nilas.study.words import duration, size

# More rows than this make a page slow; points.csv and study.csv have them all.
_MOST_ROWS = 500
_MOST_FAILURES = 100


def write_page(collected: Collected) -> Path:
    """Writes the page of all finished runs, and returns its path."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(Path(__file__).parent),
        autoescape=True,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    study = collected.plan.study
    data = [response_data(collected, place) for place in range(len(study.responses))]
    with own_style():
        sections = [_section(one) for one in data]
    text = environment.get_template("page.html").render(
        style=Markup((Path(__file__).parent / "page.css").read_text(encoding="utf-8")),
        study=study,
        headline=headline(collected),
        cards=_cards(collected),
        responses=sections,
        points=_points(collected),
        points_left_out=max(len(collected.plan.points) - _MOST_ROWS, 0),
        failed=collected.failed[:_MOST_FAILURES],
        failed_left_out=max(len(collected.failed) - _MOST_FAILURES, 0),
        made_by=_made_by(collected),
        study_text=study.file.read_text(encoding="utf-8", errors="replace"),
    )
    file = study.out / "study.html"
    write_whole(file, text)
    return file


def _section(data: ResponseData) -> dict:
    """Title, sentences and figures of one response."""
    anova, slopes, sobol = data.anova(), data.slopes(), data.sobol()
    until = data.collected.plan.study.seeds.until
    bound = until.relative_error if until and until.response == data.response.name else None
    figures = []
    if data.rows and data.factors:
        figures += _main_figures(data, anova)
        if anova:
            figures.append((plot_shares(data, anova), _shares_caption(anova), "wide"))
        if sobol:
            figures.append(
                (
                    plot_sobol(data, sobol),
                    f"Sobol indices from {sobol.samples} base points, with intervals of "
                    f"about 95 % by resampling.",
                    "",
                )
            )
        if slopes:
            text = (
                f"How many standard deviations the response moves with one of the factor, "
                f"with intervals of 95 %. "
                f"Grey: not to be told from zero. Straight lines explain "
                f"{100 * slopes.explained:.0f} % of the scatter."
            )
            figures.append((plot_slopes(data, slopes), text, ""))
    seeds = plot_seeds(data, bound) if data.rows else None
    if seeds:
        text = "How well each mean is known. " + (
            "Orange: above the bound of the study. " if bound else ""
        )
        figures.append(
            (seeds, text + "More seeds make it smaller, as one over the root of their number.", "")
        )
    return {
        "name": data.response.name,
        "title": data.response.title,
        "source": data.response.channel
        or f"{data.response.statistic} of {data.response.column} in {data.response.table}",
        "findings": findings(data, anova, slopes, sobol),
        "figures": [
            {"svg": Markup(svg), "caption": caption, "kind": kind} for svg, caption, kind in figures
        ],
    }


def _main_figures(data: ResponseData, anova: Anova | None) -> list[tuple[str, str, str]]:
    """The response over the factors, in the form that suits the design."""
    kind = data.collected.plan.study.design.kind
    by_levels = kind == "full" or len(data.factors) == 1 and data.factors[0].levels
    if not by_levels:
        surface = data.surface()
        caption = "Each mark is a run; point at it for its values, click it for its folder."
        if surface:
            degree = "second" if surface.order == 2 else "first"
            caption += (
                f" Lines: polynomial of {degree} order through all runs, with the other "
                f"factors at the middle of "
                f"their range, and the band of 95 % of its mean. It explains "
                f"{100 * surface.explained:.0f} % of the scatter."
            )
        return [(plot_curves(data), caption, "wide")]
    order = _order(data, anova)
    caption = (
        "Small marks: runs; point at one for its values, click it for its folder. "
        "Large marks: means."
    )
    if len(data.collected.plan.study.seeds.chosen) > 1 or data.collected.plan.study.seeds.count > 1:
        caption += " Bands: intervals of 95 % of the mean."
    if len(order) > 2:
        others = ", ".join(data.factors[k].name for k in order[2:])
        caption += f" Means and bands are over {others} too."
    figures = [(plot_levels(data, order), caption, "")]
    picture = plot_map(data, order) if len(order) > 1 else None
    if picture:
        figures.append((picture, "Means of the same runs.", ""))
    return figures


def _order(data: ResponseData, anova: Anova | None) -> list[int]:
    """The factors, the one for the axis first: a number with much effect and many levels."""
    shares = (
        {effect.factors[0]: effect.share for effect in anova.effects if len(effect.factors) == 1}
        if anova
        else {}
    )

    def rank(number: int) -> tuple:
        factor = data.factors[number]
        return (
            not factor.is_numeric,
            -min(len(factor.levels), 3),
            -shares.get(number, 0.0),
            number,
        )

    return sorted(
        (k for k in range(len(data.factors)) if len(data.factors[k].levels) > 1), key=rank
    ) or [0]


def _shares_caption(anova: Anova) -> str:
    if anova.seeds == 1:
        return (
            "Analysis of variance: shares of the sum of squares. With one seed a point, "
            "chance is part of the last share."
        )
    return f"Analysis of variance with {anova.seeds} seeds a point: shares of the sum of squares."


def _cards(collected: Collected) -> list[tuple[str, str]]:
    """The figures at the top of the page."""
    rows = collected.rows
    wall_s = sum(float(row.times.get("wall_s") or 0) for row in rows)
    processor_s = sum(float(row.times.get("processor_s") or 0) for row in rows)
    stored = sum(float(row.times.get("bytes") or 0) for row in rows)
    cards = [
        ("points", str(len(collected.plan.points))),
        ("runs done", str(len(rows) - len(collected.failed))),
        ("failed", str(len(collected.failed))),
        ("missing", str(collected.missing)),
        ("time of all runs", duration(wall_s)),
        ("processor time", duration(processor_s)),
    ]
    if stored:
        cards.append(("written", size(stored)))
    return cards


def _points(collected: Collected) -> list[dict]:
    """The table of points."""
    values = [collected.values_of(place) for place in range(len(collected.plan.study.responses))]
    rows = []
    for point in collected.plan.points[:_MOST_ROWS]:
        cells = []
        for of_points in values:
            scatter = scatter_of(of_points[point.number])
            cells.append(
                (with_interval(scatter), scatter.mean)
                if math.isfinite(scatter.mean)
                else ("", -math.inf)
            )
        rows.append(
            {"point": point, "cells": cells, "runs": len(values[0][point.number]) if values else 0}
        )
    return rows


def _made_by(collected: Collected) -> list[dict]:
    """Program, machine and number of runs, a line for each pair of both."""
    groups: dict[tuple, int] = {}
    for row in collected.rows:
        made = row.made_by
        key = (made["program"], made["program_sha256"][:12], made["machine"], made["processor"])
        groups[key] = groups.get(key, 0) + 1
    names = ("program", "sha256", "machine", "processor")
    return [
        dict(zip(names, key, strict=True)) | {"runs": count}
        for key, count in sorted(groups.items())
    ]
