"""Study files that are made to exhaust the reader, or that are no files."""

import os
import time
from pathlib import Path

import pytest

from nilas.study import StudyError, read_study


def refusal(file: Path) -> str:
    """Returns what is said of a file, which must be said within seconds of processor time."""
    begin = time.process_time()
    with pytest.raises(StudyError) as refused:
        read_study(file)
    assert time.process_time() - begin < 20
    return str(refused.value)


def written(folder: Path, text: str) -> Path:
    file = folder / "study.yaml"
    file.write_text(text)
    return file


def test_aliases_that_multiply(tmp_path):
    lines = ["a0: &a0 [x]"]
    for k in range(1, 30):
        lines.append(f"a{k}: &a{k} [{', '.join([f'*a{k - 1}'] * 10)}]")
    assert "values, counted with those that aliases repeat" in refusal(
        written(tmp_path, "\n".join(lines))
    )


def test_an_alias_within_itself(tmp_path):
    assert "nested more than 30 deep" in refusal(written(tmp_path, "factors: &a [*a]\n"))


def test_deep_nesting(tmp_path):
    assert "nested more than 30 deep" in refusal(written(tmp_path, "factors: " + "[" * 100000))
    assert "nested more than 30 deep" in refusal(
        written(tmp_path, "factors: " + "[" * 40 + "]" * 40)
    )


def test_too_large(tmp_path):
    file = written(tmp_path, "")
    os.truncate(file, 2**40)
    assert "more than 1048576 bytes" in refusal(file)


def test_pipes_and_devices(tmp_path):
    os.mkfifo(tmp_path / "pipe")
    assert "It is no file" in refusal(tmp_path / "pipe")
    assert "It is no file" in refusal(Path("/dev/zero"))
    (tmp_path / "loop").symlink_to("loop")
    assert "cannot be read" in refusal(tmp_path / "loop")


def test_odd_names_of_files(tmp_path):
    for name in ("x" * 300, "x/" * 3000, '"\\0"', '"\\e[31m\\a"'):
        assert "There is no file" in refusal(written(tmp_path, f"scene: {name}\n"))


def test_tables_that_are_no_text(tmp_path):
    (tmp_path / "scene.xml").write_text("<scene version='1'/>")
    text = "scene: scene.xml\nfactors:\n  v: {path: time/@end, values: [1, 2]}\ndesign: {kind: table, file: %s}\n"
    for name, content in {"latin.csv": b"v\n\xff\n", "long.csv": b"v\n" + b"x" * 200000}.items():
        (tmp_path / name).write_bytes(content)
        assert f"{name} cannot be read" in refusal(written(tmp_path, text % name))
    os.mkfifo(tmp_path / "pipe.csv")
    assert "pipe.csv cannot be read: It is no file" in refusal(written(tmp_path, text % "pipe.csv"))
    assert "cannot be read" in refusal(written(tmp_path, text % '"\\0"'))
