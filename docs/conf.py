"""How `./dev docs` makes a site of these pages, by Sphinx with the MyST reader of Markdown.

The pages are plain Markdown as GitHub shows it: this file adds the navigation, so that no page names the site.
A new page appears in the navigation of its folder; READING_ORDER only says which come first.
Formulas are turned into HTML by KaTeX (docs/site/katex.js) while the site is built, and no page needs a network.
"""
import html
import json
import re
import shutil
import subprocess
import sys
from pathlib import Path

from docutils import nodes
from sphinx.util import logging

DOCS = Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(DOCS.parent / "tests/house"))
from formulas import PIECES  # noqa: E402

KATEX = Path("/usr/share/javascript/katex")  # of Debian's libjs-katex
log = logging.getLogger(__name__)

SECTIONS = {
    "tutorial": "Tutorial",
    "howto": "How to",
    "reference": "Reference",
    "theory": "Theory",
    "evidence": "Evidence",
    "develop": "Develop",
}
READING_ORDER = {
    "howto": ["write-a-scene", "full-scale", "prepare-a-hull", "place-the-vessel", "tow-with-six-cells",
              "pods-rudders-barges", "rods", "ice-fields", "crushing", "breaking", "resume-and-long-runs", "ice-load", "load-statistics", "trust-a-step",
              "contact-forces", "compare-settings", "validate", "check-the-program", "one-contact-problem", "compare-solvers"],
    "reference": ["scene", "outputs", "command-line", "conventions", "scales"],
    "theory": ["contact", "dynamics", "vessel", "hull", "water", "ice-field", "fracture", "fracture-crushing",
               "fracture-breaking", "fracture-cutting", "load-error", "report", "load-statistics", "compare"],
    "evidence": ["verification", "validation", "validation-scenes", "validation-symmetry", "validation-breaking",
                 "validation-contacts", "validation-solvers", "validation-loads", "validation-statistics", "validation-formulas", "validation-results",
                 "reliability", "reliability-faults", "reliability-fuzzing", "reliability-view", "reliability-scenes",
                 "reliability-long", "reliability-size", "reliability-builds", "limits", "limitations"],
    "develop": ["architecture", "contributing"],
}

project = "Nilas"
version = release = re.search(r"project\(nilas VERSION (\S+)", (DOCS.parent / "CMakeLists.txt").read_text())[1]
language = "en"
exclude_patterns = ["README.md", "figures/*.md", "site"]
highlight_language = "none"
suppress_warnings = ["misc.highlighting_failure"]  # pieces of a scene with "..." in them
smartquotes = False  # they would turn the two hyphens of an option into a dash

extensions = ["myst_parser"]
myst_enable_extensions = ["dollarmath", "tasklist"]
myst_dmath_allow_labels = False
myst_dmath_allow_space = False  # as GitHub reads dollars
myst_dmath_allow_digits = False
myst_heading_anchors = 6
# What MyST reads in Markdown beyond GitHub: a line that wraps before "% broken" would vanish as a comment.
myst_disable_syntax = ["myst_line_comment", "myst_block_break", "myst_target", "myst_role"]

html_theme = "furo"
html_title = f"Nilas {version}"
html_static_path = ["site/site.css"]
html_css_files = ["katex/katex.min.css", "site.css"]
html_math_renderer = "katex"
html_copy_source = html_show_sourcelink = html_show_copyright = html_show_sphinx = False


def pages_of(folder):
    """Those of READING_ORDER, each followed by the pages that begin with its name, then all others by name."""
    first = READING_ORDER.get(folder, [])

    def place(name):
        heads = [head for head in first if name == head or name.startswith(head + "-")]
        return (first.index(max(heads, key=len)) if heads else len(first), name)

    return sorted((page.stem for page in (DOCS / folder).glob("*.md")), key=place)


