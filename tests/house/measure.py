#!/usr/bin/env python3
"""Measures the structure of the sources: folders, time step, functions, comments, casts, lines of code, sentences.

usage: measure.py [ROOT]

ROOT is the root of a source tree of Nilas, the one of this script by default. Any other revision can be measured for
comparison:

    git archive REVISION | tar x -C /tmp/old && tests/house/measure.py /tmp/old

The script judges nothing: the limits are those of tests/house/*_test.cpp.
"""
import argparse
import collections
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
import words  # noqa: E402  (it stands beside this script)

PRODUCT = ("core", "contact", "hydro", "fracture", "apps")
MOST_STEMS = 20
MOST_LINES = 60

# Where the time step lies: one file per concern since the step became a function, files of one object before.
STEP_FILES = ("core/sim/simulation*.cpp", "core/sim/step/*.cpp")
STEP_FUNCTIONS = ("take_step", "Simulation::World::part_of_step", "Simulation::step", "Simulation::World::step")
# A condition branches on an optional feature where an identifier has one of these words between its underscores.
FEATURES = {
    "crushing", "breaking", "pieces", "vessel", "carriage", "structures", "reference", "detection", "theta", "booked",
    "moments", "gyroscopic",
}
FEATURE_NAMES = {"hit_when_met", "position_step", "static_friction", "warm_start", "Detection", "PositionStep"}

PREPOSITIONS = {
    "about", "above", "across", "after", "against", "along", "among", "around", "as", "at", "before", "behind", "below",
    "beneath", "beside", "between", "beyond", "by", "down", "during", "except", "for", "from", "in", "inside", "into",
    "like", "near", "of", "off", "on", "onto", "out", "outside", "over", "past", "per", "since", "through", "to",
    "toward", "towards", "under", "until", "up", "upon", "with", "within", "without",
}


def sources(root, tops):
    """Headers and sources below these top folders, sorted."""
    found = [f for top in tops for f in (root / top).rglob("*") if f.suffix in (".h", ".cpp")]
    return sorted(found)


def read(file):
    return file.read_text(encoding="utf-8")


def folder_of(root, file):
    return file.parent.relative_to(root).as_posix()


# --- the text of a source ---

TOKEN = re.compile(
    r"""//[^\n]*|/\*.*?\*/"""  # comments
    r"""|R"(?P<mark>[^(\s]{0,16})\(.*?\)(?P=mark)\""""  # raw strings
    r"""|"(?:\\.|[^"\\\n])*\""""  # strings
    r"""|(?<![0-9A-Za-z_])'(?:\\.|[^'\\\n])+'"""  # characters, not the separators of digits
    r"""|^[ \t]*\#(?:[^\n\\]|\\.)*(?:\\\n(?:[^\n\\]|\\.)*)*""",  # directives
    re.DOTALL | re.MULTILINE | re.VERBOSE,
)


def bare(text):
    """The text with comments, literals and directives blanked, every character and line at its place."""

    def blank(match):
        whole = match.group(0)
        inner = re.sub(r"[^\n]", " ", whole)
        if whole[0] in "\"'" or whole.startswith("R\""):
            return '"' + inner[1:-1] + '"' if len(inner) > 1 else inner
        return inner

    return TOKEN.sub(blank, text)


Function = collections.namedtuple("Function", "name first last begin end")  # lines; and the body's characters


