"""The cases that come with the program: all are read, and slices of most run."""

import csv

import pytest

from nilas.program import Failed, NotFound, call, program
from nilas.validate.cases.read_case import read_case
from nilas.validate.command import main
from nilas.validate.shipped import cases_folder, chosen_cases, shipped_names


def test_every_case_file_is_in_the_order_and_can_be_read():
    folder = cases_folder()
    assert sorted(shipped_names(folder)) == sorted(file.stem for file in folder.glob("*.yaml"))
    for case in chosen_cases([]):
        assert case.name == case.file.stem
        assert case.title and case.question.endswith("?")


def test_the_cases_fit_into_an_evening_on_two_cores():
    assert sum(case.minutes for case in chosen_cases([])) <= 2 * 300


def test_the_program_has_the_command():
    try:
        answer = call("validate", "--list")
    except NotFound as error:
        pytest.skip(str(error))
    for name in shipped_names(cases_folder()):
        assert f"{name}: " in answer.output
    with pytest.raises(Failed) as wrong:
        call("validate", "no-such-case")
    assert wrong.value.code == 2 and "'no-such-case' is no case" in wrong.value.message


# Their slices take three quarters of the time of all; what they run is that of pack-blunt.
_LONG = {"pack-slender", "scale-pack"}


def test_slices_of_cases_run_and_give_their_loads(tmp_path):
    try:
        found = program()
    except NotFound as error:
        pytest.skip(str(error))
    names = [name for name in shipped_names(cases_folder()) if name not in _LONG]
    words = ["--slice", "--out", str(tmp_path), "--program", str(found), "--quiet", "-j", "2"]
    assert main([*names, *words]) == 0
    with open(tmp_path / "validation.csv", newline="") as stream:
        rows = list(csv.DictReader(stream))
    for name in names:
        case = read_case(cases_folder() / f"{name}.yaml").sliced()
        of_case = [row for row in rows if row["case"] == name]
        assert of_case, name
        # Every point has as many runs as the slice asks for, each with the quantity that is judged.
        counted = [row for row in of_case if not row["quantity"].startswith("d ln")]
        assert all(row["simulated"] for row in counted), name
        assert all(int(row["runs"]) == case.slice.seeds for row in counted), name
    assert (tmp_path / "validation.html").stat().st_size > 10000
