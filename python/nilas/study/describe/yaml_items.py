"""A YAML file as items that know their line, so that every fault has a place.

Values stay the text that the user wrote. So ``1e-4`` is a number and ``yes`` is a word,
whatever version of YAML a parser follows.
"""

from __future__ import annotations

import errno
from dataclasses import dataclass, field
from pathlib import Path

import yaml

from nilas.study.describe.faults import Faults


# More than any study needs. The parser takes ten seconds for a text of this size.
MOST_BYTES = 2**20
_MOST_ITEMS = 100000
_MOST_DEPTH = 30
_TOO_DEEP = f"Lists and maps are nested more than {_MOST_DEPTH} deep."
_TOO_MANY = f"The file has more than {_MOST_ITEMS} values, counted with those that aliases repeat."


@dataclass(frozen=True)
class Item:
    """One value of the file. ``kind``: text, list, map or nothing."""

    line: int
    kind: str
    text: str = ""
    items: tuple[Item, ...] = ()
    entries: dict[str, Item] = field(default_factory=dict)

    def described(self) -> str:
        """What was found, for messages."""
        return f"'{self.text}'" if self.kind == "text" else f"a {self.kind}"


def read_items(file: Path, faults: Faults) -> Item | None:
    """The top item of a YAML file, or None where the file cannot be read."""
    try:
        text = text_of(file)
    except (OSError, ValueError) as error:
        faults.unreadable(f"The study file {file} cannot be read: {_reason(error)}.")
        return None
    try:
        node = yaml.compose(text, Loader=yaml.SafeLoader)
    except RecursionError:
        faults.add(0, "", _TOO_DEEP)
        return None
    except yaml.YAMLError as error:
        mark = getattr(error, "problem_mark", None)
        problem = getattr(error, "problem", None) or str(error)
        hint = " Indent by blanks, not by tabs." if "\\t" in problem else ""
        begun = getattr(error, "context_mark", None)
        if begun and mark and begun.line != mark.line:
            hint += f" It belongs to what begins in line {begun.line + 1}."
        faults.add(mark.line + 1 if mark else 0, "", f"This is not valid YAML: {problem}.{hint}")
        return None
    if node is None:
        faults.add(0, "", "The study file is empty. It needs scene, factors and responses.")
        return None
    return _Walk(faults).item(node, 0)


def text_of(file: Path) -> str:
    """The text of a file. Raises ``OSError`` and ``ValueError``: no text, no file, too large."""
    if file.exists() and not file.is_file():
        raise OSError(errno.EINVAL, "It is no file")
    if file.stat().st_size > MOST_BYTES:
        raise OSError(errno.EFBIG, f"It has more than {MOST_BYTES} bytes")
    return file.read_text(encoding="utf-8")


class _Walk:
    """Turns nodes into items. By aliases a short file can name the same node any number of times,
    also within itself."""

    def __init__(self, faults: Faults) -> None:
        self.faults = faults
        self.left = _MOST_ITEMS

    def item(self, node: yaml.Node, depth: int) -> Item:
        self.left -= 1
        if depth > _MOST_DEPTH or self.left < 0:
            self.faults.add(node.start_mark.line + 1, "", _TOO_DEEP if self.left >= 0 else _TOO_MANY)
            self.faults.throw()
        return _item(node, self, depth)


def _item(node: yaml.Node, walk: _Walk, depth: int) -> Item:
    faults, line = walk.faults, node.start_mark.line + 1
    if isinstance(node, yaml.ScalarNode):
        if node.tag == "tag:yaml.org,2002:null":
            return Item(line, "nothing")
        return Item(line, "text", text=node.value)
    if isinstance(node, yaml.SequenceNode):
        return Item(line, "list", items=tuple(walk.item(one, depth + 1) for one in node.value))
    entries: dict[str, Item] = {}
    for key, value in node.value:
        key_line = key.start_mark.line + 1
        if not isinstance(key, yaml.ScalarNode):
            faults.add(key_line, "", "A key must be a word, not a list or a map.")
        elif key.value in entries:
            faults.add(
                key_line,
                key.value,
                f"The key stands here a second time; it is also in line {entries[key.value].line}.",
            )
        else:
            item = walk.item(value, depth + 1)
            # The line of a key is where people look for it.
            entries[key.value] = Item(key_line, item.kind, item.text, item.items, item.entries)
    return Item(line, "map", entries=entries)


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or "it is no text in UTF-8"
