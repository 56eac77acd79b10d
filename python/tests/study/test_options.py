"""The command of the program and the package take the same options."""

import argparse
import re

import pytest

from nilas.program import NotFound, call
from nilas.study.options import option_parser


def _printed(*words):
    try:
        return call(*words).output
    except NotFound as error:
        pytest.skip(str(error))


def _shown():
    """The options of the package without those that are jobs of Snakemake, and --help."""
    actions = option_parser()._actions
    shown = [action for action in actions if action.help != argparse.SUPPRESS]
    return [action for action in shown if action.dest != "help"]


def test_program_and_package_list_the_same_options():
    rows = _printed("schema", "--commands").split("## nilas study\n")[1].split("\n## ")[0]
    listed = {
        name: (value != "", default.strip("`"), help)
        for name, value, default, help in re.findall(
            r"^\| `(.+?)` \| (.*?) ?\| (.*?) ?\| (.*) \|$", rows, re.MULTILINE
        )
    }
    expected = {
        ",".join(action.option_strings) or action.dest: (
            action.nargs != 0,
            str(action.default) if type(action.default) is int else "",
            action.help,
        )
        for action in _shown()
    }
    assert len(expected) > 10
    assert listed == expected


def test_completion_and_manual_page_have_every_option():
    cases = _printed("schema", "--completion")
    words = re.search(r"^ *study\) words='(.*)' ;;$", cases, re.MULTILINE)[1].split()
    names = [name for action in _shown() for name in action.option_strings if name.startswith("--")]
    assert sorted(set(words) - {"--help"}) == sorted(names)
    page = _printed("schema", "--man").replace("\\-", "-").split(".SS nilas study\n")[1]
    assert not [name for name in names if name not in page.split(".SS ")[0]]


def test_wrong_values_are_refused_by_the_package_too(capsys):
    for words in (["--jobs", "0"], ["--jobs", "two"], ["--threads", "4097"], []):
        with pytest.raises(SystemExit) as end:
            option_parser().parse_args(words + ["s.yaml"] if words else words)
        assert end.value.code == 2
    assert "'4097' is no whole number from 1 to 4096" in capsys.readouterr().err
    options = option_parser().parse_args(["--collect", "s.yaml", "-j", "3"])
    assert (options.study, options.jobs, options.threads) == ("s.yaml", 3, None)
    assert options.collect and not options.gather
