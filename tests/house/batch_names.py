"""Tells which sources of a library give one name to two things, so that they could not be compiled in one batch.

A batch is one translation unit, in which all unnamed namespaces of a namespace are one. So the name of a constant, a
type or a function without linkage may not stand in another file of the library, in the same namespace. Functions may
share a name if the types of their parameters differ. Libraries and what is compiled apart are read from CMakeLists.txt.
"""
import collections
import pathlib
import re
import sys

import measure

ROOT = pathlib.Path(__file__).parents[2]
TOPS = ("core", "contact", "hydro", "fracture", "apps")
# Sources with one of these properties are compiled apart, by their own flags or on request.
APART = r"SKIP_UNITY_BUILD_INCLUSION|COMPILE_OPTIONS|COMPILE_DEFINITIONS|COMPILE_FLAGS|INCLUDE_DIRECTORIES"

NAMESPACE = re.compile(r"\s*(?:inline\s+)?namespace\b\s*([\w:]*)\s*$")
TYPE = re.compile(r"\s*(?:template\s*<.*>\s*)?(?:struct|class|union|enum(?:\s+class|\s+struct)?)\s+"
                  r"(?:alignas\s*\([^)]*\)\s*)?(\w+)\s*(?:final\b|:|$)", re.S)
ALIAS = re.compile(r"\s*(?:template\s*<.*>\s*)?using\s+(\w+)\s*=|\s*namespace\s+(\w+)\s*=", re.S)
STATIC = re.compile(r"\s*(?:template\s*<.*>\s*)?static\b", re.S)
TYPE_WORDS = {"bool", "char", "double", "float", "int", "long", "short", "signed", "unsigned", "const", "auto"}

# kind: a word, or the types of the parameters; local: whether it has no linkage
Name = collections.namedtuple("Name", "namespace name kind local line")


def libraries():
    """Yields the name of every library that is compiled in batches, with its headers and sources."""
    for top in TOPS:
        cmake = re.sub(r"#.*", "", (ROOT / top / "CMakeLists.txt").read_text())
        apart = set()
        for files in re.findall(rf"set_source_files_properties\(([^)]*?)\sPROPERTIES[^)]*?(?:{APART})", cmake):
            apart |= {ROOT / top / file for file in files.split()}
        for files in re.findall(rf"set_property\(SOURCE\s([^)]*?)\sAPPEND PROPERTY (?:{APART})", cmake):
            apart |= {ROOT / top / file for file in files.split()}
        found = re.findall(r"nilas_library\((\w+)\s+([\w/]+)", cmake)
        if re.search(r"batch\(nilas\)", cmake):
            found.append(("nilas", "apps/nilas"))
        for name, folder in found:
            if not re.search(rf"set_target_properties\({name} PROPERTIES UNITY_BUILD OFF", cmake):
                files = sorted(file for suffix in ("h", "cpp") for file in (ROOT / folder).rglob("*." + suffix))
                yield name, [file for file in files if file not in apart and "peers" not in file.parts]


def split_at_commas(text):
    """The parts of a list of parameters; commas within brackets separate nothing."""
    parts, depth = [""], 0
    for character in text:
        depth += {"<": 1, "(": 1, "{": 1, "[": 1, ">": -1, ")": -1, "}": -1, "]": -1}.get(character, 0)
        if character == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += character
    return [part for part in parts if part.strip()]


def type_of(parameter):
    """The type of a parameter, without its name, its default, namespaces and blanks."""
    parameter = re.sub(r"\s*=.*", "", parameter, flags=re.S)
    parameter = re.sub(r"\w+\s*::\s*", "", parameter).strip()
    unnamed = re.sub(r"(?<=[\w>&*\s])\b\w+$", "", parameter).strip()
    named = unnamed and unnamed != "const" and parameter.split()[-1] not in TYPE_WORDS
    kind = unnamed if named else parameter
    if not re.search(r"[&*]", kind):
        kind = re.sub(r"\bconst\b", "", kind)  # of a value, it is no part of the signature
    return re.sub(r"\s", "", kind)


