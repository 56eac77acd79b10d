"""Where the program is found, and how its failures arrive."""

from __future__ import annotations

import os
import pickle
import signal
import subprocess
import sys
import time
from pathlib import Path

import numpy as np
import pytest

import nilas
from nilas import program as program_module
from nilas.program import Failed, program


def test_the_named_program_goes_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    other = tmp_path / "other"
    other.write_text('#!/bin/sh\necho other "$@"\n')
    monkeypatch.setenv("NILAS_PROGRAM", str(other))
    with pytest.raises(nilas.NotFound, match="which is no program that can be run"):
        program()
    other.chmod(0o755)
    assert program() == other
    assert nilas.call("run", "x").output == "other run x\n"


def test_a_python_script_of_the_name_is_passed_over(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The script of a wheel runs this package, which would then run the script again."""
    for name, head in (("a", "#!/usr/bin/python3"), ("b", "#!/bin/sh")):
        (tmp_path / name).mkdir()
        (tmp_path / name / "nilas").write_text(head + "\n")
        (tmp_path / name / "nilas").chmod(0o755)
    monkeypatch.delenv("NILAS_PROGRAM", raising=False)
    monkeypatch.setattr(program_module, "_places", lambda: [tmp_path / "none"])
    monkeypatch.setenv("PATH", f"{tmp_path / 'a'}:{tmp_path / 'b'}")
    assert program() == tmp_path / "b" / "nilas"
    monkeypatch.setenv("PATH", str(tmp_path / "a"))
    with pytest.raises(nilas.NotFound, match="Set NILAS_PROGRAM to its path"):
        program()


def test_a_failure_has_the_message_and_code_of_the_program(small_scene: Path) -> None:
    with pytest.raises(Failed, match="bad input or usage") as failure:
        nilas.call("check", small_scene, "--set", "vessel/carriage/@sped=1")
    assert failure.value.code == 2
    assert "sped" in failure.value.message
    again = pickle.loads(pickle.dumps(failure.value))
    assert str(again) == str(failure.value)


def test_settings_are_written_as_the_scene_file_has_them(small_scene: Path, tmp_path: Path) -> None:
    run = nilas.run(
        small_scene,
        out=tmp_path / "out",
        until=0.02,
        settings={
            "vessel/carriage/@speed": np.float64(0.1) * 3,
            "contact/@gyroscopic": False,
            "ice/field/@region": (5.5, -0.7, 7, np.float64(0.7)),
        },
    )
    assert float(run.settings["vessel/carriage/@speed"]) == 0.1 * 3
    assert run.settings["contact/@gyroscopic"] == "false"
    assert run.settings["ice/field/@region"].split() == ["5.5", "-0.7", "7", "0.7"]


def test_a_folder_that_holds_a_run_is_kept(small_scene: Path, own_folder: Path) -> None:
    with pytest.raises(Failed, match="the output folder is not empty"):
        nilas.run(small_scene, out=own_folder)
    assert nilas.run(small_scene, out=own_folder, until=0.02, force=True).figures["steps"] == 2


@pytest.mark.parametrize("to_all", [True, False])
def test_ctrl_c_lets_the_run_finish_its_files(
    small_scene: Path, tmp_path: Path, to_all: bool
) -> None:
    """A terminal sends the signal to Python and to the program, a notebook to Python alone."""
    code = (
        "import nilas, sys\n"
        "try:\n"
        "    nilas.run(sys.argv[1], out=sys.argv[2], until=1000, threads=1)\n"
        "except KeyboardInterrupt:\n"
        "    sys.exit(77)\n"
    )
    folder = tmp_path / "long"
    environment = {**os.environ, "PYTHONPATH": str(Path(nilas.__file__).parents[1])}
    process = subprocess.Popen(
        [sys.executable, "-c", code, small_scene, folder],
        env=environment,
        start_new_session=True,
    )
    deadline = time.monotonic() + 60
    while not (folder / "vessel.csv").is_file() or (folder / "vessel.csv").stat().st_size < 10_000:
        assert process.poll() is None
        assert time.monotonic() < deadline
        time.sleep(0.05)
    assert nilas.Run(folder).status == "running"
    if to_all:
        os.killpg(process.pid, signal.SIGINT)
    else:
        process.send_signal(signal.SIGINT)
    assert process.wait(60) == 77
    with pytest.warns(nilas.UnfinishedRun, match="was interrupted"):
        assert nilas.Run(folder).status == "interrupted"


def test_values_are_written_as_those_of_scenes(small_scene: Path, tmp_path: Path) -> None:
    """Those of numpy too: a boolean of numpy came as True, which the program does not take."""
    run = nilas.run(
        small_scene,
        out=tmp_path / "run",
        until=np.float32(0.25),
        settings={"output/@bodies": np.True_, "gravity/@value": np.array([0, 0, -9.5])},
    )
    assert run.settings["output/@bodies"] == "true" and run.settings["gravity/@value"] == "0 0 -9.5"
    assert run.settings["time/@end"] == "0.25"
    with pytest.raises(nilas.InputError, match="must be finite; found nan"):
        nilas.run(small_scene, out=tmp_path / "no", settings={"time/@end": float("nan")})


def test_the_module_says_where_it_looked_for_the_program(tmp_path: Path) -> None:
    environment = {
        **os.environ,
        "PYTHONPATH": str(Path(nilas.__file__).parents[1]),
        "NILAS_PROGRAM": str(tmp_path / "none"),
    }
    done = subprocess.run(
        [sys.executable, "-m", "nilas"], env=environment, capture_output=True, text=True
    )
    assert done.returncode == 4
    assert done.stderr.startswith("error: NILAS_PROGRAM names") and "Traceback" not in done.stderr


def test_a_single_text_is_no_list(small_scene: Path, small_run: nilas.Run) -> None:
    """It would be taken letter by letter: verify(cases="A1") ran all cases of A."""
    for call in (
        lambda: nilas.verify(cases="A1"),
        lambda: nilas.compare(small_scene, out="none", options="--budget 1"),
        lambda: nilas.run(small_scene, out="none", options="--force"),
        lambda: small_run.contacts.step(1, columns="fx_N"),
    ):
        with pytest.raises(nilas.InputError, match="is a list; write"):
            call()


def test_the_version_has_the_usual_name_too() -> None:
    assert nilas.__version__ == nilas.version()
    assert nilas.call("--version").output.split()[1].startswith(nilas.__version__)


def test_what_the_program_says_is_shown_where_asked(
    small_scene: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    nilas.run(small_scene, out=tmp_path / "quiet", until=0.02)
    assert capsys.readouterr().out == ""
    nilas.run(small_scene, out=tmp_path / "loud", until=0.02, echo=True)
    assert "outputs" in capsys.readouterr().out
    with pytest.raises(Failed, match="there is no such file or folder"):
        nilas.call("check", tmp_path / "none.xml", echo=True)
    assert "none.xml" in capsys.readouterr().err


def test_import_is_quick_and_names_are_listed() -> None:
    """No table reader is loaded before it is used."""
    code = "import nilas, sys; print([m for m in ('pandas', 'h5py', 'numpy') if m in sys.modules])"
    environment = {**os.environ, "PYTHONPATH": str(Path(nilas.__file__).parents[1])}
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "[]"
    assert set(nilas.__all__) <= set(dir(nilas))
    code = "import nilas; print(nilas.study.main.__module__)"
    done = subprocess.run(
        [sys.executable, "-c", code], env=environment, capture_output=True, text=True, check=True
    )
    assert done.stdout.strip() == "nilas.study.command"
    with pytest.raises(AttributeError, match="Nilas has no 'ruin'. It has .*run"):
        _ = nilas.ruin
