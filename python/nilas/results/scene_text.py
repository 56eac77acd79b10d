"""The scene that a run recorded, as the paths and values that ``--set`` takes."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

from nilas.results.folder import NoRun

# Attributes that tell elements of one kind apart.
_KEYS = ("name", "between")


def attributes_of(file: Path) -> dict[str, str]:
    """Every attribute of a scene by its path, as in ``vessel/carriage/@speed``.

    Elements that occur several times are told apart by their name, else by their number. Where
    outputs go and hashes of inputs are left out.

    >>> attributes_of(example_folder / "scene.xml")["contact/friction[@between='hull ice']/@static"]
    '0.1'
    """
    try:
        root = ElementTree.parse(file).getroot()
    except FileNotFoundError:
        raise NoRun(f"{file}: this run has no scene.xml.") from None
    except ElementTree.ParseError as fault:
        raise NoRun(f"{file}: this is no XML text: {fault}.") from None
    attributes: dict[str, str] = {}
    _add(root, "", attributes)
    attributes.pop("output/@folder", None)
    return {path: text for path, text in attributes.items() if not path.startswith("input")}


def _add(element: ElementTree.Element, path: str, attributes: dict[str, str]) -> None:
    for name, text in element.attrib.items():
        attributes[f"{path}@{name}"] = text
    counts = Counter(child.tag for child in element)
    numbers: Counter[str] = Counter()
    for child in element:
        numbers[child.tag] += 1
        place = child.tag
        if counts[child.tag] > 1:
            key = next((key for key in _KEYS if child.get(key)), None)
            place += f"[@{key}='{child.get(key)}']" if key else f"[{numbers[child.tag]}]"
        _add(child, f"{path}{place}/", attributes)
