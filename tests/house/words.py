#!/usr/bin/env python3
"""Measures how long the sentences of the pages are.

usage: words.py [--longest N] [--limit P90] [PAGE.md ...]

Without pages, all of docs and the README.md files are read.

A sentence is what ends with a full stop, a question mark, a colon at a line's end, or with its paragraph, list item or
table cell. Code blocks, indented blocks, headings and display formulas do not count; an inline code or an inline formula
counts as one word. A table cell counts only where it has at least nine words, so that short cells do not flatter a page.
With --limit the exit code is 1 if the 90th percentile of any page is above it.
"""
import argparse
import re
import sys
from pathlib import Path

SHORT_CELL = 9
ABBREVIATIONS = re.compile(r"\b(e\.g|i\.e|eq|fig|sec|cf|vs|no|approx|et al|st|dr)\.", re.IGNORECASE)


def blocks(text):
    """The pieces of prose of a page: paragraphs, list items, quotes and long table cells."""
    text = re.sub(r"\A---\n.*?\n---\n", "", text, flags=re.DOTALL)
    text = re.sub(r"^(```|~~~).*?^\1[^\n]*$", "\n", text, flags=re.DOTALL | re.MULTILINE)
    text = re.sub(r"<!--.*?-->", "", text, flags=re.DOTALL)
    text = re.sub(r"\$\$.*?\$\$", " ; ", text, flags=re.DOTALL)
    paragraph = []
    after_blank, in_list = True, False
    for line in text.split("\n") + [""]:
        stripped = line.strip()
        item = re.match(r"(\s*)([-*+]|\d+[.)])\s+(.*)", line)
        code = re.match(r"(    |\t)", line) and after_blank and not in_list
        table = stripped.startswith("|")
        if not stripped or stripped.startswith("#") or item or code or table or stripped.startswith(("!!!", ":::")):
            if paragraph:
                yield " ".join(paragraph)
            paragraph = []
        if item:
            paragraph = [item.group(3)]
            in_list = True
        elif table:
            for cell in stripped.strip("|").split("|"):
                if len(cell.split()) >= SHORT_CELL:
                    yield cell.strip()
        elif stripped and not stripped.startswith(("#", "!!!", ":::")) and not code:
            paragraph.append(stripped.lstrip("> "))
        if not stripped:
            after_blank = True
        elif not code:
            after_blank = False
            if not line.startswith((" ", "\t")) and not item:
                in_list = False


def sentences(block):
    """The sentences of a block, each as a list of words."""
    block = re.sub(r"!\[([^\]]*)\]\([^)]*\)", "", block)
    block = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", block)
    block = re.sub(r"`[^`]*`", "CODE", block)
    block = re.sub(r"\$[^$]+\$", "FORMULA", block)
    block = ABBREVIATIONS.sub(lambda m: m.group(0).replace(".", ""), block)
    for sentence in re.split(r"(?<=[.!?])[\"')\]*_]*\s+(?=[^a-z])|:\s*$", block):
        words = [w for w in sentence.split() if re.search(r"[A-Za-z0-9]", w)]
        if words:
            yield words


def percentile(values, share):
    values = sorted(values)
    return values[min(len(values) - 1, int(share * len(values)))] if values else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("pages", nargs="*")
    parser.add_argument("--longest", type=int, default=0, help="prints the N longest sentences of each page")
    parser.add_argument("--limit", type=float, default=None, help="exit 1 if a page's 90th percentile is above this")
    arguments = parser.parse_args()
    root = Path(__file__).resolve().parents[2]
    all_pages = [*sorted((root / "docs").rglob("*.md")), *sorted(root.glob("README.md")), *sorted(root.glob("*/README.md"))]
    failed = False
    print(f"{'page':44} {'words':>6} {'median':>6} {'p90':>4} {'max':>4} {'over 100 columns':>17}")
    for page in arguments.pages or dict.fromkeys(str(page.relative_to(root)) for page in all_pages):
        text = (Path(page) if arguments.pages else root / page).read_text(encoding="utf-8")
        found = [s for block in blocks(text) for s in sentences(block)]
        lengths = [len(s) for s in found]
        wide = sum(1 for line in text.split("\n") if len(line) > 100 and not line.startswith(("|", "    ", "![")))
        p90 = percentile(lengths, 0.9)
        print(f"{page:44} {sum(lengths):6} {percentile(lengths, 0.5):6} {p90:4} {max(lengths, default=0):4} {wide:17}")
        for words in sorted(found, key=len, reverse=True)[: arguments.longest]:
            print(f"    {len(words):4}: {' '.join(words)}")
        failed = failed or (arguments.limit is not None and p90 > arguments.limit)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
