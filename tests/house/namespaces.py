"""Tells which sources declare things in another namespace than that of their folder, or of their file for tests.

A room `a/b` has the namespace nilas::b, a folder below it that of its room; ROOMS lists the exceptions. A block of
another namespace may only name types of another room (`struct X;`). Other libraries' namespaces are not looked at.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).parents[2]
# Every room uses vectors, errors and choices, so their namespace has no name of a room.
ROOMS = {
    "core/base": "nilas",
    "core/choices": "nilas",
    "contact": "nilas::contact",
    "contact/challenge": "nilas::challenge",
    "contact/detect": "nilas::detect",
    "contact/solvers": "nilas::solvers",
    "hydro": "nilas::hydro",
    "fracture": "nilas::fracture",
    "apps/nilas": "nilas::commands",
    "nilas": "nilas",
    "python": "nilas::python",
}
BLOCK = re.compile(r"^namespace (nilas[\w:]*) \{\n(.*?)^\}  // namespace nilas", re.M | re.S)
NAMED_ONLY = re.compile(r"(?:\s*(?:struct|class) \w+;)*\s*")


def namespace_of(folder):
    """Returns the namespace of a folder, given relative to the root."""
    for path in (folder, *folder.parents):
        if str(path) in ROOMS:
            return ROOMS[str(path)]
    return "nilas::" + folder.parts[1]


def tests_without_a_name():
    """Tests are compiled in batches too. Their names may repeat, since the namespace of a test is its file's name."""
    for file in sorted((ROOT / "tests").rglob("*_test.cpp")):
        for name in re.findall(r"^namespace (?!nilas)(.*?) ?\{", file.read_text(), re.M):
            if name != file.stem:
                yield f"{file.relative_to(ROOT)}: namespace {name or 'without a name'} should be {file.stem}"


def faults():
    for top in ("core", "contact", "hydro", "fracture", "apps", "nilas", "python"):
        for file in sorted((ROOT / top).rglob("*")):
            if file.suffix not in (".h", ".cpp") or "peers" in file.parts:
                continue
            name = file.relative_to(ROOT)
            wanted = namespace_of(name.parent)
            for found, content in BLOCK.findall(file.read_text()):
                if found != wanted and not found.startswith(wanted + "::") and not NAMED_ONLY.fullmatch(content):
                    yield f"{name}: namespace {found} should be {wanted}"


def main():
    found = [*faults(), *tests_without_a_name()]
    print("\n".join(found) or "Namespaces are those of the folders.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
