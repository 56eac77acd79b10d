#!/usr/bin/env python3
"""Refuses formulas that GitHub would show wrongly, or mends them.

usage: formulas.py [--mend] [PAGE.md ...]

Without pages, all of docs and the README.md files are read. GitHub first reads a formula between dollars as Markdown: of a backslash before a
sign that is no letter only the sign is left, and *, _, < and [ ]( ) may be taken as Markdown's own. Such formulas are
written $`...`$ in a line and as a block of ```math, which GitHub leaves alone. No letter, digit or hyphen may stand
right before a formula, and no letter or digit right after it. --mend rewrites what can be rewritten. Exit code 1 where
something is left, with file and line.
"""
import argparse
import re
import sys
from pathlib import Path

RISKY = re.compile(r"\\[^A-Za-z\s]|\*|[^\w\s]_|<[A-Za-z/!?]|\]\(")
# Fences, blocks of formulas, code, formulas. As GitHub finds them: no blank just inside the dollars, no empty line.
PIECES = re.compile(
    r"(?P<fence>^[ \t]*(?P<mark>`{3,}|~{3,})[^\n]*\n.*?^[ \t]*(?P=mark)[^\n]*$)"
    r"|(?P<block>^(?P<indent>[ \t]*)\$\$(?P<inside>.+?)\$\$[ \t]*$)"
    r"|(?P<safe>\$`[^`]+`\$)"
    r"|(?P<code>(?P<ticks>`+)(?!`).+?(?<!`)(?P=ticks)(?!`))"
    r"|(?<![\\$])\$(?!\$)(?P<formula>(?=\S)(?:[^$\n]|\n(?!\s*\n))*?[^\s$\\])\$(?!\$)",
    re.DOTALL | re.MULTILINE)


def mended(text):
    """The text as it should be; what it mends and what only a person can mend, each as (line, text)."""
    mends, faults = [], []

    def line_of(found):
        return text.count("\n", 0, found.start()) + 1

    def block(found):
        if not RISKY.search(found["inside"]):
            return found[0]
        mends.append((line_of(found), "GitHub would misread this block of formulas: write it as ```math"))
        lines = [line.strip() for line in found["inside"].strip().split("\n")]
        return "\n".join(found["indent"] + line for line in ["```math", *lines, "```"])

    def piece(found):
        if found["fence"] or found["code"]:
            return found[0]
        if found["block"]:
            return block(found)
        before, after = text[:found.start()][-1:], text[found.end():][:1]
        if re.match(r"[\w-]", before) or re.match(r"\w", after):
            faults.append((line_of(found), f"'{before}{found[0]}{after}' touches a word: GitHub shows the dollars"))
        if re.search(r"\n\s*([-+*>#]\s|\d+[.)]\s)", found[0]):
            faults.append((line_of(found), "a line of this formula begins as a list does: wrap it elsewhere"))
        if found["safe"] or not RISKY.search(found["formula"]):
            return found[0]
        mends.append((line_of(found), f"GitHub would misread {found[0]}: write it as $`{found['formula']}`$"))
        return f"$`{found['formula']}`$"

    return PIECES.sub(piece, text), mends, faults


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="*", type=Path)
    parser.add_argument("--mend", action="store_true", help="rewrites the pages")
    arguments = parser.parse_args()
    root = Path(__file__).resolve().parents[2]
    left = 0
    for page in arguments.pages or [*sorted((root / "docs").rglob("*.md")), *sorted(root.glob("*/README.md"))]:
        text, mends, faults = mended(page.read_text(encoding="utf-8"))
        if arguments.mend and mends:
            page.write_text(text, encoding="utf-8")
            mends = []
        for number, fault in sorted(mends + faults):
            print(f"{page}:{number}: {fault}", file=sys.stderr)
            left += 1
    if left:
        print(f"{left} formulas; tests/house/formulas.py --mend rewrites most", file=sys.stderr)
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
