"""Reads a study file and checks all of it."""

from __future__ import annotations

import csv
import io
import re
from pathlib import Path

from nilas.study.describe.factor import Factor
from nilas.study.describe.faults import Faults, listed, nearest
from nilas.study.describe.read_factors import read_factors, read_overrides
from nilas.study.describe.read_responses import read_responses
from nilas.study.describe.section import Section, whole_of
from nilas.study.describe.study import (
    DESIGNS,
    KEEPS,
    SAMPLED,
    Design,
    JobOptions,
    Response,
    RunOptions,
    Seeds,
    Study,
    Until,
)
from nilas.study.describe.yaml_items import Item, read_items, text_of

TOP_KEYS = (
    "name", "scene", "out", "set", "factors", "design", "seeds", "responses", "run", "job"
)  # fmt: skip
DESIGN_KEYS = ("kind", "points", "seed", "rows", "file")
SEEDS_KEYS = ("count", "first", "each_point", "until", "vary")
UNTIL_KEYS = ("response", "relative_error", "most")
RUN_KEYS = ("threads", "checkpoint_every", "limit_s", "keep")
JOB_KEYS = ("points", "memory_mb", "minutes")
_NAME = re.compile(r"^[\w.-]+$")


def read_study(file: str | Path, out: str | Path | None = None) -> Study:
    """The study of a file. ``out``: another folder than the one that the file names.

    Raises ``StudyError`` with all faults of the file.

    >>> study = read_study(example_study)
    >>> [factor.name for factor in study.factors], study.seeds.count
    (['speed', 'concentration'], 2)
    >>> [response.title for response in study.responses]
    ['load [N]']
    """
    path = Path(file)
    faults = Faults(str(file))
    item = read_items(path, faults)
    faults.throw()
    study = study_of(item, "", path, faults, out)
    faults.throw()
    return study


def study_of(
    item: Item | None, where: str, file: Path, faults: Faults, out: str | Path | None = None
) -> Study:
    """The study that an item of a file describes. Faults are added, with keys below ``where``.

    With faults the study is not complete, and must not be carried out.
    """
    top = Section(item, where, TOP_KEYS, faults)
    name = top.text("name", file.stem)
    if not _NAME.match(name):
        top.fault("name", f"'{name}' is no name: letters, digits and . _ - are allowed.")
    factors = read_factors(top.item("factors"), faults)
    responses = read_responses(top, {factor.name for factor in factors}, faults)
    study = Study(
        file=file.absolute(),
        name=name,
        scene=_scene(top, file),
        out=Path(out or top.text("out", f"runs/{name}")).absolute(),
        overrides=read_overrides(top.item("set"), "set", faults),
        factors=factors,
        design=_design(top.item("design"), file, factors, faults),
        seeds=_seeds(top.item("seeds"), responses, faults),
        responses=responses,
        run=_run(top.item("run"), faults),
        job=_job(top.item("job"), faults),
    )
    if study.run.keep == "nothing" and study.job.points == 0:
        faults.add(
            top.line_of("run"),
            "run.keep",
            "'nothing' needs job.points, whose parts hold the records.",
        )
    return study


def _scene(top: Section, file: Path) -> Path:
    if not top.has("scene"):
        top.fault(None, "'scene' is missing. It names the scene file that the study varies.")
        return file
    scene = (file.parent / top.text("scene")).absolute()
    if not _is_file(scene):
        top.fault("scene", f"There is no file {scene}. The path is relative to the study file.")
    return scene


def _is_file(path: Path) -> bool:
    try:
        return path.is_file()
    except OSError:  # such as a name that is too long
        return False


def _design(item: Item | None, file: Path, factors: tuple[Factor, ...], faults: Faults) -> Design:
    if item is not None and item.kind == "text":
        item = Item(item.line, "map", entries={"kind": item})
    section = Section(item, "design", DESIGN_KEYS, faults)
    kind = section.choice("kind", DESIGNS, "full")
    for key in ("rows", "file"):
        if section.has(key) and kind != "table":
            section.fault(key, f"Only the design table has {key}.")
    if kind == "table":
        return Design(kind, rows=_rows(section, file, factors, faults))
    if kind in SAMPLED:
        return _sampled(section, kind, factors)
    for key in ("points", "seed"):
        if section.has(key):
            section.fault(key, f"The design {kind} has no {key}. Those of {listed(SAMPLED)} do.")
    for factor in factors:
        if factor.low is not None and not factor.levels:
            faults.add(
                factor.line,
                f"factors.{factor.name}",
                f"The design {kind} needs steps, the number of values.",
            )
    return Design(kind)


def _sampled(section: Section, kind: str, factors: tuple[Factor, ...]) -> Design:
    if not section.has("points"):
        section.fault(None, f"The design {kind} needs points, the number of its points.")
    points = section.whole("points", 8, least=2, most=10**7)
    if kind != "latin-hypercube" and points & (points - 1):
        section.fault(
            "points",
            f"{points} is no power of two, which the sequence of Sobol needs, such as 64 or 128.",
        )
    if not factors:
        section.fault(None, f"The design {kind} needs at least one factor.")
    return Design(kind, points, section.whole("seed", 1))