def declared(header):
    """The name and the kind of what this text at the level of a namespace declares, or None."""
    header = re.sub(r"\[\[.*?\]\]|__attribute__\s*\(\(.*?\)\)|\bNILAS_[A-Z_]+\b", " ", header, flags=re.S)
    if re.match(r"\s*(static_assert|friend)\b", header):
        return None
    if found := ALIAS.match(header):
        return found.group(1) or found.group(2), "alias" + re.sub(r"\s", "", header.split("=", 1)[1])
    if found := TYPE.match(header):
        return found.group(1), "type"
    function = measure.opens_function(header)
    if function and "::" not in function:
        begin = header.index("(", re.search(re.escape(function).replace(r"\ ", r"\s*") + r"\s*\(", header).end() - 1)
        end = measure.closing(header, begin)
        return function, "(" + ", ".join(type_of(p) for p in split_at_commas(header[begin + 1 : end])) + ")"
    if re.match(r"\s*(using|template|extern)\b", header) or function:
        return None
    found = re.search(r"(\w+)\s*(?:\[[^\]]*\]\s*)*(?:\(|$)", re.split(r"(?<![<>=!])=(?!=)", header)[0].rstrip())
    return (found.group(1), "variable") if found and len(header.split()) > 1 else None


def names(file):
    """Yields the names that a file declares in namespaces, not those in types and functions."""
    code = measure.bare(file.read_text())
    scopes, start, depth, head = [], 0, 0, None  # depth: of the braces within a declaration
    for i, character in enumerate(code):
        if character == "{" and depth == 0 and (found := NAMESPACE.match(code[start:i])):
            scopes.append(found.group(1))
            start = i + 1
        elif character == "{":
            if depth == 0 and head is None and not is_within(code[start:i]):
                head = code[start:i]
            depth += 1
        elif character == "}" and depth == 0:
            scopes.pop()
            start = i + 1
        elif character == "}":
            depth -= 1
        if depth > 0 or not (character == ";" or (character == "}" and head and is_function(head))):
            continue
        header, at = head if head is not None else code[start:i], start
        start, head = i + 1, None
        if header.strip() and (found := declared(header)):
            local = "" in scopes or bool(STATIC.match(header)) or found[1] == "variable"
            line = code.count("\n", 0, at + len(header) - len(header.lstrip())) + 1
            yield Name("::".join(scope for scope in scopes if scope), *found, local, line)


def is_function(head):
    return not TYPE.match(head) and measure.opens_function(head) is not None


def is_within(head):
    """Whether the brace after this text is that of a default argument, or of a member in a constructor's list."""
    if head.count("(") > head.count(")"):
        return True
    ends_as_body = re.search(r"\b(const|noexcept|override|final)\s*$", head)
    return re.search(r"\)[^():]*:(?!:)", head) and re.search(r"[\w>]\s*$", head) and not ends_as_body


def clash(a, b):
    """Whether two names of two files could not be in one batch."""
    if not a.local and not b.local:
        return False
    if a.kind[0] == "(" and b.kind[0] == "(":
        return a.kind == b.kind
    return not (a.kind.startswith("alias") and a.kind == b.kind)


def faults():
    for library, files in libraries():
        seen = collections.defaultdict(list)
        for file in files:
            for name in dict.fromkeys(names(file)):
                first = next((f for f, n in seen[name.namespace, name.name] if f != file and clash(n, name)), None)
                seen[name.namespace, name.name].append((file, name))
                if first:
                    yield (f"{file.relative_to(ROOT)}:{name.line}: {name.name} is also in {first.relative_to(ROOT)}, "
                           f"which {library} may compile in the same batch")


def main():
    found = list(faults())
    print("\n".join(found) or "Names without linkage differ within each library.")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
