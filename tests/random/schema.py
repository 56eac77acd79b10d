"""What the schema of scenes holds, and how much of it a set of scenes has used."""
import re
import xml.etree.ElementTree as ET
from collections import Counter

XS = "{http://www.w3.org/2001/XMLSchema}"

# A pattern of words that are written in the place of numbers, as in pyramid-8.
FAMILY = re.compile(r"pyramid-\d+")


# What the schema writes for them, and the name of this word here.
FAMILY_IN_SCHEMA, FAMILY_NAME = "pyramid-[0-9]+", "pyramid-k"


def _words(attribute: ET.Element) -> list[str]:
    """The words that an attribute allows; none for numbers and free text."""
    restrictions = list(attribute.iter(XS + "restriction"))
    if any(item.get("base") == "switch" for item in restrictions):
        return ["true", "false"]
    for pattern in attribute.iter(XS + "pattern"):
        allowed = pattern.get("value", "").replace(FAMILY_IN_SCHEMA, FAMILY_NAME)
        if re.fullmatch(r"[\w |-]+", allowed):
            return allowed.split("|")
    return []


class Schema:
    """All elements, attributes and words of the schema, each as a key such as `contact@law=ccp`."""

    def __init__(self, xsd: str) -> None:
        self.keys: set[str] = set()
        self._words: dict[str, list[str]] = {}
        for element in ET.fromstring(xsd).iter(XS + "element"):
            name = element.get("name", "")
            self.keys.add(name)
            kind = element.find(XS + "complexType")
            for attribute in [] if kind is None else kind.findall(XS + "attribute"):
                key = f"{name}@{attribute.get('name')}"
                self._words[key] = _words(attribute)
                self.keys.add(key)
                self.keys.update(f"{key}={word}" for word in self._words[key])

    def used_by(self, scene: ET.Element) -> set[str]:
        """The keys that a scene uses."""
        used: set[str] = set()
        for element in scene.iter():
            used.add(element.tag)
            for name, value in element.attrib.items():
                key = f"{element.tag}@{name}"
                used.add(key)
                words = self._words.get(key, [])
                used.update(f"{key}={word}" for word in words if word in value.split() or word == value)
                if FAMILY.fullmatch(value) and FAMILY_NAME in words:
                    used.add(f"{key}={FAMILY_NAME}")
        return used & self.keys


class Coverage:
    """Counts in how many scenes each key of the schema was used."""

    def __init__(self, schema: Schema) -> None:
        self._schema = schema
        self._count: Counter[str] = Counter()

    def add(self, scene: ET.Element) -> None:
        """Counts a scene."""
        self._count.update(self._schema.used_by(scene))

    def missing(self) -> list[str]:
        """The keys that no scene used."""
        return sorted(self._schema.keys - set(self._count))

    def shares(self) -> dict[str, tuple[int, int]]:
        """Used and all keys: elements, attributes, words."""
        kinds = {"elements": r"[^@]+", "attributes": r"[^@=]+@[^@=]+", "words": r".*=.*"}
        return {kind: (sum(1 for key in self._schema.keys if re.fullmatch(form, key) and self._count[key]),
                       sum(1 for key in self._schema.keys if re.fullmatch(form, key)))
                for kind, form in kinds.items()}
