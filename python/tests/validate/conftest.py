"""Makes the package and the tools of this folder known to the tests of validation."""

import sys
from pathlib import Path

import pytest

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1]), str(HERE.parent / "study")]

from validation_desk import ValidationDesk  # noqa: E402


@pytest.fixture
def desk(tmp_path: Path) -> ValidationDesk:
    """A folder with a scene, where cases are written and carried out."""
    return ValidationDesk(tmp_path)
