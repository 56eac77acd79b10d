"""How a run ended, folders that are no runs, and several runs in one table."""

from __future__ import annotations

import fcntl
import json
import shutil
import warnings
from pathlib import Path

import pytest

import nilas
from nilas.study.carry_out.record import flat_numbers


def change_summary(folder: Path, **values: object) -> None:
    file = folder / "summary.json"
    file.write_text(json.dumps({**json.loads(file.read_text()), **values}))


def test_a_run_that_is_done_gives_no_warning(small_folder: Path) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        run = nilas.Run(small_folder)
    assert (run.status, run.trouble) == ("done", "")
    assert "small: done, 0.5 s" in repr(run)


@pytest.mark.parametrize(("status", "word"), [("failed", "failed"), ("interrupted", "was interr")])
def test_a_run_that_did_not_end_says_so(own_folder: Path, status: str, word: str) -> None:
    change_summary(own_folder, status=status, time_end_s=0.25)
    with pytest.warns(nilas.UnfinishedRun, match=f"It {word}.*at 0.25 s"):
        run = nilas.Run(own_folder)
    assert run.status == status
    assert len(run.vessel) == 50


def test_a_run_that_fails_names_the_cause(small_scene: Path, tmp_path: Path) -> None:
    """Three sweeps do not solve a step to 1e-14 m/s, and the scene asks to stop then."""
    contact = {"tolerance": 1e-14, "on_failure": "stop", "max_iterations": 3, "solver": "nsgs"}
    settings = {f"contact/@{name}": value for name, value in contact.items()}
    with pytest.raises(nilas.Failed, match="the numerics failed") as failure:
        nilas.run(small_scene, out=tmp_path / "failed", settings=settings)
    assert failure.value.code == 3
    with pytest.warns(nilas.UnfinishedRun, match="the contact solver stopped with status"):
        run = nilas.Run(tmp_path / "failed")
    assert run.status == "failed"
    assert 0 < len(run.steps) < 50


def test_a_killed_run_is_told_from_one_that_goes_on(own_folder: Path) -> None:
    """The program holds a lock on nilas.log while it writes the run."""
    (own_folder / "summary.json").unlink()
    with (own_folder / "nilas.log").open("r+") as log:
        fcntl.flock(log, fcntl.LOCK_EX)
        run = nilas.Run(own_folder)
        assert run.status == "running"
        assert run.trouble == ""
        assert len(run.vessel) == 50
        with pytest.raises(nilas.NoRun, match="no summary.json, since it is running"):
            _ = run.summary
        assert list(nilas.runs([own_folder]).frame["ice_load.along.mean_N"].isna()) == [True]
    with pytest.warns(nilas.UnfinishedRun, match="It was killed"):
        assert nilas.Run(own_folder).status == "killed"


def test_folders_that_are_no_runs_are_refused(small_folder: Path, tmp_path: Path) -> None:
    with pytest.raises(nilas.NoRun, match="there is no such folder"):
        nilas.Run(tmp_path / "none")
    with pytest.raises(nilas.NoRun, match="this is a file. Name the run folder"):
        nilas.Run(small_folder / "vessel.csv")
    with pytest.raises(nilas.NoRun, match="no run folder, since it has none of scene.xml"):
        nilas.Run(tmp_path)
    with pytest.raises(nilas.NoRun, match="It holds the run folders small"):
        nilas.Run(small_folder.parent)
    with pytest.raises(nilas.NoRun, match="there is no run folder here"):
        nilas.runs(tmp_path)
    with pytest.raises(nilas.NoRun, match="no run to compare"):
        nilas.runs([])


def test_a_damaged_summary_is_named(own_folder: Path) -> None:
    (own_folder / "summary.json").write_text("{")
    with pytest.raises(nilas.NoRun, match="summary.json: this is no JSON text"):
        nilas.Run(own_folder)


