"""Whole validations with the stand-in for the program: verdicts, budget, page and refusals."""

import re
import time

import pytest
from validation_desk import CASE

from nilas.study.describe.faults import StudyError
from nilas.validate.cases.read_case import read_case


def test_a_load_that_the_formula_gives_is_within_and_another_is_outside(desk):
    desk.write()
    code, text = desk.run("-j", "2")
    assert code == 0, text
    for point, load in (("base", 20), ("x 4", 40), ("x 8", 80)):
        row = desk.row(point)
        assert float(row["reference_value"]) == load and row["verdict"] == "within"
        assert abs(float(row["simulated"]) - load) <= float(row["interval_95"])
        assert row["runs"] == "4" and row["interval_from"] == "seeds"
    off = desk.row("y 1")
    assert off["verdict"] == "outside by more than its error"
    assert float(off["ratio"]) == pytest.approx(23 / 20, abs=0.1)
    assert off["source"].startswith("definition")


def test_slopes_have_intervals_and_are_those_of_the_formula(desk):
    desk.write()
    desk.run("-j", "2")
    row = desk.row("over x")
    assert row["quantity"] == "d ln load / d ln x" and row["verdict"] == "within"
    assert float(row["simulated"]) == pytest.approx(1.0, abs=0.06)
    assert 0 < float(row["interval_95"]) < 0.2 and float(row["reference_value"]) == 1.0


def test_a_slope_that_no_formula_has_is_outside(desk):
    # The pressure-area formula grows with the root of the width here.
    desk.write(CASE.replace("formulas: [full-contact]}", "formulas: [pressure-area]}"))
    desk.run("-j", "2")
    row = desk.row("over x")
    assert float(row["reference_value"]) == pytest.approx(0.5)
    assert row["verdict"] == "outside by more than its error"


def test_an_envelope_holds_what_lies_between_its_formulas(desk):
    text = CASE.replace("formula: full-contact}", "envelope: [full-contact, pressure-area]}")
    desk.write(text.replace("[2, 4, 8]", "[2, 1]"))
    desk.run("-j", "2")
    row = desk.row("base")
    # 10 sqrt(2) to 20, and the load is about 20.
    assert float(row["reference_low"]) == pytest.approx(14.1421, abs=1e-4)
    assert float(row["reference_high"]) == 20 and row["verdict"] == "within"
    assert desk.row("y 1")["verdict"] == "outside by more than its error"


def test_factors_that_should_not_matter_are_compared_with_the_base_by_the_same_seeds(desk):
    desk.write(CASE.replace("formula: full-contact}", "same_over: [y]}"))
    desk.run("-j", "2")
    row = desk.row("y 1")
    assert row["reference"] == "same as at y 0" and "It differs by +" in row["remark"]
    assert row["verdict"] == "outside by more than its error"
    assert "differences of the same seeds" in row["interval_from"]


def test_a_formula_outside_of_its_range_gives_no_verdict(desk):
    riska = "{quantity: load, formula: riska}"
    inputs = (
        "inputs: {width: test/@x, thickness: 1, speed: 1, beam: 1, length: 6, draught: 1, "
        "stem_angle: 0.5, parallel_length: 2, bow_length: 2, compressive_strength: 10}"
    )
    text = re.sub(r"inputs: .*", inputs, CASE).replace(
        "{quantity: load, formula: full-contact}", riska
    )
    desk.write(text)
    desk.run("-j", "2")
    row = desk.row("base")
    assert row["verdict"] == "outside the formula's range" and "merchant ships" in row["remark"]


def test_formulas_in_doubt_are_shown_and_not_judged(desk):
    inputs = (
        "inputs: {width: test/@x, thickness: 1, strength_coefficient: 10, compressive_strength: 10}"
    )
    text = re.sub(r"inputs: .*", inputs, CASE).replace(
        "formula: full-contact}", "formula: iso-crushing}"
    )
    desk.write(text)
    desk.run("-j", "2")
    row = desk.row("base")
    assert row["verdict"] == "not judged" and "not confirmed in the standard" in row["remark"]
    assert row["reference_value"]


def test_a_value_needs_a_source_and_is_judged_by_the_error_alone(desk):
    desk.write(CASE.replace("formula: full-contact}", "value: 20, source: the stand-in}"))
    desk.run("-j", "2")
    assert desk.row("base")["verdict"] == "within"
    assert desk.row("x 4")["verdict"] == "outside by more than its error"
    desk.write(CASE.replace("formula: full-contact}", "value: 20}"))
    code, text = desk.run()
    assert code == 2 and "trial.yaml:14: references.value: A value needs a source" in text


def test_few_runs_give_no_verdict(desk):
    desk.write(CASE.replace("seeds: 4", "seeds: 2"))
    desk.run("-j", "2")
    assert {row["verdict"] for row in desk.rows()} == {"not enough runs"}


def test_the_error_that_runs_state_counts_where_it_is_the_wider_one(desk):
    load = "{channel: ice_load.along.mean_N, name: load}"
    desk.write()
    desk.run("-j", "2")
    assert desk.row("base")["interval_from"] == "seeds"
    stated = f"responses: [{load}, {{channel: ice_load.along.mean_N, name: load_stated_error}}]"
    desk.write(re.sub(r"responses: .*", stated, CASE))
    desk.run("-j", "2")
    # Each run states an error as large as its load; that of the mean of four is half of it.
    row = desk.row("base")
    assert row["interval_from"] == "single runs"
    assert float(row["interval_95"]) == pytest.approx(10, abs=1)


