"""Reads a case file and checks all of it."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from nilas.study.describe.faults import Faults, listed, nearest
from nilas.study.describe.points import points_of
from nilas.study.describe.read_factors import is_path, read_overrides
from nilas.study.describe.read_study import study_of
from nilas.study.describe.section import Section, number_of
from nilas.study.describe.study import Study
from nilas.study.describe.yaml_items import Item, read_items
from nilas.validate.cases.case import Case, Reference, Slice, SlopeReference
from nilas.validate.cases.scene_values import NoValue, inputs_at
from nilas.validate.formulas import FORMULAS, Formula
from nilas.validate.measured.rows import MeasuredError, MeasuredRow, read_measured

CASE_KEYS = (
    "title", "question", "minutes", "study", "inputs", "references", "slopes", "slice",
    "measured", "unjudged",
)  # fmt: skip
# What a reference may be: it has one of these.
REFERENCE_KINDS = ("formula", "envelope", "least", "at_most", "same_over", "value")
REFERENCE_KEYS = ("quantity", *REFERENCE_KINDS, "where", "source", "remark")
SLOPE_KEYS = ("quantity", "over", "input", "per", "formulas")
SLICE_KEYS = ("seeds", "points", "set")
FORMULA_KINDS = ("formula", "envelope", "least", "at_most")
KIND_NAMES = {"envelope": "An envelope", "least": "A least value"}


def read_case(file: str | Path) -> Case:
    """The case of a file. Raises ``StudyError`` with all faults, each with line and key."""
    path = Path(file)
    faults = Faults(str(file))
    item = read_items(path, faults)
    faults.throw()
    case = _Reader(path, faults).case(Section(item, "", CASE_KEYS, faults))
    faults.throw()
    _check_inputs(case, faults)
    faults.throw()
    return case


@dataclass
class _Reader:
    file: Path
    faults: Faults

    def case(self, top: Section) -> Case:
        for key in ("title", "question", "study"):
            if not top.has(key):
                top.fault(None, f"'{key}' is missing.")
        measured, item = self._measured(top)
        study = study_of(item, "study", self.file, self.faults)
        inputs = self._inputs(top.item("inputs"), {factor.name for factor in study.factors})
        references = tuple(self._reference(one, study) for one in self._list(top, "references"))
        if not references and not measured:
            top.fault(None, "A case needs 'references', or a table under 'measured'.")
        slopes = tuple(self._slope(one, study, inputs) for one in self._list(top, "slopes"))
        return Case(
            file=self.file.absolute(),
            name=study.name,
            title=top.text("title"),
            question=top.text("question"),
            minutes=top.number("minutes", 10.0, above=0.0) or 10.0,
            study=study,
            inputs=inputs,
            references=references,
            slopes=slopes,
            slice=self._slice(top.item("slice"), study),
            measured=measured,
            unjudged=top.text("unjudged"),
        )

    def _measured(self, top: Section) -> tuple[tuple[MeasuredRow, ...], Item | None]:
        """The measured rows, and the study, whose points they are."""
        study = top.item("study")
        if not top.has("measured") or study is None or study.kind != "map":
            return (), study
        if "design" in study.entries:
            top.fault("measured", "The table names the points, so the study takes no design.")
            return (), study
        names = study_of(study, "study", self.file, Faults(""))
        try:
            rows = read_measured(
                self.file.parent / top.text("measured"),
                [factor.name for factor in names.factors],
                [response.name for response in names.responses],
            )
        except MeasuredError as error:
            top.fault("measured", str(error))
            return (), study
        line = top.line_of("measured")
        maps = [
            Item(line, "map", entries={
                name: Item(line, "text", text=text) for name, text in row.conditions.items()
            })
            for row in rows
        ]  # fmt: skip
        design = {
            "kind": Item(line, "text", text="table"),
            "rows": Item(line, "list", items=tuple(maps)),
        }
        entries = study.entries | {"design": Item(line, "map", entries=design)}
        return rows, Item(study.line, "map", entries=entries)

    def _inputs(self, item: Item | None, factors: set[str]) -> dict[str, float | str]:
        if item is None:
            return {}
        if item.kind != "map":
            told = "A map from inputs to attributes should stand here."
            self.faults.add(item.line, "inputs", told)
            return {}
        # A factor may set several inputs at once, as an area does; its own level is then one too.
        known = {one.name for formula in FORMULAS.values() for one in formula.inputs} | factors
        inputs: dict[str, float | str] = {}
        for name, value in item.entries.items():
            number = number_of(value.text) if value.kind == "text" else None
            if name not in known:
                hint = nearest(name, known)
                self.faults.add(value.line, f"inputs.{name}", f"No formula has this input.{hint}")
            elif number is not None:
                inputs[name] = number
            elif value.kind == "text" and (is_path(value.text) or value.text in factors):
                inputs[name] = value.text
            else:
                self.faults.add(
                    value.line,
                    f"inputs.{name}",
                    f"{value.described()} stands here; a number, a factor or a path such as "
                    "vessel/carriage/@speed should.",
                )
        return inputs

    def _reference(self, item: Item, study: Study) -> Reference:
        section = Section(item, "references", REFERENCE_KEYS, self.faults)
        quantity = self._quantity(section, study)
        kinds = [key for key in REFERENCE_KINDS if section.has(key)]
        if len(kinds) != 1:
            section.fault(None, f"A reference has one of {listed(REFERENCE_KINDS)}.")
        kind = kinds[0] if kinds else "value"
        number = self._number_of(section, kind)
        if number is not None and not section.has("source"):
            section.fault(kind, "A value needs a source, which says why it is expected.")
        formulas = self._formulas(section, kind) if number is None and kind in FORMULA_KINDS else ()
        if kind in ("envelope", "least") and len(formulas) < 2:
            section.fault(kind, f"{KIND_NAMES[kind]} has two formulas or more.")
        over = self._words(section, "same_over")
        self._check_factors(section, "same_over", over, study)
        return Reference(
            quantity,
            formulas,
            kind in ("least", "at_most"),
            kind == "at_most",
            self._where(section.item("where"), study),
            tuple(over),
            number,
            section.text("source"),
            section.text("remark"),
        )

    def _number_of(self, section: Section, kind: str) -> float | None:
        """The number of a reference of this kind, None where it names formulas or factors."""
        item = section.item(kind)
        is_number = item is not None and item.kind == "text" and number_of(item.text) is not None
        if kind == "value" or (kind == "at_most" and is_number):
            return section.number(kind)
        return None

    def _where(self, item: Item | None, study: Study) -> dict[str, tuple[str, ...]]:
        if item is None:
            return {}
        if item.kind != "map":
            told = "A map from factors to levels fits here."
            self.faults.add(item.line, "references.where", told)
            return {}
        factors = {factor.name: factor for factor in study.factors}
        found = {}
        for name, value in item.entries.items():
            key = f"references.where.{name}"
            if name not in factors:
                hint = nearest(name, factors)
                told = f"'{name}' is no factor.{hint} There are {listed(factors or ['none'])}."
                self.faults.add(value.line, key, told)
                continue
            labels = [level.label for level in factors[name].levels]
            words = [one.text for one in (value.items if value.kind == "list" else (value,))]
            for word in words:
                if word not in labels:
                    told = f"'{word}' is no level. There are {listed(labels)}."
                    self.faults.add(value.line, key, told)
            found[name] = tuple(words)
        return found

    def _slope(self, item: Item, study: Study, inputs: dict[str, float | str]) -> SlopeReference:
        section = Section(item, "slopes", SLOPE_KEYS, self.faults)
        for key in ("over", "formulas"):
            if not section.has(key):
                section.fault(None, f"'{key}' is missing.")
        factor = section.text("over")
        self._check_factors(section, "over", [factor] if factor else [], study)
        name = section.text("input", factor)
        formulas = self._formulas(section, "formulas")
        of_some = {one.name for formula in FORMULAS.values() for one in formula.inputs}
        for formula in formulas:
            if name in of_some and name not in {one.name for one in formula.inputs}:
                section.fault("formulas", f"{formula.name} has no input {name}.")
        if name not in inputs:
            section.fault("over", f"The case has no input {name}; 'input' names another.")
        per = section.text("per")
        if per and per not in inputs:
            section.fault("per", f"The case has no input {per}.")
        return SlopeReference(self._quantity(section, study), factor, name, formulas, per)

    def _slice(self, item: Item | None, study: Study) -> Slice:
        section = Section(item, "slice", SLICE_KEYS, self.faults)
        if item is None:
            self.faults.add(
                0, "", "'slice' is missing: a small part of the case, for quick checks."
            )
        points = []
        for word in self._words(section, "points"):
            number = number_of(word)
            if number is None or number < 1 or number != int(number):
                section.fault("points", f"'{word}' is no number of a point.")
            else:
                points.append(int(number))
        overrides = read_overrides(section.item("set"), "slice.set", self.faults)
        return Slice(section.whole("seeds", 1, least=1, most=100), tuple(points or [1]), overrides)

    def _quantity(self, section: Section, study: Study) -> str:
        names = [response.name for response in study.responses]
        name = section.text("quantity", names[0] if names else "")
        if names and name not in names:
            hint = nearest(name, names)
            section.fault("quantity", f"'{name}' is no response.{hint} There are {listed(names)}.")
        return name

    def _formulas(self, section: Section, key: str) -> tuple[Formula, ...]:
        found = []
        for name in self._words(section, key):
            if name in FORMULAS:
                found.append(FORMULAS[name])
            else:
                hint = nearest(name, FORMULAS)
                section.fault(
                    key, f"'{name}' is no formula.{hint} There are {listed(sorted(FORMULAS))}."
                )
        return tuple(found)

    def _check_factors(self, section: Section, key: str, names: list[str], study: Study) -> None:
        known = [factor.name for factor in study.factors]
        for name in names:
            if name not in known:
                hint = nearest(name, known)
                section.fault(
                    key, f"'{name}' is no factor.{hint} There are {listed(known or ['none'])}."
                )

    def _words(self, section: Section, key: str) -> list[str]:
        item = section.item(key)
        if item is None:
            return []
        items = item.items if item.kind == "list" else (item,)
        if any(one.kind != "text" for one in items):
            section.fault(key, "A word or a list of words should stand here.")
            return []
        return [one.text for one in items]

    def _list(self, top: Section, key: str) -> tuple[Item, ...]:
        item = top.item(key)
        if item is None:
            return ()
        if item.kind != "list":
            top.fault(key, "A list should stand here.")
            return ()
        return item.items


def _check_inputs(case: Case, faults: Faults) -> None:
    """Every formula must have its inputs at each point, and every slice its points."""
    formulas = {one for reference in case.references for one in reference.formulas}
    formulas |= {one for slope in case.slopes for one in slope.formulas}
    for formula in sorted(formulas, key=lambda one: one.name):
        for name in formula.needs():
            if name not in case.inputs:
                faults.add(0, "inputs", f"{formula.name} needs the input {name}.")
    points = points_of(case.study)
    for number in case.slice.points:
        if number > len(points):
            faults.add(0, "slice.points", f"There are {len(points)} points, and no {number}.")
    try:
        for point in points:
            inputs_at(case.study, case.inputs, point)
    except NoValue as error:
        faults.add(0, "inputs", str(error))