def add_navigation(app, docname, source):
    """The first page lists the pages of every folder, for the site alone."""
    if docname != "index":
        return
    folders = [page.parent.name for page in sorted(DOCS.glob("*/*.md")) if page.parent.name not in ("figures", "site")]
    for folder in sorted(set(folders), key=lambda name: ([*SECTIONS, name].index(name), name)):
        caption = SECTIONS.get(folder, folder.capitalize())
        entries = "\n".join(f"{folder}/{name}" for name in pages_of(folder))
        source[0] += f"\n```{{toctree}}\n:hidden:\n:maxdepth: 1\n:caption: {caption}\n\n{entries}\n```\n"


def read_formulas_as_github(app, docname, source):
    """$`...`$ and blocks of ```math are formulas to GitHub, but not to MyST."""
    def piece(found):
        if found["safe"]:
            return f"${found['safe'][2:-2]}$"
        math = re.fullmatch(r"([ \t]*)```math[ \t]*(\n.*\n)[ \t]*```[ \t]*", found["fence"] or "", re.DOTALL)
        return f"{math[1]}$${math[2]}{math[1]}$$" if math else found[0]

    source[0] = PIECES.sub(piece, source[0])


def keep_errors_together(app, docname, source):
    """"83.5 ± 11.6" in a narrow cell of a table would stand in three lines."""
    def cells(row):
        return row[0].replace(" ± ", "\u00a0±\u00a0")

    source[0] = re.sub(r"^\|.*$", cells, source[0], flags=re.MULTILINE)


def unlink_outside_pages(app, docname, source):
    """Markdown outside docs/ (the changelog, the readme) is not on the site: its links become their text."""
    def text_of(link):
        target = (DOCS / docname).parent / link[2]
        inside = target.resolve().is_relative_to(DOCS)
        return link[0] if inside or not target.exists() else link[1]

    source[0] = re.sub(r"\[([^\]]+)\]\(((?:\.\./)+[^)#\s]+\.md)(?:#[^)]*)?\)", text_of, source[0])


class Katex:
    """One node process that turns formulas into HTML, a line of JSON for each."""

    process = None

    @classmethod
    def render(cls, formula, display, node):
        if cls.process is None:
            cls.process = subprocess.Popen(
                ["node", str(DOCS / "site/katex.js"), str(KATEX / "katex.js")],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
        cls.process.stdin.write(json.dumps({"formula": formula, "display": display}) + "\n")
        cls.process.stdin.flush()
        answer = json.loads(cls.process.stdout.readline())
        if "error" in answer:
            log.warning("formula %r: %s", formula, answer["error"], location=node)
        return answer.get("html", "")

    @classmethod
    def stop(cls):
        if cls.process is not None:
            cls.process.stdin.close()
            cls.process.wait()
            cls.process = None


def visit_inline_formula(self, node):
    self.body.append(Katex.render(node.astext(), False, node))
    raise nodes.SkipNode


def visit_formula_block(self, node):
    self.body.append(f'<div class="formula">{Katex.render(node.astext(), True, node)}</div>\n')
    raise nodes.SkipNode


def escape_titles(index):
    """Sphinx's search shows headings as HTML, where one like `<friction>` would be a tag and not be seen."""
    prefix = "Search.setIndex("
    content = json.loads(index.read_text(encoding="utf-8").removeprefix(prefix).removesuffix(")"))
    content["alltitles"] = {html.escape(title): places for title, places in content["alltitles"].items()}
    index.write_text(f"{prefix}{json.dumps(content)})", encoding="utf-8")


def finish(app, exception):
    Katex.stop()
    if exception is not None:
        return
    escape_titles(Path(app.outdir) / "searchindex.js")
    target = Path(app.outdir) / "_static/katex"
    (target / "fonts").mkdir(parents=True, exist_ok=True)
    shutil.copy(KATEX / "katex.min.css", target)
    for font in (KATEX / "fonts").glob("*.woff2"):
        shutil.copy(font, target / "fonts")


def setup(app):
    app.add_html_math_renderer("katex", (visit_inline_formula, None), (visit_formula_block, None))
    app.connect("source-read", read_formulas_as_github)
    app.connect("source-read", keep_errors_together)
    app.connect("source-read", unlink_outside_pages)
    app.connect("source-read", add_navigation)
    app.connect("build-finished", finish)