def opens_function(header):
    """The name of the function whose body a brace after this text opens, or None."""
    header = re.sub(r"\[\[.*?\]\]", " ", header, flags=re.DOTALL)
    header = re.sub(r"^\s*(public|private|protected)\s*:(?!:)", " ", header)
    if not re.search(r"\)", header) or re.match(r"\s*(namespace|extern)\b", header):
        return None
    depth, parameters = 0, -1
    for i, character in enumerate(header):  # the first bracket outside of <> that follows a name
        named_operator = "operator" in header[max(0, i - 10) : i]
        if character == "<" and re.search(r"(template\s*|[\w])$", header[:i]) and not named_operator:
            depth += 1
        elif character == ">" and depth > 0 and header[i - 1] != "-":
            depth -= 1
        elif character == "(" and depth == 0 and re.search(r"[\w>\]=+*/<!&|)~-]\s*$", header[:i]):
            parameters = i
            if re.search(r"operator\s*$", header[:i]):
                continue  # operator()(...)
            break
    if parameters < 0:
        return None
    before = header[:parameters]
    if re.search(r"(?<![=!<>])=(?!=)", re.sub(r"operator\s*\S+", "", before)) and "operator" not in before:
        return None  # a variable with an initialiser
    name = re.search(r"((?:[\w]+(?:<[^<>]*>)?\s*::\s*)*(?:operator\s*\S+|~?\w+))\s*$", before)
    if not name or name.group(1) in ("if", "for", "while", "switch", "catch", "return", "decltype", "noexcept"):
        return None
    return re.sub(r"\s+", " ", name.group(1))


def functions(text):
    """Functions with a body, in order; lambdas and local types belong to the function around them."""
    code = bare(text)
    found, stack, start, kept = [], [], 0, 0
    for i, character in enumerate(code):
        if character == ";" and (not stack or stack[-1][0] == "scope"):
            start = i + 1
        elif character == "{":
            inside = not stack or stack[-1][0] == "scope"
            header = re.sub(r"\balignas\s*\([^()]*\)", lambda m: " " * len(m.group(0)), code[start:i])
            initialises = (re.search(r"\)[^():]*:(?!:)", header) and re.search(r"[\w>]\s*$", header)
                           and not re.search(r"\b(const|noexcept|override|final)\s*$", header))
            in_brackets = header.count("(") > header.count(")")  # a default argument
            if not inside or in_brackets or initialises:
                stack.append(("other", None, 0, 0))
                continue
            if re.match(r"(\s*template\s*<.*?>)?[\s\w:\[\]()]*\b(namespace|class|struct|union|extern)\b[^()=]*$",
                        header, re.DOTALL):
                stack.append(("scope", None, 0, 0))
                start = i + 1
                continue
            name = opens_function(header)
            first = start + len(header) - len(header.lstrip())
            stack.append(("function" if name else "value", name, first, i))
        elif character == "}" and stack:
            kind, name, first, begin = stack.pop()
            if kind == "function":
                lines = [code.count("\n", 0, at) + 1 for at in (first, i)]
                found.append(Function(name, lines[0], lines[1], begin, i + 1))
            if kind != "other" and (not stack or stack[-1][0] == "scope"):
                start = i + 1
    return found


# --- branches ---


def closing(code, opening):
    """The position at which the bracket that opens at `opening` closes."""
    depth = 0
    for i in range(opening, len(code)):
        depth += {"(": 1, ")": -1}.get(code[i], 0)
        if depth == 0:
            return i
    return len(code) - 1


def conditions(code):
    """The conditions of every if, switch and conditional operator, with their places."""
    for match in re.finditer(r"\b(if|switch)\s*(?:constexpr\s*)?\(", code):
        end = closing(code, match.end() - 1)
        condition = code[match.end() : end]
        yield match.start(), condition.rsplit(";", 1)[-1] if ";" in condition else condition
    for match in re.finditer(r"\?", code):
        depth, i = 0, match.start() - 1
        while i >= 0:
            if code[i] in ")]}":
                depth += 1
            elif code[i] in "([{":
                depth -= 1
            ends = code[i] in ";,?:" and code[i - 1 : i + 1] != "::" and code[i : i + 2] != "::"
            if depth < 0 or (depth == 0 and ends):
                break
            if depth == 0 and code[i] == "=" and code[i - 1] not in "=!<>" and code[i + 1] != "=":
                break
            if depth == 0 and re.match(r"return\b", code[i:]) and not re.match(r"\w", code[i - 1]):
                i += len("return") - 1
                break
            i -= 1
        yield match.start(), code[i + 1 : match.start()]


