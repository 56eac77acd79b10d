"""Values of attributes of a scene at a point of a study, as inputs of formulas."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterable, Mapping
from pathlib import Path

from nilas.study.describe.points import Point
from nilas.study.describe.read_factors import RUN_FLAGS
from nilas.study.describe.study import Study

_STEP = re.compile(r"(\w+)(?:\[(?:(\d+)|@(\w+)=['\"]?([^'\"\]]*)['\"]?)\])?$")


class NoValue(ValueError):
    """An attribute that the scene does not give as one number."""


class SceneValues:
    """The attributes of a scene file after overrides, as ``--set`` makes them."""

    def __init__(self, scene: Path, overrides: Iterable[tuple[str, str]]) -> None:
        try:
            self._root = ElementTree.parse(scene).getroot()
        except (OSError, ElementTree.ParseError) as error:
            raise NoValue(f"{scene} cannot be read as XML: {error}.") from error
        for path, value in overrides:
            if path not in RUN_FLAGS:
                element, attribute = self._find(path, add=True)
                element.set(attribute, value)

    def number(self, path: str) -> float:
        """The number of an attribute; one that ends in ``_deg`` in radians.

        Raises ``NoValue`` where the scene leaves the attribute to its default, or it is no number.
        """
        element, attribute = self._find(path)
        text = element.get(attribute)
        if text is None:
            raise NoValue(
                f"The scene does not give {path}. Write it there, or state a number here."
            )
        try:
            value = float(text)
        except ValueError:
            raise NoValue(f"{path} is '{text}', which is not one number.") from None
        return math.radians(value) if attribute.endswith("_deg") else value

    def _find(self, path: str, *, add: bool = False) -> tuple[ElementTree.Element, str]:
        place, _, attribute = path.rpartition("/")
        element = self._root
        for step in [part for part in place.strip("/").split("/") if part]:
            element = self._child(element, step, path, add)
        return element, attribute.lstrip("@")

    def _child(
        self, parent: ElementTree.Element, step: str, path: str, add: bool
    ) -> ElementTree.Element:
        found = _STEP.match(step)
        if not found:
            raise NoValue(f"'{path}' is no path of an attribute.")
        tag, number, key, value = found.groups()
        named = [child for child in parent if child.tag == tag]
        if key:
            named = [child for child in named if child.get(key) == value]
        elif number:
            named = named[int(number) - 1 : int(number)]
        if named:
            return named[0]
        if add and not key and not number:
            return ElementTree.SubElement(parent, tag)
        raise NoValue(f"The scene has no <{tag}> for {path}.")


def inputs_at(study: Study, inputs: Mapping[str, float | str], point: Point) -> dict[str, float]:
    """The inputs of formulas at a point: numbers, attributes of the scene, or levels of factors.

    Attributes are looked up in the scene with its overrides. With ``--scale`` they are those of
    the scene before it is scaled. A factor in degrees is given in radians.
    """
    scene = SceneValues(study.scene, [*study.overrides, *point.overrides])
    values = {}
    for name, value in inputs.items():
        if isinstance(value, float):
            values[name] = value
        elif "@" in value:
            values[name] = scene.number(value)
        else:
            values[name] = _level_of(study, value, point)
    return values


def _level_of(study: Study, factor: str, point: Point) -> float:
    for one, level in zip(study.factors, point.levels, strict=True):
        if one.name == factor and level.number is not None:
            return math.radians(level.number) if one.unit == "deg" else level.number
    raise NoValue(f"'{factor}' is no factor whose levels are numbers.")


def scale_of(study: Study, point: Point) -> float:
    """The scale at which the runs of a point are made; 1 without the flag."""
    overrides = dict(study.overrides) | dict(point.overrides)
    return float(overrides.get("--scale", "1"))