def _rows(
    section: Section, file: Path, factors: tuple[Factor, ...], faults: Faults
) -> tuple[dict[str, str], ...]:
    """The points of a table, from the study file or from a CSV file."""
    if section.has("rows") == section.has("file"):
        section.fault(None, "The design table needs either rows, or file, which names a CSV file.")
        return ()
    if section.has("file"):
        rows = _rows_of_file(section, file)
    else:
        rows = []
        for entry in section.entries["rows"].items:
            if entry.kind != "map" or any(one.kind != "text" for one in entry.entries.values()):
                faults.add(entry.line, "design.rows", "A row is a map from factors to values.")
            else:
                texts = {key: one.text for key, one in entry.entries.items()}
                rows.append((entry.line, texts))
    names = [factor.name for factor in factors]
    for line, row in rows:
        place = section.line_of("file") if section.has("file") else line
        for name in row:
            if name not in names:
                hint = nearest(name, names)
                faults.add(
                    place,
                    "design",
                    f"'{name}' is no factor.{hint} Factors are {listed(names or ['none'])}.",
                )
        for name in names:
            if not row.get(name):
                faults.add(place, "design", f"A row has no value of the factor {name}.")
    return tuple(row for _, row in rows)


def _rows_of_file(section: Section, file: Path) -> list[tuple[int, dict[str, str]]]:
    path = file.parent / section.text("file")
    try:
        rows = [
            {key.strip(): (value or "").strip() for key, value in row.items() if key}
            for row in csv.DictReader(io.StringIO(text_of(path), newline=""))
        ]
    except (OSError, ValueError, csv.Error) as error:
        section.fault("file", f"{path} cannot be read: {getattr(error, 'strerror', None) or error}.")
        return []
    return [(number, row) for number, row in enumerate(rows, 2)]


def _seeds(item: Item | None, responses: tuple[Response, ...], faults: Faults) -> Seeds:
    if item is not None and item.kind == "list":
        numbers = [whole_of(one) for one in item.items]
        for one, number in zip(item.items, numbers, strict=True):
            if number is None or not 0 <= number <= 2**53 or numbers.count(number) > 1:
                faults.add(
                    one.line,
                    "seeds",
                    f"{one.described()} is no whole number, or stands in the list twice.",
                )
        chosen = tuple(number for number in numbers if number is not None)
        if not chosen:
            faults.add(item.line, "seeds", "The list of seeds is empty.")
        return Seeds(len(chosen), chosen=chosen)
    if item is not None and item.kind == "text":
        item = Item(item.line, "map", entries={"count": item})
    section = Section(item, "seeds", SEEDS_KEYS, faults)
    count = section.whole("count", 1, least=1, most=10**6)
    own = section.choice("each_point", ("same", "own"), "same") == "own"
    if own and section.has("first"):
        section.fault("first", "Points with seeds of their own have no first seed.")
    until = _until(section.item("until"), count, responses, faults)
    perturbed = section.choice("vary", ("ice", "start"), "ice") == "start"
    return Seeds(count, section.whole("first", 1), own=own, until=until, perturbed=perturbed)


def _until(
    item: Item | None, count: int, responses: tuple[Response, ...], faults: Faults
) -> Until | None:
    if item is None:
        return None
    section = Section(item, "seeds.until", UNTIL_KEYS, faults)
    names = [response.name for response in responses]
    for key in UNTIL_KEYS:
        if not section.has(key):
            section.fault(None, f"'{key}' is missing. The rule needs {listed(UNTIL_KEYS)}.")
    response = section.text("response", names[0] if names else "")
    if response not in names:
        hint = nearest(response, names)
        section.fault(
            "response",
            f"'{response}' is no response.{hint} Responses are {listed(names or ['none'])}.",
        )
    if count < 2:
        section.fault(
            None,
            "The rule needs a count of at least 2 seeds, since one has no scatter. 3 or "
            "more are better.",
        )
    most = section.whole("most", count, least=count, most=10**6)
    return Until(response, section.number("relative_error", 0.1, above=0.0) or 0.1, most)


def _run(item: Item | None, faults: Faults) -> RunOptions:
    section = Section(item, "run", RUN_KEYS, faults)
    return RunOptions(
        threads=section.whole("threads", 1, least=1, most=256),
        checkpoint_every=section.number("checkpoint_every", above=0.0),
        limit_s=section.number("limit_s", above=0.0),
        keep=section.choice("keep", KEEPS, "all"),
    )


def _job(item: Item | None, faults: Faults) -> JobOptions:
    section = Section(item, "job", JOB_KEYS, faults)
    return JobOptions(
        points=section.whole("points", 0, most=10**6),
        memory_mb=section.whole("memory_mb", 0),
        minutes=section.whole("minutes", 0),
    )