def features_of(condition):
    found = set()
    for name in re.findall(r"[A-Za-z_]\w*", condition):
        if name in FEATURE_NAMES:
            found.add(name)
        found |= FEATURES & set(name.lower().split("_"))
    return found


def feature_branches(code):
    """Pairs of a place and the features that its condition names."""
    return [(at, f) for at, f in ((at, features_of(c)) for at, c in conditions(code)) if f]


# --- the measures, each prints itself ---


def title(text):
    print(f"\n{text}\n{'-' * len(text)}")


def stems_per_folder(root):
    stems = collections.defaultdict(set)
    for file in sources(root, PRODUCT + ("tests",)):
        stems[folder_of(root, file)].add(file.stem)
    title("Stems per folder (a header and its source count once)")
    sizes = sorted(((len(names), folder) for folder, names in stems.items()), key=lambda s: (-s[0], s[1]))
    for size, folder in sizes:
        print(f"{size:5}  {folder}{'  above ' + str(MOST_STEMS) if size > MOST_STEMS else ''}")
    print(f"{len(sizes)} folders, {sum(1 for s, _ in sizes if s > MOST_STEMS)} above {MOST_STEMS} stems")


def folder_graph(root):
    """The folders that the files of each folder include in quotes, as tests/house/includes_test.cpp reads them."""
    graph = collections.defaultdict(set)
    for file in sources(root, PRODUCT):
        folder = folder_of(root, file)
        for include in re.findall(r'^\s*#\s*include\s*"([^"]+)"', read(file), re.MULTILINE):
            target = include.rpartition("/")[0]
            if target != folder:
                graph[folder].add(target)
    return graph


def reached(graph, start):
    found, open_ones = set(), list(graph.get(start, ()))
    while open_ones:
        folder = open_ones.pop()
        if folder not in found:
            found.add(folder)
            open_ones.extend(graph.get(folder, ()))
    return found


def folder_cycles(root):
    graph = folder_graph(root)
    reach = {folder: reached(graph, folder) for folder in list(graph)}
    groups = {frozenset([f] + [g for g in reach[f] if f in reach.get(g, ())]) for f in graph if f in reach[f]}
    title("Folders that include each other, be it over others")
    for group in sorted(sorted(g) for g in groups):
        print("  " + " <-> ".join(group))
    print(f"{len(groups)} groups, with {sum(len(g) for g in groups)} folders")


def step_branches(root):
    title("Branches on optional features in the time step")
    total, lines, of_step = 0, 0, []
    for file in sorted({f for pattern in STEP_FILES for f in root.glob(pattern)}):
        text = read(file)
        code = bare(text)
        found = feature_branches(code)
        named = collections.Counter(name for _, names in found for name in names)
        named = ", ".join(f"{name} {count}" for name, count in sorted(named.items()))
        print(f"{len(found):5}  {file.relative_to(root)} ({text.count(chr(10))} lines){': ' + named if named else ''}")
        total, lines = total + len(found), lines + text.count("\n")
        for f in functions(text):
            if f.name in STEP_FUNCTIONS:
                of_step.append((f, len(feature_branches(code[f.begin : f.end]))))
    print(f"{total} in these files, with {lines} lines")
    for f, count in of_step:
        print(f"{count:5}  in {f.name}, of {f.last - f.first + 1} lines")
    print(f"{sum(c for _, c in of_step)} in the step function itself")


def function_lengths(root):
    title(f"Functions of more than {MOST_LINES} lines, from the first line of the signature to the closing brace")
    for name, tops in (("product", PRODUCT), ("tests", ("tests",))):
        found = [(f.last - f.first + 1, f, file) for file in sources(root, tops) for f in functions(read(file))]
        lengths = [length for length, _, _ in found]
        long_ones = sorted((s for s in found if s[0] > MOST_LINES), key=lambda s: -s[0])
        for length, f, file in long_ones:
            print(f"{length:5}  {f.name}, {file.relative_to(root)}:{f.first}")
        shares = " ".join(f"p{round(100 * s)} {words.percentile(lengths, s)}" for s in (0.5, 0.9, 0.99))
        print(f"{name}: {len(long_ones)} of {len(found)} functions; {shares}, longest {max(lengths, default=0)}")


