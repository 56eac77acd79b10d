"""Elements of a scene."""

import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from typing import Any

from nilas.errors import InputError
from nilas.names import unknown
from nilas.scene.table import table_of
from nilas.values import written


class Element:
    """An element of a scene file, with the attributes and the children that the scene reference lists.

    Attributes are items: numbers, words, booleans or lists. A name that is a word of Python, such as `from`, takes an
    underscore at its end as a keyword.

    >>> friction = Element("friction", between="ice ice", static=0.3, kinetic=0.3)
    >>> contact = Element("contact", friction, law="coulomb", tolerance=1e-6)
    >>> contact["tolerance"] = 1e-8
    >>> print(contact.xml())
    <contact law="coulomb" tolerance="1e-08">
      <friction between="ice ice" static="0.3" kinetic="0.3" />
    </contact>
    >>> Element("contact", tolerence=1e-8)
    Traceback (most recent call last):
    nilas.errors.UnknownName: <contact> has no attribute 'tolerence'; did you mean tolerance?
    """

    def __init__(self, tag: str, /, *children: "Element", **attributes: Any) -> None:
        self._table = table_of(tag)
        self._attributes: dict[str, str] = {}
        self._children: list[Element] = []
        for name, value in attributes.items():
            self[name.removesuffix("_")] = value
        for child in children:
            self.append(child)

    @property
    def tag(self) -> str:
        """The name of the element.

        >>> Element("gravity").tag
        'gravity'
        """
        return self._table.name

    @property
    def doc(self) -> str:
        """What the scene reference says of it.

        >>> Element("gravity").doc != ""
        True
        """
        return self._table.doc

    @property
    def children(self) -> tuple["Element", ...]:
        """The elements in it, in their order.

        >>> [child.tag for child in Element("scene", Element("time"), Element("seed")).children]
        ['time', 'seed']
        """
        return tuple(self._children)

    def append(self, child: "Element") -> "Element":
        """Adds a child and returns it.

        >>> Element("contact").append(Element("vessel", name="ship"))
        Traceback (most recent call last):
        nilas.errors.UnknownName: <vessel> cannot stand in <contact>; allowed: <friction>.
        """
        if child.tag not in self._table.children:
            raise unknown(
                f"<{child.tag}> cannot stand in <{self.tag}>", child.tag, list(self._table.children), "<{}>"
            )
        if not child._table.may_repeat and any(child.tag == other.tag for other in self._children):
            raise InputError(f"<{self.tag}> may have one <{child.tag}> only.")
        self._children.append(child)
        return child

    def remove(self, child: "Element") -> None:
        """Removes a child; nothing happens where it is none.

        >>> scene = Element("scene", Element("time"), Element("seed"))
        >>> scene.remove(scene.find("time"))
        >>> [child.tag for child in scene]
        ['seed']
        """
        self._children = [other for other in self._children if other is not child]

    def find(self, tag: str) -> "Element":
        """The first child of this name; it is added where there is none yet.

        >>> scene = Element("scene")
        >>> scene.find("time")["step"] = 0.01
        >>> [child.tag for child in scene.children]
        ['time']
        """
        for child in self._children:
            if child.tag == tag:
                return child
        return self.append(Element(tag))

    def __setitem__(self, name: str, value: Any) -> None:
        self._known(name)
        if value is None:
            self._attributes.pop(name, None)
        else:
            self._attributes[name] = written(value)

    def __getitem__(self, name: str) -> str | None:
        """The text of an attribute; None where it is not set and takes its default."""
        self._known(name)
        return self._attributes.get(name)

    def __iter__(self) -> Iterator["Element"]:
        return iter(self._children)

    def _known(self, name: str) -> None:
        if name not in self._table.attributes:
            raise unknown(
                f"<{self.tag}> has no attribute '{name}'", name, list(self._table.attributes)
            )

    def to_tree(self) -> ElementTree.Element:
        """The element as a tree of the standard library.

        >>> Element("time", end=2).to_tree().attrib
        {'end': '2'}
        """
        tree = ElementTree.Element(self.tag, self._attributes)
        tree.extend(child.to_tree() for child in self._children)
        return tree

    def xml(self) -> str:
        """The element as text.

        >>> Element("time", step=0.01, end=2).xml()
        '<time step="0.01" end="2" />'
        """
        tree = self.to_tree()
        ElementTree.indent(tree)
        return ElementTree.tostring(tree, encoding="unicode")

    def __repr__(self) -> str:
        return f"<nilas.Element {self.tag} with {len(self._children)} children>"
