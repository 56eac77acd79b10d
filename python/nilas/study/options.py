"""The options of a study's command line.

They stand in ``options.json`` alone. The program holds the same file, so that its help, manual page
and completion know them without Python.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

_FILE = Path(__file__).with_name("options.json")


def option_parser() -> argparse.ArgumentParser:
    """The parser of ``python3 -m nilas.study``."""
    known = json.loads(_FILE.read_text(encoding="utf-8"))
    parser = argparse.ArgumentParser(
        "python3 -m nilas.study", description=known["description"], epilog=known["more"]
    )
    for entry in known["options"]:
        text = argparse.SUPPRESS if entry.get("hidden") else entry["help"]
        parser.add_argument(*entry["name"].split(","), help=text, **_kind(entry))
    return parser


def _kind(entry: dict[str, Any]) -> dict[str, Any]:
    """What argparse is told of an option: without a value it is a switch, and with bounds a whole
    number."""
    if "value" not in entry:
        return {"action": "store_true"}
    kind: dict[str, Any] = {"metavar": entry["value"]}
    if "most" in entry:
        kind |= {"type": _whole(entry["least"], entry["most"]), "default": entry.get("default")}
    return kind


def _whole(least: int, most: int) -> Callable[[str], int]:
    def read(text: str) -> int:
        if not text.isdecimal() or not least <= int(text) <= most:
            raise argparse.ArgumentTypeError(f"'{text}' is no whole number from {least} to {most}")
        return int(text)

    return read
