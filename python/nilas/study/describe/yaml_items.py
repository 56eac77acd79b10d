"""A YAML file as items that know their line, so that every fault has a place.

Values stay the text that the user wrote. So ``1e-4`` is a number and ``yes`` is a word,
whatever version of YAML a parser follows.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

import yaml

from nilas.study.describe.faults import Faults


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
        text = file.read_text(encoding="utf-8")
    except (OSError, UnicodeDecodeError) as error:
        faults.unreadable(f"The study file {file} cannot be read: {_reason(error)}.")
        return None
    try:
        node = yaml.compose(text, Loader=yaml.SafeLoader)
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
    return _item(node, faults)


def _item(node: yaml.Node, faults: Faults) -> Item:
    line = node.start_mark.line + 1
    if isinstance(node, yaml.ScalarNode):
        if node.tag == "tag:yaml.org,2002:null":
            return Item(line, "nothing")
        return Item(line, "text", text=node.value)
    if isinstance(node, yaml.SequenceNode):
        return Item(line, "list", items=tuple(_item(one, faults) for one in node.value))
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
            item = _item(value, faults)
            # The line of a key is where people look for it.
            entries[key.value] = Item(key_line, item.kind, item.text, item.items, item.entries)
    return Item(line, "map", entries=entries)


def _reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or "it is no text in UTF-8"
