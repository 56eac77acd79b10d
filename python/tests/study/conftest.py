"""Makes the package and the helpers of this folder known to the tests of studies."""

import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1])]

from study_desk import Desk  # noqa: E402


@pytest.fixture
def desk(tmp_path: Path) -> Desk:
    """A folder with a scene, where studies are written and carried out."""
    return Desk(tmp_path)
