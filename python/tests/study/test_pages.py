"""The reference names every key and file of a study."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

import nilas
from nilas.study.describe import read_factors, read_responses, read_study
from nilas.study.describe.study import DESIGNS, KEEPS, STATISTICS

PACKAGE = Path(nilas.__file__).parents[1]
DOCS = Path(__file__).resolve().parents[3] / "docs"
KEYS = {
    *read_study.TOP_KEYS,
    *read_study.DESIGN_KEYS,
    *read_study.SEEDS_KEYS,
    *(f"until.{key}" for key in read_study.UNTIL_KEYS),
    *read_study.RUN_KEYS,
    *read_study.JOB_KEYS,
    *read_factors.FACTOR_KEYS,
    *read_responses.RESPONSE_KEYS,
    *DESIGNS,
    *KEEPS,
    *STATISTICS,
}


def test_the_reference_has_every_key():
    page = (DOCS / "reference/study.md").read_text()
    assert not [key for key in sorted(KEYS) if f"`{key}`" not in page]


@pytest.mark.parametrize("name", ["concentration-speed"])
def test_the_examples_are_valid_and_stand_on_the_page(name):
    file = DOCS.parent / "examples/studies" / f"{name}.yaml"
    read_study.read_study(file)
    page = (DOCS / "howto/run-a-study.md").read_text()
    lines = [line for line in file.read_text().splitlines() if not line.startswith("#")]
    assert "\n".join(lines) in page


def test_the_examples_can_be_copied_to_any_folder(tmp_path):
    """Nothing in them leads back into the source tree: scene, hull and responses are checked elsewhere."""
    folder = shutil.copytree(DOCS.parent / "examples/studies", tmp_path / "mine")
    studies = sorted(folder.glob("*.yaml"))
    assert studies
    for study in studies:
        answer = subprocess.run(
            [sys.executable, "-m", "nilas.study", study.name, "--dry-run"],
            cwd=folder,
            env=os.environ | {"PYTHONPATH": str(PACKAGE)},
            capture_output=True,
            text=True,
        )
        assert answer.returncode == 0, answer.stderr
        assert "9 points (full), 4 seeds each: 36 runs." in answer.stdout
