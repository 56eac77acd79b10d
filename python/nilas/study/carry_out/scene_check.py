"""Checks the scene and the responses of a study before the first run begins."""

from __future__ import annotations

import subprocess
import tempfile
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator
from pathlib import Path

from nilas.study.carry_out.launch import Launcher, override_words
from nilas.study.carry_out.outputs import Outputs, faults_of, outputs_of
from nilas.study.describe.factor import Factor, Level
from nilas.study.describe.faults import StudyError
from nilas.study.describe.plan import Plan
from nilas.study.describe.study import Response

# A run ends with the first step that reaches its end, so this makes one step of any length [s].
_ONE_STEP = 1e-7
_LONGEST_TRIAL_S = 600
_TO_CHANGE = "Correct them, or make the runs without this check: --no-check."


def check_scene(plan: Plan, launcher: Launcher) -> list[Response]:
    """Lets the program check the first point, and the ends of each factor one by one.

    A value that is wrong in the middle of a list fails alone, when its turn comes. Then one step of
    the first point shows the names of its outputs, and so whether the responses exist. Returns
    those of which it does not tell. Raises ``StudyError`` with the words of the program and the
    line of the factor or the response.
    """
    if not plan.points:
        raise StudyError(f"{plan.study.file}: The study has no points.")
    first = plan.points[0]
    base = dict(plan.study.overrides)
    values = base | dict(first.overrides)
    faults = _faults(launcher, values)
    if not faults:
        refused = []
        for factor, level in zip(plan.study.factors, first.levels, strict=True):
            for end in _ends(factor):
                if end.label != level.label:
                    text = _faults(launcher, values | dict(end.overrides))
                    if text:
                        refused.append(_told(plan, factor, end, text))
        if refused:
            raise StudyError("\n".join(refused))
        return _check_responses(plan, launcher, values)
    # Which factor is to blame shows when each is left out in turn.
    for factor, level in zip(plan.study.factors, first.levels, strict=True):
        alone = _faults(launcher, base | dict(level.overrides))
        if alone and not _faults(launcher, base):
            raise StudyError(_told(plan, factor, level, alone))
    raise StudyError(
        f"{plan.study.file}: the scene with the values of the first point is refused.\n{faults}"
    )


def _check_responses(plan: Plan, launcher: Launcher, values: dict[str, str]) -> list[Response]:
    """Refuses responses that no run has, as far as one step of the first point and of the ends tells it."""
    responses = list(plan.study.responses)
    first = _tried(launcher, values)
    if first is None:
        return responses
    absent = [response for response in responses if first.has(response) is False]
    # A factor may add what a response asks for, such as another body.
    for other in _other_ends(plan, values) if absent else ():
        outputs = _tried(launcher, other)
        absent = [] if outputs is None else [one for one in absent if outputs.has(one) is False]
        if not absent:
            break
    if absent:
        raise StudyError("\n".join([*faults_of(plan.study, first, absent), _TO_CHANGE]))
    return [response for response in responses if first.has(response) is None]


def _other_ends(plan: Plan, values: dict[str, str]) -> Iterator[dict[str, str]]:
    """The values of the first point with each factor at its other ends in turn."""
    for factor, level in zip(plan.study.factors, plan.points[0].levels, strict=True):
        for end in _ends(factor):
            if end.label != level.label:
                yield values | dict(end.overrides)


def _tried(launcher: Launcher, values: dict[str, str]) -> Outputs | None:
    """The names of the outputs of one step with these values; None where it could not be made."""
    scene = launcher.plan.study.scene
    with tempfile.TemporaryDirectory(prefix="nilas-study-") as folder:
        command = [str(launcher.program), "run", str(scene), "--out", folder, "--force", "--quiet"]
        command += ["--until", repr(_start(scene, values) + _ONE_STEP)]
        command += override_words(values)
        try:
            answer = subprocess.run(command, capture_output=True, timeout=_LONGEST_TRIAL_S)
        except subprocess.TimeoutExpired:
            return None
        return outputs_of(Path(folder), is_whole=False) if answer.returncode == 0 else None


def _start(scene: Path, values: dict[str, str]) -> float:
    """When the scene begins [s]."""
    time = ElementTree.parse(scene).getroot().find("time")
    return float(values.get("time/@start", "0" if time is None else time.get("start", "0")))


def _ends(factor: Factor) -> list[Level]:
    if factor.low is not None and not factor.levels:
        return [factor.level_at(0.0), factor.level_at(1.0 - 1e-9)]
    return [factor.levels[0], factor.levels[-1]] if factor.levels else []


def _told(plan: Plan, factor: Factor, level: Level, text: str) -> str:
    place = f"{plan.study.file}:{factor.line}: factors.{factor.name}"
    return f"{place}: the value {level.label} is refused.\n{text}"


def _faults(launcher: Launcher, values: dict[str, str]) -> str:
    """What the program says against the scene with these values, or nothing."""
    command = [str(launcher.program), "check", str(launcher.plan.study.scene), "--quiet"]
    answer = subprocess.run(command + override_words(values), capture_output=True, text=True)
    return "" if answer.returncode == 0 else answer.stderr.strip() or answer.stdout.strip()
