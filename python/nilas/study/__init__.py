"""Studies: many runs of one scene, with factors, seeds, one table and one page.

``python3 -m nilas.study STUDY.yaml`` carries out a study, and so does ``main`` with the words of that
command. ``describe`` reads the study file and makes the plan, ``carry_out`` runs it, and ``results``
writes the tables and the page.
"""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nilas.study.command import main as main
    from nilas.study.describe.faults import StudyError as StudyError
    from nilas.study.describe.plan import Plan as Plan
    from nilas.study.describe.read_study import read_study as read_study

# The module that each public name comes from. They are imported when they are first used, since they need PyYAML.
_HOMES = {
    "Plan": "nilas.study.describe.plan",
    "StudyError": "nilas.study.describe.faults",
    "main": "nilas.study.command",
    "read_study": "nilas.study.describe.read_study",
}

__all__ = list(_HOMES)


def __getattr__(name: str) -> Any:
    """Imports a public name from its module at its first use (PEP 562)."""
    if name not in _HOMES:
        raise AttributeError(f"nilas.study has no '{name}'. It has {', '.join(_HOMES)}.")
    return getattr(import_module(_HOMES[name]), name)
