"""What a study says where the system fails it."""

import os
import runpy
import sys

import pytest

from nilas.study import command
from nilas.study.carry_out.outputs import outputs_of
from nilas.study.carry_out.provenance import scene_hash


def unreadable(file):
    """A file that can be opened, but not read."""
    file.symlink_to("/proc/self/mem")
    return file


@pytest.mark.skipif(sys.platform != "linux", reason="needs /proc")
def test_files_that_cannot_be_read_are_named(tmp_path):
    table, scene = unreadable(tmp_path / "steps.csv"), unreadable(tmp_path / "scene.xml")
    (tmp_path / "summary.json").write_text("{}")
    with pytest.raises(OSError) as told:
        outputs_of(tmp_path)
    assert told.value.filename == str(table)
    with pytest.raises(OSError) as told:
        scene_hash(scene)
    assert told.value.filename == str(scene)


def test_too_little_memory_ends_at_once_and_is_told(monkeypatch, capsys):
    def without_memory():
        raise MemoryError

    monkeypatch.setattr(command, "carried_out", without_memory)
    monkeypatch.setattr(os, "_exit", sys.exit)
    with pytest.raises(SystemExit) as ended:
        runpy.run_module("nilas.study", run_name="__main__")
    assert ended.value.code == 4
    assert capsys.readouterr().err == "error: there is too little memory for this command\n"
