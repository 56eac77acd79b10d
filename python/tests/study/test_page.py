"""The page of a study stands alone, and says what the numbers say."""

import os
import re
import subprocess
import sys
from html.parser import HTMLParser

import pytest
from study_desk import PACKAGE, STAND_IN, STUDY

from nilas.study.carry_out.records import Records
from nilas.study.describe.plan import Plan
from nilas.study.describe.read_study import read_study
from nilas.study.results.collected import collect
from nilas.study.results.findings import findings, headline
from nilas.study.results.response_data import response_data

SAMPLED = """\
name: trial
scene: scene.xml
factors:
  test/@x: {from: 1, to: 3}
  test/@y: {name: width, unit: m, from: 0.1, to: 1, scale: log}
design: {kind: %s, points: 8}
responses: [{channel: ice_load.along.mean_N, name: load}]
"""


class Links(HTMLParser):
    """Collects what a page refers to, and its ids."""

    def __init__(self):
        super().__init__()
        self.refers, self.ids = [], []

    def handle_starttag(self, tag, attributes):
        for name, value in attributes:
            if name in ("href", "src", "xlink:href"):
                self.refers.append(value)
            if name == "id":
                self.ids.append(value)


def links(desk):
    parser = Links()
    parser.feed(desk.table(name="study.html"))
    return parser


@pytest.mark.parametrize("text", [STUDY, SAMPLED % "saltelli", SAMPLED % "latin-hypercube"])
def test_the_page_needs_no_other_file_and_its_links_hold(desk, text):
    desk.write(text)
    code, output = desk.run("-j", "2", page=True)
    assert code == 0, output
    found = links(desk)
    assert len(found.ids) == len(set(found.ids))
    for target in found.refers:
        if target.startswith("data:"):
            continue  # the colours of a scale
        if target.startswith("#"):
            assert target[1:] in found.ids
        else:
            assert (desk.folder / "runs/trial" / target).exists(), target
    page = desk.table(name="study.html")
    assert not re.search(r"(src|url\()\s*=?\s*[\"']?https?:", page)
    # Every run is a mark with its values and a link to its folder.
    assert page.count('<a class="run"') >= len(desk.table().splitlines()) - 1


def test_the_page_is_the_same_each_time(desk):
    desk.write()
    desk.run(page=True)
    before = desk.table(name="study.html")
    desk.run("--collect", page=True)
    assert desk.table(name="study.html") == before


def test_figures_of_the_user_keep_their_look(desk):
    """A study may be carried out from a notebook, which draws in its own way."""
    desk.write()
    code = """
import matplotlib, sys, nilas.study
matplotlib.rcParams["font.size"] = 5
before = matplotlib.rcParams.copy()
code = nilas.study.main(["study.yaml", "--quiet", "--program", sys.argv[1]])
assert dict(matplotlib.rcParams) == dict(before)
assert "matplotlib.pyplot" not in sys.modules, "this chooses a backend"
sys.exit(code)
"""
    answer = subprocess.run(
        [sys.executable, "-c", code, str(STAND_IN)],
        cwd=desk.folder,
        env=os.environ | {"PYTHONPATH": str(PACKAGE), "MPLBACKEND": "svg"},
        capture_output=True,
        text=True,
    )
    assert answer.returncode == 0, answer.stderr
    page = desk.table(name="study.html")
    desk.run("--collect", page=True)
    assert desk.table(name="study.html") == page


def test_sentences_say_what_matters(desk):
    """The load is 10 x + 3 y^2 with noise 1: x explains nearly all, and chance the rest."""
    desk.write(STUDY.replace("seeds: 2", "seeds: 4"))
    desk.run()
    plan = Plan(read_study(desk.folder / "study.yaml", desk.folder / "runs/trial"))
    collected = collect(plan, Records(plan))
    data = response_data(collected, 0)
    told = " ".join(findings(data, data.anova(), data.slopes(), data.sobol()))
    assert "Shares of the scatter that chance does not explain: x 9" in told
    assert "It rises with x, y." in told
    assert "(x 1, y 0)" in told and "(x 3, y 1)" in told
    assert headline(collected) == ["24 runs at 6 points are done."]
