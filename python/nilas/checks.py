"""Cases with known answers, and comparisons of settings, by the program."""

import json
import os
from typing import TYPE_CHECKING, Any

from nilas.arguments import path, several
from nilas.program import Failed, call

if TYPE_CHECKING:
    import pandas

_DOES_NOT_HOLD = 3  # exit code of the program


def verify(
    *,
    cases: list[str] | None = None,
    solvers: list[str] | None = None,
    laws: list[str] | None = None,
) -> "pandas.DataFrame":
    """Runs cases with known answers and returns a row per case, solver and law, with its error and its bound.

    `verdict` is `holds` where the error is within the bound. Without `cases` all are run, which takes minutes.

    >>> set(verify(cases=["A1"])["verdict"])
    {'holds'}
    """
    import pandas

    words = ["verify", "--json", "--quiet"]
    for name, values in (("case", cases), ("solver", solvers), ("law", laws)):
        for value in several(f"{name}s", values or []):
            words += [f"--{name}", value]
    return pandas.DataFrame(_json_of(words)["rows"])


def compare(
    scene: str | os.PathLike[str],
    *,
    out: str | os.PathLike[str],
    options: list[str] | None = None,
) -> dict[str, Any]:
    """Compares solvers, laws and steps on a scene, as `nilas compare` does, and returns what it stores as compare.json.

    `out` is the folder of the comparison, with its page and pictures. `options` are further words of the command line,
    such as `["--budget", "300"]`. An earlier comparison in the folder is continued.

    >>> few = ["--solvers", "nsgs", "--laws", "coulomb", "--until", "0.02", "--seeds", "1", "--budget", "30"]
    >>> settings = compare(small_scene, out="comparison", options=few)["settings"]
    >>> [(one["label"], one["solver"], one["step_s"]) for one in settings]
    [('own setting', 'auto', 0.01), ('nsgs', 'nsgs', 0.01)]
    """
    words = ["compare", path("scene", scene), "--out", path("out", out), "--json", "--quiet"]
    return _json_of(words + several("options", options or []))


def _json_of(words: list[str]) -> Any:
    try:
        return json.loads(call(*words).output)
    except Failed as failure:
        if failure.code == _DOES_NOT_HOLD and failure.output:
            return json.loads(failure.output)
        raise