def test_the_same_command_goes_on_and_repeats_nothing(desk):
    desk.write(CASE.replace("seeds: 4", "seeds: 2"))
    desk.run("-j", "2")
    done = {file: file.stat().st_mtime_ns for file in desk.out.rglob("record.json")}
    desk.write()
    code, text = desk.run("-j", "2")
    assert code == 0 and len(list(desk.out.rglob("record.json"))) == 16
    assert {file: file.stat().st_mtime_ns for file in done} == done


def test_a_budget_ends_early_and_what_was_left_out_is_stated(desk):
    # Runs of 0.5 s: a budget of 3 s holds some of the 16.
    desk.write(CASE.replace("factors:", "set: {test/@steps: 25}\n  factors:"))
    begun = time.monotonic()
    code, text = desk.run("--budget", "0.05")
    assert time.monotonic() - begun < 20
    assert code == 0 and "The budget of 0.05 minutes is used up" in text
    assert re.search(r"trial: \d+ of 16 runs were not made", text)
    assert "What was left out" in (desk.out / "validation.html").read_text()
    code, text = desk.run("-j", "4")
    assert code == 0 and "were not made" not in text
    assert desk.row("base")["runs"] == "4"


def test_rounds_give_every_case_two_seeds_before_any_has_more(desk):
    desk.write()
    desk.write(name="other.yaml")
    code, text = desk.run("-j", "2", files=("trial.yaml", "other.yaml"))
    assert code == 0
    order = re.findall(r"(trial|other): \d+ runs, up to seed number (\d)", text)
    assert order == [("trial", "2"), ("other", "2"), ("trial", "4"), ("other", "4")]


def test_failed_runs_are_told_and_the_others_count(desk):
    text = CASE.replace(
        "test/@y: [0, 1]", "other: {values: {fine: {test/@y: 0}, bad: {test/@fail: 3}}}"
    )
    desk.write(text)
    code, told = desk.run("-j", "2")
    assert code == 3 and "4 runs failed" in told
    assert desk.row("base")["verdict"] == "within"
    bad = desk.row("other bad")
    assert bad["verdict"] == "not enough runs" and "4 runs failed" in bad["remark"]
    assert "the ice left finite numbers" in (desk.out / "validation.html").read_text()


def test_the_page_stands_alone_and_has_table_pictures_and_sources(desk):
    desk.write()
    desk.run("-j", "2")
    page = (desk.out / "validation.html").read_text()
    assert page.count("<svg") == 2 and "Load against Compressive strength" in page
    assert "definition: strength times width times thickness" in page
    assert not re.search(r'(?:src|href)="https?:', page)
    for link in re.findall(r'href="([^"#]+)"', page):
        assert (desk.out / link).is_file(), link


def test_the_slice_takes_its_points_and_seeds_and_sets_what_it_says(desk):
    text = CASE.replace(
        "test/@x: [2, 4, 8]", "x: {values: {2: {test/@x: 2, test/@steps: 400}, 4: {test/@x: 4}}}"
    )
    text = text.replace("points: [1]}", "points: [1], set: {test/@steps: 1}}")
    desk.write(text.replace("over: x, input", "over: x, input"))
    code, told = desk.run("--slice", "-j", "2")
    assert code == 0, told
    assert len(list(desk.out.rglob("record.json"))) == 3
    assert desk.row("base")["runs"] == "3"


def test_a_case_that_is_unjudged_says_why_in_every_row(desk):
    desk.write(CASE + "unjudged: The hull is another one.\n")
    desk.run("-j", "2")
    assert {row["verdict"] for row in desk.rows()} == {"not judged"}
    assert all("The hull is another one." in row["remark"] for row in desk.rows())


@pytest.mark.parametrize(
    ("old", "new", "message"),
    [
        ("title: A trial\n", "", "'title' is missing"),
        ("formula: full-contact", "formula: full-contract", "Did you mean 'full-contact'?"),
        (
            "{width: test/@x",
            "{with: test/@x",
            "inputs.with: No formula has this input. Did you mean",
        ),
        ("thickness: 1, ", "", "full-contact needs the input thickness"),
        ("width: test/@x", "width: test/@q", "The scene does not give test/@q"),
        ("over: x", "over: z", "'z' is no factor"),
        ("points: [1]", "points: [9]", "There are 4 points, and no 9"),
        ("points: [1]", "points: [one]", "'one' is no number of a point"),
        ("formula: full-contact}", "envelope: [full-contact]}", "two formulas or more"),
        ("formula: full-contact}", "remark: none}", "one of formula, envelope"),
        ("test/@x: [2, 4, 8]", "test/@x: []", "a list such as"),
        ("quantity: load, formula", "quantity: lode, formula", "Did you mean 'load'?"),
        ("slice: {seeds: 3, points: [1]}\n", "", "'slice' is missing"),
        ("references:", "reference:", "Did you mean 'references'?"),
    ],
)
def test_faults_of_a_case_are_told_with_their_place(desk, old, new, message):
    assert old in CASE
    file = desk.write(CASE.replace(old, new, 1))
    with pytest.raises(StudyError, match=re.escape(message)) as told:
        read_case(file)
    assert told.value.code == 2 and str(file) in str(told.value)


def test_a_case_that_is_no_file_and_a_wrong_budget_are_refused(desk):
    code, text = desk.run(files=("nowhere.yaml",))
    assert code == 4 and "cannot be read" in text
    with pytest.raises(SystemExit) as wrong:
        desk.run("--budget", "0")
    assert wrong.value.code == 2