def test_settings_have_the_paths_of_set(small_run: nilas.Run, small_scene: Path) -> None:
    """The program takes each path and value again."""
    settings = small_run.settings
    assert settings["contact/friction[@between='hull ice']/@kinetic"] == "0.1"
    words = [f"{path}={settings[path]}" for path in ("time/@end", "vessel/carriage/@speed")]
    words.append(f"contact/friction[@between='hull ice']/@kinetic={0.1}")
    nilas.call("check", small_scene, "--set", *words)


def test_scenes_are_compared_by_what_differs(
    small_scene: Path, small_folder: Path, tmp_path: Path
) -> None:
    faster = nilas.run(
        small_scene,
        out=tmp_path / "faster",
        settings={"vessel/carriage/@speed": 0.4, "output/@problems": "never"},
        seed=8,
        until=0.2,
        threads=1,
    )
    together = nilas.runs([small_folder, faster])
    frame = together.frame
    differing = {"seed/@value", "vessel/carriage/@speed", "output/@problems", "time/@end"}
    assert set(together.settings.columns) == differing
    assert list(frame["seed/@value"]) == [7, 8]
    assert list(frame["vessel/carriage/@speed"]) == [0.3, 0.4]
    assert list(frame["time_end_s"]) == pytest.approx([0.5, 0.2])
    mean = faster.summary["ice_load"]["along"]["mean_N"]
    assert frame["ice_load.along.mean_N"].iloc[1] == mean
    table = together.table("vessel", columns=["x_m"])
    assert len(table) == 70
    assert table.attrs["units"]["x_m"] == "m"
    assert together.loads.index.get_level_values("run").nunique() == 2


def test_a_figure_that_no_run_has_is_refused(own_folder: Path, small_folder: Path) -> None:
    """One that a single run has is nan in the others, and so is one that is known to be unknown."""
    change_summary(own_folder, only_here=3.0, not_known={"estimate_N": None}, halves=None)
    together = nilas.runs([small_folder, own_folder])
    some = together.figures(["only_here", "not_known.estimate_N", "halves.differ"])
    assert list(some["only_here"].isna()) == [True, False]
    assert some[["not_known.estimate_N", "halves.differ"]].isna().all(axis=None)
    with pytest.raises(nilas.UnknownName, match="No run has a figure 'only_her'; did you mean only_here") as caught:
        together.figures(["only_her"])
    assert "figures, from scene to " in str(caught.value)
    with pytest.raises(nilas.InputError, match=r"write names=\['steps'\]"):
        together.figures("steps")
    (own_folder / "summary.json").unlink()
    with pytest.warns(nilas.UnfinishedRun):
        killed = nilas.runs([own_folder])
    assert killed.figures(["only_her"])["only_her"].isna().all()


def test_figures_have_the_names_of_the_channels_of_studies(breaking_folder: Path) -> None:
    """A number of summary.json has one name, in a list too."""
    figures = nilas.Run(breaking_folder).figures
    numbers = flat_numbers(nilas.Run(breaking_folder).summary)
    assert "structures.pier.loads.contact_fx_N.mean_N" in numbers
    assert {name: figures[name] for name in numbers} == numbers


def test_runs_below_a_folder_are_found(own_folder: Path) -> None:
    shutil.copytree(own_folder, own_folder.parent / "deep" / "other")
    together = nilas.runs(own_folder.parent)
    assert together.names == ["deep/other", "small"]
    assert [run.status for run in together[:1]] == ["done"]


def test_frames_beyond_the_run_are_the_nearest(small_run: nilas.Run) -> None:
    trajectory = small_run.trajectory
    forces = trajectory.surface("contact forces", 99)
    assert forces.values["force_N"].shape == (len(forces), 3)
    assert trajectory.surface("vessel", 0).bodies
    with pytest.raises(nilas.UnknownName, match="no block 'ice'; allowed: ice floes"):
        trajectory.surface("ice", 0)


def test_stored_problems_are_listed(small_run: nilas.Run) -> None:
    assert [file.name for file in small_run.problems] == ["worst.hdf5"]
