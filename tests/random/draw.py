"""Random choices of a scene, written as the attributes of XML take them."""
import random
import xml.etree.ElementTree as ET
from typing import Sequence, TypeVar

Item = TypeVar("Item")


def text(value: object) -> str:
    """A value as an attribute: numbers with five digits, lists separated by blanks."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float):
        return f"{value:.5g}"
    if isinstance(value, (list, tuple)):
        return " ".join(text(part) for part in value)
    return str(value)


def add(parent: ET.Element, tag: str, **attributes: object) -> ET.Element:
    """Adds a child element; attributes that are None are left out."""
    child = ET.SubElement(parent, tag)
    for name, value in attributes.items():
        if value is not None:
            child.set(name, text(value))
    return child


class Draw:
    """Draws from a generator of its own, so that a scene is a function of its seed alone."""

    def __init__(self, seed: int) -> None:
        self._random = random.Random(f"scene {seed}")

    def chance(self, share: float) -> bool:
        """True in this share of the draws."""
        return self._random.random() < share

    def pick(self, items: Sequence[Item]) -> Item:
        """One of the items, all equally likely."""
        return items[self._random.randrange(len(items))]

    def some(self, items: Sequence[Item]) -> list[Item]:
        """Any subset of the items, in their order."""
        return [item for item in items if self.chance(0.5)]

    def whole(self, low: int, high: int) -> int:
        """A whole number of both bounds and what lies between."""
        return self._random.randint(low, high)

    def number(self, low: float, high: float) -> float:
        """A number of the interval; all equally likely."""
        return self._random.uniform(low, high)

    def size(self, low: float, high: float) -> float:
        """A number of the interval whose logarithm is uniform."""
        return low * (high / low) ** self._random.random()

    def vector(self, size: float) -> list[float]:
        """Three numbers between -size and size."""
        return [self.number(-size, size) for _ in range(3)]

    def maybe(self, share: float, value: Item) -> Item | None:
        """The value in this share of the draws, else None, which leaves an attribute out."""
        return value if self.chance(share) else None

    def switch(self, share: float = 0.3) -> bool | None:
        """A switch that is named in this share of the draws."""
        return self.maybe(share, self.chance(0.5))
