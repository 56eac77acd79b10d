#!/usr/bin/env python3
"""Writes the words of scenes for fuzzing, from the schema that the program prints.

usage: dictionary.py PROGRAM [--check]

With --check it ends with 1 where tests/fuzz/scene.dict is not what it would write.
"""
import pathlib
import re
import subprocess
import sys

FILE = pathlib.Path(__file__).resolve().parent / "scene.dict"


def words_of(xsd):
    for name in re.findall(r'<xs:element name="([^"]+)"', xsd):
        yield f"<{name}"
        yield f"</{name}>"
    for name in re.findall(r'<xs:attribute name="([^"]+)"', xsd):
        yield f' {name}="'
    yield from re.findall(r'<xs:enumeration value="([^"]+)"', xsd)
    yield from ("nan", "-inf", "1e400", "4.9e-324", "-0", "1e-310", "&amp;", "&#0;", "<!--", "-->", "<![CDATA[", "]]>",
                "<!DOCTYPE x [<!ENTITY y ", "\n", "/>", '"')


def escaped(word):
    return "".join(c if " " <= c <= "~" and c not in '\\"' else f"\\x{ord(c):02x}" for c in word)


def main():
    program, check = sys.argv[1], "--check" in sys.argv[2:]
    xsd = subprocess.run([program, "schema", "--xsd"], check=True, capture_output=True, text=True).stdout
    lines = [f'"{escaped(word)}"' for word in dict.fromkeys(words_of(xsd))]
    text = "# Written by tests/fuzz/dictionary.py from the schema of scenes.\n" + "\n".join(lines) + "\n"
    if not check:
        FILE.write_text(text)
    elif FILE.read_text() != text:
        print(f"{FILE.name} is not that of the schema; renew it by tests/fuzz/dictionary.py {program}")
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
