"""Checks the scene with the values of a study before the first run begins."""

from __future__ import annotations

import subprocess

from nilas.study.carry_out.launch import Launcher
from nilas.study.describe.factor import Factor, Level
from nilas.study.describe.faults import StudyError
from nilas.study.describe.plan import Plan


def check_scene(plan: Plan, launcher: Launcher) -> None:
    """Lets the program check the first point, and the ends of each factor one by one.

    A value that is wrong in the middle of a list fails alone, when its turn comes. Raises
    ``StudyError`` with the words of the program and the line of the factor.
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
        return
    # Which factor is to blame shows when each is left out in turn.
    for factor, level in zip(plan.study.factors, first.levels, strict=True):
        alone = _faults(launcher, base | dict(level.overrides))
        if alone and not _faults(launcher, base):
            raise StudyError(_told(plan, factor, level, alone))
    raise StudyError(
        f"{plan.study.file}: the scene with the values of the first point is refused.\n{faults}"
    )


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
    settings = [f"{path}={value}" for path, value in values.items()]
    answer = subprocess.run(
        command + (["--set", *settings] if settings else []), capture_output=True, text=True
    )
    return "" if answer.returncode == 0 else answer.stderr.strip() or answer.stdout.strip()
