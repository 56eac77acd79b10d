"""Small runs that tests and doctests share, and names that doctests may use."""

from __future__ import annotations

import shutil
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

import nilas
from nilas.loads.series import LoadSeries

SCENES = Path(__file__).parent / "tests" / "scenes"


@pytest.fixture(scope="session")
def small_scene() -> Path:
    """A scene of about ten floes and 50 steps."""
    return SCENES / "small.xml"


@pytest.fixture(scope="session")
def steered_scene() -> Path:
    """A scene of a vessel with a thruster."""
    return SCENES / "steered.xml"


@pytest.fixture(scope="session")
def small_folder(small_scene: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a run of that scene, which tests only read."""
    folder = tmp_path_factory.mktemp("runs") / "small"
    nilas.run(small_scene, out=folder, threads=1)
    return folder


@pytest.fixture(scope="session")
def breaking_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """The folder of a run in which a sheet breaks, beside a fixed pier."""
    folder = tmp_path_factory.mktemp("runs") / "breaking"
    nilas.run(SCENES / "breaking.xml", out=folder, threads=1)
    return folder


@pytest.fixture
def own_folder(small_folder: Path, tmp_path: Path) -> Path:
    """A copy of that folder, which a test may change."""
    return Path(shutil.copytree(small_folder, tmp_path / "small"))


@pytest.fixture
def small_run(small_folder: Path) -> nilas.Run:
    return nilas.Run(small_folder)


@pytest.fixture
def long_load() -> LoadSeries:
    """A load of 2000 s at random, whose neighbours resemble each other."""
    import numpy as np

    noise = np.random.default_rng(1).exponential(size=20001)
    return LoadSeries(noise[1:] + noise[:-1], 0.0, 0.1, 0.1)


@pytest.fixture
def floe_shapefile(tmp_path: Path) -> Path:
    """Two floes of 2 m and 1 m, with their thickness."""
    pyshp = pytest.importorskip("shapefile", reason="needs pyshp (python3-pyshp of Debian)")
    with pyshp.Writer(str(tmp_path / "floes.shp"), shapeType=pyshp.POLYGON) as writer:
        writer.field("thick", "N", decimal=3)
        for corner, side, thickness in ((10.0, 2.0, 0.5), (20.0, 1.0, 0.75)):
            far = corner + side
            writer.poly([[[corner, 0], [corner, side], [far, side], [far, 0], [corner, 0]]])
            writer.record(thickness)
    return tmp_path / "floes.shp"


@pytest.fixture
def study_file(small_scene: Path, tmp_path: Path) -> Path:
    """A study of the small scene, which is only read."""
    file = tmp_path / "trial.yaml"
    file.write_text(
        f"scene: {small_scene}\n"
        "factors:\n"
        "  vessel/carriage/@speed: [0.2, 0.3]\n"
        "  ice/field/@concentration: [0.3, 0.5]\n"
        "seeds: 2\n"
        "responses: [{channel: ice_load.along.mean_N, name: load}]\n"
    )
    return file


# What doctests may name, and the fixture that makes it.
DOCTEST_NAMES: dict[str, tuple[str, Callable[[Any], Any]]] = {
    "small_scene": ("small_scene", lambda scene: scene),
    "steered_scene": ("steered_scene", lambda scene: scene),
    "example_folder": ("small_folder", lambda folder: folder),
    "example_run": ("small_folder", nilas.Run),
    "breaking_run": ("breaking_folder", nilas.Run),
    "example_shapefile": ("floe_shapefile", lambda file: file),
    "example_study": ("study_file", lambda file: file),
    "example_load": ("long_load", lambda load: load),
}


def names_in(text: str, request: pytest.FixtureRequest) -> dict[str, Any]:
    """Those of the names that a doctest uses: what it does not name is not made."""
    return {
        name: made_of(request.getfixturevalue(fixture))
        for name, (fixture, made_of) in DOCTEST_NAMES.items()
        if name in text
    }


@pytest.fixture(autouse=True)
def doctest_room(
    request: pytest.FixtureRequest,
    doctest_namespace: dict[str, Any],
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> Iterator[None]:
    """Gives doctests their names, and a folder of their own to write into."""
    if isinstance(request.node, pytest.Item) and hasattr(request.node, "dtest"):
        monkeypatch.chdir(tmp_path)
        text = "".join(example.source for example in request.node.dtest.examples)
        doctest_namespace |= names_in(text, request)
    yield
