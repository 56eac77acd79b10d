#!/usr/bin/env python3
"""Tells whether two builds of the program have the same bytes.

usage: twice.py FOLDER FOLDER

The folders are build trees, for instance build/release of two clones in different places. Of each product it prints
whether the bytes are the same, else the sections that differ. The exit code is 1 where something differs.
"""
import pathlib
import re
import subprocess
import sys

PRODUCTS = ("nilas", "library/libnilas.so.*", "python/nilas/_core.*.so")


def sections(path: pathlib.Path) -> dict[str, bytes]:
    """The bytes of each section of an ELF file by its name."""
    listed = subprocess.run(["readelf", "-SW", str(path)], stdout=subprocess.PIPE, text=True, check=True).stdout
    data = path.read_bytes()
    found = {}
    for name, kind, offset, size in re.findall(r"\] (\S+)\s+(\S+)\s+[0-9a-f]+ ([0-9a-f]+) ([0-9a-f]+)", listed):
        if kind != "NOBITS":
            found[name] = data[int(offset, 16) : int(offset, 16) + int(size, 16)]
    return found


def differing(one: pathlib.Path, two: pathlib.Path) -> list[str]:
    """The names of the sections that differ."""
    a, b = sections(one), sections(two)
    return sorted(name for name in a.keys() | b.keys() if a.get(name) != b.get(name))


def main() -> int:
    if len(sys.argv) != 3:
        print(__doc__, file=sys.stderr)
        return 2
    one, two = map(pathlib.Path, sys.argv[1:])
    same = True
    for pattern in PRODUCTS:
        paths = [path for path in sorted(one.glob(pattern)) if not path.is_symlink()]
        if not paths:
            print(f"no file {one / pattern}", file=sys.stderr)
            return 2
        for path in paths:
            other = two / path.relative_to(one)
            if not other.exists():
                print(f"no file {other}", file=sys.stderr)
                return 2
            names = [] if path.read_bytes() == other.read_bytes() else differing(path, other) or ["what is in no section"]
            same = same and not names
            print(f"{path.relative_to(one)}: " + ("same bytes" if not names else "differs in " + ", ".join(names)))
    return 0 if same else 1


if __name__ == "__main__":
    sys.exit(main())
