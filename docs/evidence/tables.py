#!/usr/bin/env python3
"""Writes the tables of the pages of validation and reliability from the figures that are stored in data/.

usage: tables.py [--check]

A page marks the place of a table by two comments, `<!-- table: NAME -->` and `<!-- /table -->`. What stands between them
is written by this script: the rows of data/NAME.csv in the layout of table_layouts.py or load_layouts.py, and a caption that says with which
revision and command they were measured. With --check nothing is written, and the exit code is 1 where a page differs
from the data, a file of data/ is used by no page or lacks one of its keys, or a marker has no file.

A file of data/ begins with comment lines `# key: value`: `command` (what repeats the figures), `revision` (of the
program; the commit that recorded the figures where nobody wrote down more), `date` (`FIRST and LAST` where there are
several), `machine`, and where there is something to say `note`, which ends the caption. A table whose rows are of several revisions has a column `revision`.
Figures are stored with the digits that were measured; a layout that gives a format rounds them. Figures of one meaning
stand in one column, with their unit in its name; an empty field means that nothing was measured.
"""
import argparse
import csv
import pathlib
import re
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True  # leaves no folder beside the pages
sys.path.insert(0, str(HERE))
from load_layouts import LAYOUTS as LOADS  # noqa: E402  (they stand beside this script)
from table_layouts import LAYOUTS as OTHERS  # noqa: E402

LAYOUTS = OTHERS | LOADS

KEYS = ("command", "revision", "date", "machine")
BLOCK = re.compile(r"<!-- table: (\S+) -->\n.*?<!-- /table -->", re.DOTALL)
COLUMNS = 100
NOTHING = "-"


class Field(str):
    """A stored figure; a format turns it into a number, an exponent is written as 1e-6."""

    def __format__(self, spec):
        if not spec:
            return str(self)
        try:
            value = float(self)
        except ValueError:
            return str(self)
        if value == 0 and spec.endswith("e"):
            return "0"
        return re.sub(r"e([+-])0*(\d)", lambda m: "e" + m.group(1).strip("+") + m.group(2), format(value, spec)).removesuffix("e0")


def read(name):
    """The keys and the rows of a file of data/."""
    path = HERE / "data" / f"{name}.csv"
    if not path.exists():
        raise SystemExit(f"{path}: no such file, but a page asks for it")
    keys, lines = {}, []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("# "):
            key, _, value = line[2:].partition(": ")
            keys[key] = value
        else:
            lines.append(line)
    missing = [key for key in KEYS if not keys.get(key)]
    if missing:
        raise SystemExit(f"{path}: found no {', '.join(missing)}; expected lines '# key: value' for {', '.join(KEYS)}")
    return keys, [{k: Field(v) for k, v in row.items()} for row in csv.DictReader(lines, strict=True)]


def cell(pattern, row):
    """A pattern filled in; a dash where every field of it is empty."""
    names = re.findall(r"\{(\w+)", pattern)
    return pattern.format(**row) if any(row[name] for name in names) else NOTHING


def caption(name, keys, mixed):
    recorded = "the revision of each row" if mixed else f"revision `{keys['revision']}`"
    when = ("between " if " and " in keys["date"] else "on ") + keys["date"]
    text = f"The figures were recorded with {recorded} {when}, on {keys['machine']}. "
    text += f"They are repeated by {keys['command']}, and are stored in [data/{name}.csv](data/{name}.csv)."
    if keys.get("note"):
        text += " " + keys["note"]
    return textwrap.fill(text, COLUMNS, break_long_words=False, break_on_hyphens=False)


def table(name):
    if name not in LAYOUTS:
        raise SystemExit(f"table_layouts.py: found no layout for '{name}'; known: {', '.join(LAYOUTS)}")
    keys, rows = read(name)
    layout = LAYOUTS[name]
    lines = ["| " + " | ".join(heading for heading, _ in layout) + " |", "|" + "---|" * len(layout)]
    try:
        lines += ["| " + " | ".join(cell(pattern, row) for _, pattern in layout) + " |" for row in rows]
    except KeyError as key:
        raise SystemExit(f"data/{name}.csv: found no column {key}, which its layout asks for") from None
    return "\n".join(lines) + "\n\n" + caption(name, keys, "revision" in rows[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 where a page and the data differ")
    check = parser.parse_args().check
    faults, used = [], set()
    for page in sorted([*HERE.glob("validation*.md"), *HERE.glob("reliability*.md")]):
        old = page.read_text(encoding="utf-8")
        names = BLOCK.findall(old)
        if len(names) != old.count("<!-- table: "):
            faults.append(f"{page.name}: a marker '<!-- table: NAME -->' has no '<!-- /table -->'")
        used.update(names)
        new = BLOCK.sub(lambda m: f"<!-- table: {m.group(1)} -->\n{table(m.group(1))}\n<!-- /table -->", old)
        if new != old and check:
            faults.append(f"{page.name}: differs from the data; run docs/evidence/tables.py")
        elif new != old:
            page.write_text(new, encoding="utf-8")
            print(f"written: {page.name}")
    stored = {path.stem for path in (HERE / "data").glob("*.csv")}
    faults += [f"data/{name}.csv: no page shows it" for name in sorted(stored - used)]
    faults += [f"table_layouts.py: the layout '{name}' is used by no page" for name in sorted(set(LAYOUTS) - used)]
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
