#!/usr/bin/env python3
"""Refuses dead links in the pages, names of pages in the sources that no page has, and names of sources that are gone.

usage: links.py [FOLDER]

FOLDER is the repository (default: the one that holds this script). Checked are README.md, CHANGELOG.md, docs/**/*.md and
the README.md of each top folder: every relative link and picture must name a file of the repository, and every #anchor
a heading of its page, by the rule that GitHub makes anchors with. Links with a scheme (https:) are not followed: the check needs no network. In sources,
scripts and scenes, every page that is named by its path from docs/ must exist. In pages, so must every source that is
named by its path in backticks, as `core/base/{log,error}.h` or `contact/law/*`; names in capitals stand for others.
In docs/develop and in the README.md of a folder, a path of a source that does not start at the top must end the path
of some file, as `shared/budget.h` does. In blocks of code, every #include "..." must name a file, and every
literalinclude a file that holds the lines by which it starts and ends.
Exit code 1 where something is dead, with file and line.
"""
import glob
import os
import re
import sys
import urllib.parse
from pathlib import Path

SOURCE_FOLDERS = ("core", "contact", "hydro", "fracture", "nilas", "python", "packaging", "apps", "tests")
SOURCE_SUFFIXES = {".cpp", ".h", ".py", ".sh", ".txt", ".xml", ".awk"}
# Files that the reader of a page writes.
TO_BE_WRITTEN = {"hydro/push.cpp", "tests/contact/solvers/jacobi_test.cpp"}
# Files of a user, as examples name them.
NAMES_OF_USERS = {"jacobi.h", "jacobi.cpp", "scene.xml", "s.xml"}
PAGE_NAME = re.compile(r"\bdocs/[\w/-]+\.md\b")
CODE_PATH = re.compile(r"`((?:core|contact|hydro|fracture|apps|tests)/[\w./*{},-]*)`")
LOCAL_PATH = re.compile(r"`((?:[\w-]+/)*[\w.-]+\.(?:cpp|h|py|awk|xml))`")
INCLUDE = re.compile(r"\s*#\s*include\s*\"([^\"]+)\"")
LITERALINCLUDE = re.compile(r"\s*`{3,}\{literalinclude\}\s+(\S+)")
OPTION = re.compile(r"\s*:([\w-]+):\s*(.*)$")
LINK = re.compile(r"!?\[(?:[^\[\]]|\[[^\]]*\](?:\([^)]*\))?)*\]\(\s*<?([^)\s>]+)>?(?:\s+[\"'][^)]*)?\)")
DEFINITION = re.compile(r"^ {0,3}\[[^\]]+\]:\s+<?(\S+?)>?(?:\s|$)")
HTML_LINK = re.compile(r"<(?:a|img)\b[^>]*?\b(?:href|src)=[\"']([^\"']+)[\"']")
HTML_ANCHOR = re.compile(r"<\w+\b[^>]*?\b(?:id|name)=[\"']([^\"']+)[\"']")


def prose_lines(text):
    """Number and text of each line outside code blocks; comments and inline code are blanked."""
    text = re.sub(r"<!--.*?-->", lambda m: "\n" * m[0].count("\n"), text, flags=re.DOTALL)
    fence = None
    for number, line in enumerate(text.split("\n"), 1):
        mark = re.match(r" {0,3}(`{3,}|~{3,})", line)
        if fence:
            if mark and mark[1].startswith(fence) and not line.strip().strip(fence[0]):
                fence = None
            continue
        if mark:
            fence = mark[1]
            continue
        yield number, line


def anchor_of(heading):
    """What GitHub makes of a heading: lower case, spaces to hyphens, other signs than letters, digits, - and _ dropped."""
    heading = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", heading)
    parts = re.split(r"(`[^`]*`)", heading)
    heading = "".join(p if p.startswith("`") else re.sub(r"<[^>]+>", "", p) for p in parts)
    return re.sub(r"[^\w\- ]", "", heading.strip().lower()).replace(" ", "-")


def anchors(path):
    found, counts = set(), {}
    for _, line in prose_lines(path.read_text(encoding="utf-8")):
        found.update(HTML_ANCHOR.findall(line))
        heading = re.match(r" {0,3}#{1,6}\s+(.*?)\s*#*\s*$", line)
        if not heading:
            continue
        name = anchor_of(heading[1])
        count = counts.get(name, 0)
        counts[name] = count + 1
        found.add(f"{name}-{count}" if count else name)
    return found


def exact_case(path, root):
    """Whether a path exists with just these letters, on file systems that do not tell capitals too."""
    inside = [part for part in (path, *path.parents) if part != root and part.is_relative_to(root)]
    return all(part.name in os.listdir(part.parent) for part in inside)


def fault_of_link(target, page, root, known):
    if re.match(r"[a-zA-Z][a-zA-Z0-9+.-]*:|//", target):
        return None
    name, _, anchor = urllib.parse.unquote(target).partition("#")
    if name.startswith("/"):
        return "is absolute; links are relative to their page"
    path = Path(os.path.normpath(page.parent / name)) if name else page
    if not path.is_relative_to(root):
        return "leaves the repository"
    if not path.exists() or not exact_case(path, root):
        return "names no file"
    if not anchor:
        return None
    if path.suffix != ".md":
        return None
    if path not in known:
        known[path] = anchors(path)
    return None if anchor in known[path] else f"names no heading of {path.relative_to(root)}"


