"""The examples run as they stand, at small size, and draw pictures that are not blank."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from importlib.util import find_spec
from pathlib import Path

import pytest

import nilas

plt = pytest.importorskip("matplotlib.pyplot", reason="needs python3-matplotlib of Debian")

EXAMPLES = Path(__file__).parents[3] / "examples"
# Values that stand in the place of an example's own, so that it takes seconds. An example without
# a line here is not run, so each has one.
SMALL = {
    "animation.py": {"SCENE": None, "SECONDS": 0.3},
    "first_tow.py": {"SCENE": None, "SECONDS": 0.5},
    "parameter_sweep.py": {
        "SCENE": None,
        "SPEEDS": [0.3, 0.4],
        "SEEDS": [7, 8],
        "DISTANCE": 0.05,
        "SETTINGS": {"vessel/carriage/@ramp": 0.1},
    },
    "own_solver.py": {"SCENE": None, "SECONDS": 0.3, "SWEEPS": 20},
    "read_into_pandas.py": {"SCENE": None, "SECONDS": 0.4},
    "vessel_controller.py": {"SCENE": str(EXAMPLES / "free-vessel.xml"), "SECONDS": 0.5},
}
COMPILED = {"own_solver.py", "vessel_controller.py"}


def made_small(text: str, values: dict[str, object]) -> str:
    for name, value in values.items():
        pattern = re.compile(rf"^{name} = [^\n]*$", re.MULTILINE)
        assert len(pattern.findall(text)) == 1, f"{name} must be set once, in one line"
        text = pattern.sub(lambda match, line=f"{name} = {value!r}": line, text)
    return text


@pytest.mark.parametrize("name", sorted(path.name for path in EXAMPLES.glob("*.py")))
def test_an_example_runs_and_draws(name: str, small_scene: Path, tmp_path: Path) -> None:
    if name in COMPILED and find_spec("nilas._core") is None:
        pytest.skip("needs the compiled part of the package")
    assert name in SMALL, f"{name} needs its values for small size in {Path(__file__).name}"
    values = {key: value if value else str(small_scene) for key, value in SMALL[name].items()}
    script = tmp_path / name
    script.write_text(made_small((EXAMPLES / name).read_text(), values))
    done = subprocess.run(
        [sys.executable, "-W", "error::UserWarning", script.name],
        cwd=tmp_path,
        env={
            **os.environ,
            "PYTHONPATH": str(Path(nilas.__file__).parents[1]),
            "MPLBACKEND": "Agg",
        },
        capture_output=True,
        text=True,
    )
    assert done.returncode == 0, done.stderr
    pictures = list(tmp_path.rglob("*.png"))
    pictures = [picture for picture in pictures if "trajectory" not in picture.parts]
    assert pictures, "the example draws no picture"
    for picture in pictures:
        assert plt.imread(picture)[:, :, :3].std() > 0.02, f"{picture.name} is blank"


@pytest.mark.parametrize("name", sorted(SMALL))
def test_an_example_is_a_notebook_of_a_page(name: str) -> None:
    """Percent cells: the first is text, and code and text follow in turn."""
    lines = (EXAMPLES / name).read_text().splitlines()
    cells = [line for line in lines if line.startswith("# %%")]
    assert cells[0] == "# %% [markdown]"
    assert len(cells) >= 4
    assert len(lines) <= 120
