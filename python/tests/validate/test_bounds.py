"""Bounds, the least of several formulas, levels at which a reference holds, and divided slopes."""

import re

import pytest
from validation_desk import CASE

from nilas.study.describe.faults import StudyError
from nilas.validate.cases.read_case import read_case

FORMULA = "formula: full-contact}"


def test_a_load_below_a_bound_is_within_and_one_above_it_is_outside(desk):
    # The bound is 20, 40 and 80. The load is as large, and 3 more where y is 1.
    bounded = CASE.replace(FORMULA, "at_most: full-contact}")
    desk.write(bounded.replace("thickness: 1", "thickness: 1.1"))
    desk.run("-j", "2")
    row = desk.row("x 8")
    assert row["verdict"] == "within" and row["reference"].startswith("at most Compressive")
    assert float(row["reference_high"]) == pytest.approx(88) and row["reference_low"] == ""
    assert desk.row("base")["verdict"] == "within"
    desk.write(bounded)
    desk.run("-j", "2")
    assert desk.row("y 1")["verdict"] == "outside by more than its error"


def test_a_number_can_be_a_bound_and_needs_a_source(desk):
    desk.write(CASE.replace(FORMULA, "at_most: 50, source: the stand-in}"))
    desk.run("-j", "2")
    assert desk.row("base")["verdict"] == "within" and desk.row("base")["reference"] == "at most 50"
    assert desk.row("x 8")["verdict"] == "outside by more than its error"
    file = desk.write(CASE.replace(FORMULA, "at_most: 50}"))
    with pytest.raises(StudyError, match="references.at_most: A value needs a source"):
        read_case(file)


def test_the_least_of_several_formulas_counts(desk):
    # The area is x, so that the second formula gives 10 sqrt(x): less than the load everywhere.
    text = CASE.replace(FORMULA, "least: [full-contact, pressure-area]}")
    desk.write(text)
    desk.run("-j", "2")
    row = desk.row("base")
    assert float(row["reference_value"]) == pytest.approx(200**0.5, rel=1e-5)
    assert "The least is Pressure that falls with the area." in row["remark"]
    assert row["verdict"] == "outside by more than its error"
    desk.write(text.replace("-0.5", "0.5"))
    desk.run("-j", "2")
    assert desk.row("base")["verdict"] == "within"
    assert desk.row("base")["reference"].startswith("the least of Compressive")


def test_a_reference_is_judged_at_its_levels_alone(desk):
    desk.write(CASE.replace(FORMULA, "formula: full-contact, where: {y: 0}}"))
    desk.run("-j", "2")
    points = [row["point"] for row in desk.rows() if not row["quantity"].startswith("d ln")]
    assert points == ["base", "x 4", "x 8"]


def test_a_slope_can_be_that_of_a_quantity_per_input(desk):
    desk.write(CASE.replace("over: x, input: width,", "over: x, input: width, per: width,"))
    desk.run("-j", "2")
    row = desk.row("over x")
    assert row["quantity"] == "d ln (load / width) / d ln x"
    assert float(row["reference_value"]) == pytest.approx(0.0, abs=1e-9)
    assert float(row["simulated"]) == pytest.approx(0.0, abs=0.06) and row["verdict"] == "within"


def test_a_factor_that_is_no_input_of_a_formula_can_be_what_a_slope_is_over(desk):
    text = CASE.replace("test/@x: [2, 4, 8]", "size: {values: {2: {test/@x: 2}, 4: {test/@x: 4}}}")
    text = text.replace("inputs: {", "inputs: {size: size, ").replace("over: x", "over: size")
    desk.write(text.replace("input: width, ", ""))
    desk.run("-j", "2")
    assert float(desk.row("over size")["reference_value"]) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("new", "message"),
    [
        ("formula: full-contact, where: {z: 0}}", "where.z: 'z' is no factor"),
        ("formula: full-contact, where: {y: 7}}", "where.y: '7' is no level"),
        ("formula: full-contact, where: y}", "A map from factors to levels"),
        ("least: [full-contact]}", "A least value has two formulas or more"),
    ],
)
def test_faults_of_bounds_are_told_with_their_place(desk, new, message):
    file = desk.write(CASE.replace(FORMULA, new))
    with pytest.raises(StudyError, match=re.escape(message)):
        read_case(file)


def test_a_slope_is_divided_by_an_input_that_the_case_has(desk):
    file = desk.write(CASE.replace("over: x, input: width,", "over: x, input: width, per: area,"))
    with pytest.raises(StudyError, match="slopes.per: The case has no input area"):
        read_case(file)
