"""The table of the scene file, as the compiled part gives it."""

import dataclasses
import functools
from typing import Any

from nilas import _core
from nilas.names import unknown


@dataclasses.dataclass(frozen=True)
class ElementTable:
    """One element: its documentation, its attributes and the elements that may stand in it.

    >>> table_of("friction").parent, table_of("friction").may_repeat
    ('contact', True)
    """

    name: str
    parent: str
    may_repeat: bool
    doc: str
    attributes: dict[str, dict[str, Any]]
    children: tuple[str, ...]


@functools.cache
def table() -> dict[str, ElementTable]:
    """All elements by name, parents before children.

    >>> table()["time"].attributes["step"]["unit"]
    's'
    >>> "friction" in table()["contact"].children
    True
    """
    rows = _core.schema()
    return {
        row["name"]: ElementTable(
            row["name"],
            row["parent"],
            row["may_repeat"],
            row["doc"],
            {attribute["name"]: attribute for attribute in row["attributes"]},
            tuple(other["name"] for other in rows if other["parent"] == row["name"]),
        )
        for row in rows
    }


def table_of(name: str) -> ElementTable:
    """The element of this name.

    >>> table_of("tme")
    Traceback (most recent call last):
    nilas.errors.UnknownName: There is no element <tme> in a scene; did you mean <time>?
    """
    found = table().get(name)
    if found is None:
        raise unknown(f"There is no element <{name}> in a scene", name, list(table()), "<{}>")
    return found