def faults_of_page(page, root, known):
    for number, line in prose_lines(page.read_text(encoding="utf-8")):
        line = re.sub(r"(`+)(?!`).*?(?<!`)\1(?!`)", lambda m: "`" if "](" not in m[0] else " ", line)
        targets = LINK.findall(line) + DEFINITION.findall(line) + HTML_LINK.findall(line)
        # a picture that is a link: [![..](a)](b)
        targets += re.findall(r"!\[[^\]]*\]\(([^)\s]+)\)", line)
        for target in dict.fromkeys(targets):
            fault = fault_of_link(target, page, root, known)
            if fault:
                yield number, f"'{target}' {fault}"


def faults_of_source(path, root):
    for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").split("\n"), 1):
        for name in PAGE_NAME.findall(line):
            if not (root / name).exists():
                yield number, f"'{name}' is no page"


def code_lines(text):
    """Number and text of each line that stands in a block of code, the line that opens it included."""
    outside = {number for number, _ in prose_lines(text)}
    for number, line in enumerate(text.split("\n"), 1):
        if number not in outside:
            yield number, line


def fault_of_excerpt(options, path):
    """What is wrong with the lines by which an excerpt of a file starts and ends, found as Sphinx finds them."""
    lines = path.read_text(encoding="utf-8").split("\n")
    for option in ("start-at", "start-after"):
        if option in options:
            found = [k for k, line in enumerate(lines) if options[option] in line]
            if not found:
                return f"has no line with '{options[option]}'"
            lines = lines[found[0] + (option == "start-after"):]
    for option in ("end-at", "end-before"):
        first = int(option == "end-before")
        if option in options and not any(options[option] in line for line in lines[first:]):
            return f"has no line with '{options[option]}' after its start"
    return None


def faults_of_code_blocks(page, root):
    lines = list(code_lines(page.read_text(encoding="utf-8")))
    for k, (number, line) in enumerate(lines):
        include = INCLUDE.match(line)
        if include and not (root / include[1]).is_file():
            yield number, f"'{include[1]}' is no file to include"
        excerpt = LITERALINCLUDE.match(line)
        if not excerpt:
            continue
        path = Path(os.path.normpath(page.parent / excerpt[1]))
        if not path.is_file():
            yield number, f"'{excerpt[1]}' names no file"
            continue
        options = {}
        for _, below in lines[k + 1:]:
            option = OPTION.match(below)
            if not option:
                break
            options[option[1]] = option[2].strip().strip("'")
        fault = fault_of_excerpt(options, path)
        if fault:
            yield number, f"'{excerpt[1]}' {fault}"


def faults_of_local_names(page, root, files):
    """Paths that do not start at the top: they must end the path of some file, so that only sure faults are found."""
    for number, line in prose_lines(page.read_text(encoding="utf-8")):
        for name in LOCAL_PATH.findall(line):
            stands_for_others = re.search(r"[A-Z]{3}", name)
            written = any(("/" + path).endswith("/" + name) for path in TO_BE_WRITTEN)
            if not stands_for_others and not written and name not in files and name not in NAMES_OF_USERS:
                yield number, f"'{name}' ends the path of no file of the repository"


def ends_of_paths(root):
    """Every end of the path of every source: a.h, contact/a.h, ..."""
    found = set()
    for folder in (*SOURCE_FOLDERS, "docs"):
        for path in (root / folder).rglob("*"):
            parts = path.relative_to(root).parts
            found.update("/".join(parts[k:]) for k in range(len(parts)))
    return found


def alternatives(path):
    """`a/{b,c}.h` names two files."""
    found = re.search(r"\{([^}]*)\}", path)
    if not found:
        return [path]
    return [each for word in found[1].split(",") for each in alternatives(path[:found.start()] + word + path[found.end():])]


def faults_of_code_names(page, root):
    for number, line in prose_lines(page.read_text(encoding="utf-8")):
        for name in CODE_PATH.findall(line):
            for path in alternatives(name):
                stands_for_others = re.search(r"[A-Z]{3}", path.removesuffix("README.md"))
                if not stands_for_others and path not in TO_BE_WRITTEN and not glob.glob(str(root / path)):
                    yield number, f"'{path}' is no file of the repository"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]).resolve()
    pages = [root / "README.md", root / "CHANGELOG.md", *sorted((root / "docs").rglob("*.md")),
             *(page for page in sorted(root.glob("*/README.md")) if page.parent.name in SOURCE_FOLDERS)]
    sources = [path for folder in SOURCE_FOLDERS for path in sorted((root / folder).rglob("*"))
               if path.suffix in SOURCE_SUFFIXES and path.is_file()]
    known, count = {}, 0
    faults = [(path, *fault) for path in pages for fault in faults_of_page(path, root, known)]
    faults += [(path, *fault) for path in pages + sources for fault in faults_of_source(path, root)]
    faults += [(path, *fault) for path in pages if path.name != "CHANGELOG.md" for fault in faults_of_code_names(path, root)]
    faults += [(path, *fault) for path in pages if path.name != "CHANGELOG.md" for fault in faults_of_code_blocks(path, root)]
    files = ends_of_paths(root)
    for path in pages:
        if path.parent == root / "docs/develop" or path.name == "README.md" and path.parent != root:
            faults += [(path, *fault) for fault in faults_of_local_names(path, root, files)]
    for path, number, text in faults:
        count += 1
        print(f"{path.relative_to(root)}:{number}: {text}", file=sys.stderr)
    if count:
        print(f"{count} dead links", file=sys.stderr)
    return 1 if count else 0


if __name__ == "__main__":
    sys.exit(main())
