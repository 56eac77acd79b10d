"""Nilas in Python: read run folders, run scenes, hand results to other programs.

All quantities are in SI units. Names of columns and keys end in their unit, as in
``contact_fx_N``; angles in tables are in degrees (``yaw_deg``).

Names are imported when they are first used. So ``import nilas`` is quick, and a part that is not
installed is missed only where it is needed.

>>> import nilas
>>> "Run" in dir(nilas)
True
>>> nilas.__version__ == nilas.version()
True
"""

from importlib import import_module
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from nilas.checks import compare as compare
    from nilas.checks import verify as verify
    from nilas.contact import Problem as Problem
    from nilas.contact import Solution as Solution
    from nilas.contact import measure as measure
    from nilas.contact import solve as solve
    from nilas.contact import solvers as solvers
    from nilas.contact import version as version
    from nilas.errors import Defect as Defect
    from nilas.errors import FileError as FileError
    from nilas.errors import InputError as InputError
    from nilas.errors import NilasError as NilasError
    from nilas.errors import SimulationError as SimulationError
    from nilas.errors import UnknownName as UnknownName
    from nilas.exchange.fclib import FclibProblem as FclibProblem
    from nilas.exchange.fclib import read_fclib as read_fclib
    from nilas.exchange.shapefile import field_from_shapefile as field_from_shapefile
    from nilas.loads.ice_ahead import ice_ahead as ice_ahead
    from nilas.loads.ice_ahead import load_and_ice_ahead as load_and_ice_ahead
    from nilas.loads.peaks import load_peaks as load_peaks
    from nilas.loads.spectrum import load_spectrum as load_spectrum
    from nilas.program import Failed as Failed
    from nilas.program import NotFound as NotFound
    from nilas.program import call as call
    from nilas.program import run as run
    from nilas.results.folder import NoRun as NoRun
    from nilas.results.folder import UnfinishedRun as UnfinishedRun
    from nilas.results.run import Run as Run
    from nilas.results.runs import Runs as Runs
    from nilas.results.runs import runs as runs
    from nilas.scene.element import Element as Element
    from nilas.scene.scene import Scene as Scene
    from nilas.simulation import Simulation as Simulation

# The module that each public name comes from.
_HOMES = {
    # scenes, simulations and contact problems in this process
    "Element": "nilas.scene.element",
    "Problem": "nilas.contact",
    "Scene": "nilas.scene.scene",
    "Simulation": "nilas.simulation",
    "Solution": "nilas.contact",
    "measure": "nilas.contact",
    "solve": "nilas.contact",
    "solvers": "nilas.contact",
    "version": "nilas.contact",
    # errors
    "Defect": "nilas.errors",
    "FileError": "nilas.errors",
    "InputError": "nilas.errors",
    "NilasError": "nilas.errors",
    "SimulationError": "nilas.errors",
    "UnknownName": "nilas.errors",
    # the program
    "Failed": "nilas.program",
    "NotFound": "nilas.program",
    "call": "nilas.program",
    "compare": "nilas.checks",
    "run": "nilas.program",
    "verify": "nilas.checks",
    # results
    "NoRun": "nilas.results.folder",
    "Run": "nilas.results.run",
    "Runs": "nilas.results.runs",
    "UnfinishedRun": "nilas.results.folder",
    "runs": "nilas.results.runs",
    # statistics of loads
    "ice_ahead": "nilas.loads.ice_ahead",
    "load_and_ice_ahead": "nilas.loads.ice_ahead",
    "load_peaks": "nilas.loads.peaks",
    "load_spectrum": "nilas.loads.spectrum",
    # exchange with other programs
    "FclibProblem": "nilas.exchange.fclib",
    "field_from_shapefile": "nilas.exchange.shapefile",
    "read_fclib": "nilas.exchange.fclib",
}

# It is missing where only the sources of the package are at hand.
_COMPILED = "nilas._core"

__all__ = list(_HOMES)


def __getattr__(name: str) -> Any:
    """Imports a public name from its module at its first use (PEP 562)."""
    if name == "study":
        return import_module("nilas.study")
    if name == "__version__":
        return __getattr__("version")()
    if name not in _HOMES:
        raise AttributeError(f"Nilas has no '{name}'. It has {', '.join(sorted(_HOMES))}.")
    try:
        value = getattr(import_module(_HOMES[name]), name)
    except ImportError as missing:
        if find_spec(_COMPILED) is not None:
            raise
        raise ImportError(
            f"nilas.{name} needs the compiled part of the package, which is not here or is that of another Python. "
            "Install a wheel or the Debian package, or put build/release/python on PYTHONPATH after ./dev build."
        ) from missing
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted(set(globals()) | set(_HOMES))
