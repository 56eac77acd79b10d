"""Paths of `--set`: element/element[2]/@attribute."""

import dataclasses
import re

from nilas.errors import InputError
from nilas.scene.element import Element

_STEP = re.compile(r"(\w+)(?:\[(?:(\d+)|(\+)|@(\w+)=(?:'([^']*)'|\"([^\"]*)\"))\])?")


@dataclasses.dataclass(frozen=True)
class Step:
    """One element of a path: its name, and which of several it is.

    >>> Step("body", key="name", value="ship").is_new
    False
    """

    tag: str
    number: int = 0  # 1-based; 0: not given
    is_new: bool = False
    key: str = ""
    value: str = ""

    def found_in(self, parent: Element) -> Element:
        """The child that is meant; added where none has the name and none is picked.

        >>> scene = Element("scene", Element("body", name="one"), Element("body", name="two"))
        >>> Step("body", number=2).found_in(scene)["name"]
        'two'
        >>> Step("body").found_in(scene)
        Traceback (most recent call last):
        nilas.errors.InputError: There are 2 <body> in <scene>; say which by [number] or [@name='...'].
        """
        if self.is_new:
            return parent.append(Element(self.tag))
        named = [child for child in parent if child.tag == self.tag]
        if self.key:
            named = [child for child in named if child[self.key] == self.value]
        elif self.number:
            named = named[self.number - 1 : self.number]
        if len(named) > 1:
            raise InputError(
                f"There are {len(named)} <{self.tag}> in <{parent.tag}>; say which by [number] or [@name='...']."
            )
        if not named and (self.key or self.number):
            raise InputError(f"<{parent.tag}> has no such <{self.tag}>.")
        return named[0] if named else parent.append(Element(self.tag))


def read_path(path: str) -> tuple[list[Step], str]:
    """The elements of a path below the scene, and its attribute.

    >>> read_path("contact/@tolerance")
    ([Step(tag='contact', number=0, is_new=False, key='', value='')], 'tolerance')
    >>> read_path("contact/tolerance")
    Traceback (most recent call last):
    nilas.errors.InputError: 'contact/tolerance' is no path of an attribute; write element/element/@attribute.
    """
    place, _, attribute = path.rpartition("/")
    if not attribute.startswith("@") or not attribute[1:].isidentifier():
        raise InputError(f"'{path}' is no path of an attribute; write element/element/@attribute.")
    steps = []
    rest = place.removeprefix("/")
    rest = "" if rest == "scene" else rest.removeprefix("scene/")
    while rest:
        found = _STEP.match(rest)
        if found is None or rest[found.end() :][:1] not in ("", "/"):
            raise InputError(f"'{path}' is no path of an attribute: '{rest}' names no element.")
        tag, number, new, key, single, double = found.groups()
        steps.append(Step(tag, int(number or 0), bool(new), key or "", single or double or ""))
        rest = rest[found.end() + 1 :]
    return steps, attribute[1:]
