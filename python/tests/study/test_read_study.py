"""Faults of a study file are told all at once, with line, key and remedy."""

import pytest

from nilas.study.describe.faults import StudyError
from nilas.study.describe.read_study import read_study

GOOD = {
    "scene": "scene.xml",
    "factors": "{test/@x: [1, 2]}",
    "responses": "[ice_load.along.mean_N]",
}


def written(desk, **changes):
    entries = GOOD | changes
    return desk.write(
        "".join(f"{key}: {value}\n" for key, value in entries.items() if value is not None)
    )


def told(desk, **changes):
    with pytest.raises(StudyError) as caught:
        read_study(written(desk, **changes))
    assert caught.value.code == 2
    return str(caught.value)


@pytest.mark.parametrize(
    ("changes", "line", "words"),
    [
        ({"sceen": "a"}, 4, ["sceen: There is no such key", "Did you mean 'scene'?"]),
        ({"scene": "other.xml"}, 1, ["There is no file", "other.xml"]),
        ({"factors": "{speed: [1]}"}, 2, ["'speed' is no path", "vessel/carriage/@speed"]),
        ({"factors": "{test/@x: []}"}, 2, ["a list such as"]),
        ({"factors": "{test/@x: [1, 1.0]}"}, 2, ["The value 1 stands in the list twice"]),
        ({"factors": "{test/@x: {from: 1}}"}, 2, ["'to' is missing"]),
        ({"factors": "{test/@x: {from: 3, to: 1, steps: 2}}"}, 2, ["not above its start 3"]),
        ({"factors": "{test/@x: {from: 0, to: 1, steps: 3, scale: log}}"}, 2, ["start above 0"]),
        ({"factors": "{test/@x: {from: a, to: 1, steps: 3}}"}, 2, ["'a' stands here; a number"]),
        ({"factors": "{test/@x: {from: 0, to: 1}}"}, 2, ["needs steps"]),
        ({"factors": "{test/@x: {name: 'a b', values: [1]}}"}, 2, ["is no name"]),
        ({"factors": "{a/@x: [1], b/@x: [2]}"}, 2, ["The name 'x'", "Give this factor a name"]),
        ({"factors": "{seed/@value: [1, 2]}"}, 2, ["Seeds are no factor"]),
        ({"set": "{test/@y: [1]}"}, 4, ["a list stands here; one value should"]),
        ({"design": "soboll"}, 4, ["Did you mean 'sobol'?", "full, one-at-a-time"]),
        ({"design": "{kind: sobol, points: 10}"}, 4, ["10 is no power of two"]),
        ({"design": "latin-hypercube"}, 4, ["needs points"]),
        ({"design": "{kind: full, points: 4}"}, 4, ["has no points"]),
        (
            {"design": "{kind: table, rows: [{y: 1}]}"},
            4,
            ["'y' is no factor", "no value of the factor x"],
        ),
        ({"design": "table"}, 4, ["needs either rows, or file"]),
        ({"seeds": "0"}, 4, ["whole number of at least 1"]),
        ({"seeds": "[1, 1]"}, 4, ["stands in the list twice"]),
        (
            {"seeds": "{count: 1, until: {response: load}}"},
            4,
            ["'most' is missing", "at least 2 seeds"],
        ),
        (
            {"seeds": "{count: 3, until: {response: lod, relative_error: 0.1, most: 9}}"},
            4,
            ["'lod' is no response"],
        ),
        ({"responses": "[]"}, 3, ["A list should stand here"]),
        ({"responses": "[{column: fx, statistic: median}]"}, 3, ["'median' is not known"]),
        ({"responses": "[{channel: a, column: b}]"}, 3, ["either a channel"]),
        ({"responses": "[{channel: a, name: x}]"}, 3, ["The name 'x' is in use"]),
        (
            {"run": "{threads: two}"},
            4,
            ["'two' stands here; a whole number of at least 1 and at most 256"],
        ),
        ({"run": "{keep: nothing}"}, 4, ["needs job.points"]),
        ({"job": "{minute: 3}"}, 4, ["Did you mean 'minutes'?"]),
    ],
)
def test_each_fault_has_its_line_and_its_remedy(desk, changes, line, words):
    text = told(desk, **changes)
    for word in words:
        assert word in text
    assert f"study.yaml:{line}: " in text


def test_all_faults_are_told_at_once(desk):
    text = told(desk, design="ful", seeds="x", job="3")
    assert len(text.splitlines()) == 3


def test_a_missing_key_is_named(desk):
    assert "'responses' is missing" in told(desk, responses=None)


def test_a_key_that_stands_twice_is_a_fault(desk):
    file = desk.write("scene: scene.xml\nscene: scene.xml\nresponses: [a]\n")
    with pytest.raises(StudyError, match="study.yaml:2: scene: The key stands here a second time"):
        read_study(file)


def test_what_is_no_yaml_is_told_with_its_line(desk):
    with pytest.raises(StudyError, match=r"study.yaml:3: This is not valid YAML.*begins in line 2"):
        read_study(desk.write("scene: a\nfactors: [1, 2\nseeds: 3\n"))


def test_a_missing_file_has_the_exit_code_of_files(desk):
    with pytest.raises(StudyError) as caught:
        read_study(desk.folder / "nothing.yaml")
    assert caught.value.code == 4


def test_values_stay_the_text_that_was_written(desk):
    """YAML 1.1 takes 1e-4 for a word and yes for true. A scene wants a number and a word."""
    study = read_study(written(desk, factors="{test/@x: [1e-4, 2e-4], test/@mode: [yes, off]}"))
    assert [level.number for level in study.factors[0].levels] == [1e-4, 2e-4]
    assert [level.label for level in study.factors[1].levels] == ["yes", "off"]


def test_a_level_may_set_several_attributes(desk):
    factors = (
        "{hull: {values: {slender: {test/@x: 1, test/@y: 2}, wide: {test/@x: 3, test/@y: 4}}}}"
    )
    study = read_study(written(desk, factors=factors))
    assert study.factors[0].levels[1].overrides == (("test/@x", "3"), ("test/@y", "4"))


def test_a_value_may_go_to_several_attributes(desk):
    study = read_study(written(desk, factors="{test/@x: {also: test/@y, values: [0.1]}}"))
    assert study.factors[0].levels[0].overrides == (("test/@x", "0.1"), ("test/@y", "0.1"))