def doc_comments(text):
    """First lines of the doc comments: of every block of lines that open with ///, and of every ///< after code."""
    above = False
    for line in text.split("\n"):
        match = re.match(r"\s*///(?!<)\s?(.*)", line)
        if match and not above and match.group(1).strip():
            yield match.group(1).strip()
        above = bool(match)
        trailing = re.search(r"///<\s*(\S.*)", line)
        if trailing:
            yield trailing.group(1)


def comment_openings(root):
    title("Doc comments that open with a preposition, 'What' or 'So that'")
    for name, tops in (("product", PRODUCT), ("tests", ("tests",))):
        count, bad, openings = 0, 0, collections.Counter()
        for file in sources(root, tops):
            for comment in doc_comments(read(file)):
                count += 1
                first = re.match(r"[^\w]*(\w*)(\s+\w+)?", comment)
                opening = first.group(1).lower()
                if opening == "so" and (first.group(2) or "").strip() == "that":
                    opening = "so that"
                if opening in PREPOSITIONS or opening in ("what", "so that"):
                    bad += 1
                    openings[opening] += 1
        most = ", ".join(f"{opening} {n}" for opening, n in openings.most_common(8))
        print(f"{name}: {bad} of {count} ({100 * bad / max(1, count):.1f} %){'; ' + most if most else ''}")


def casts(root):
    title("static_cast<std::size_t>")
    for name, tops in (("product", PRODUCT), ("tests", ("tests",))):
        print(f"{name}: {sum(bare(read(file)).count('static_cast<std::size_t>') for file in sources(root, tops))}")


def lines_of_code(root):
    title("Lines per top folder")
    print(f"{'folder':10} {'files':>6} {'lines':>7} {'of code':>8}")
    sums = [0, 0, 0]
    for top in PRODUCT + ("tests",):
        files = sources(root, (top,))
        texts = [read(f) for f in files]
        # a directive is code: only comments and blank lines are not
        code = [re.sub(r"//[^\n]*|/\*.*?\*/", "", t, flags=re.DOTALL) for t in texts]
        row = [len(files), sum(t.count("\n") for t in texts),
               sum(1 for t in code for line in t.split("\n") if line.strip())]
        sums = [a + b for a, b in zip(sums, row)]
        print(f"{top:10} {row[0]:6} {row[1]:7} {row[2]:8}")
    print(f"{'all':10} {sums[0]:6} {sums[1]:7} {sums[2]:8}")


def sentences(root):
    title("Words per sentence of the pages (tests/house/words.py)")
    print(f"{'page':44} {'words':>6} {'median':>6} {'p90':>4} {'max':>4}")
    every = []
    for page in [root / "README.md"] + sorted((root / "docs").rglob("*.md")):
        lengths = [len(s) for block in words.blocks(read(page)) for s in words.sentences(block)]
        every += lengths
        print(f"{page.relative_to(root).as_posix():44} {sum(lengths):6} {words.percentile(lengths, 0.5):6} "
              f"{words.percentile(lengths, 0.9):4} {max(lengths, default=0):4}")
    print(f"{'all':44} {sum(every):6} {words.percentile(every, 0.5):6} {words.percentile(every, 0.9):4} "
          f"{max(every, default=0):4}")


def main():
    here = pathlib.Path(__file__).resolve().parent.parent.parent
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("root", nargs="?", type=pathlib.Path, default=here)
    root = parser.parse_args().root
    if not (root / "core").is_dir():
        parser.error(f"{root} is no source tree of Nilas: it has no folder core")
    for measure in (stems_per_folder, folder_cycles, step_branches, function_lengths, comment_openings, casts,
                    lines_of_code, sentences):
        measure(root)
    return 0


if __name__ == "__main__":
    sys.exit(main())
