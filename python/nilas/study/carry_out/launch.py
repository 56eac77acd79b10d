"""Starts one run of the program, and records what came of it."""

from __future__ import annotations

import ctypes
import hashlib
import json
import os
import re
import shutil
import signal
import subprocess
import tempfile
import time
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import IO

from nilas.study.carry_out.columns import ColumnMissing, column_value
from nilas.study.carry_out.lock import wait_until_left
from nilas.study.carry_out.outputs import faults_of, outputs_of
from nilas.study.carry_out.provenance import (
    file_hash,
    input_hash,
    machine_facts,
    program_facts,
    scene_hash,
)
from nilas.study.carry_out.record import BEGUN, Record, flat_numbers, write_whole
from nilas.study.carry_out.records import column_key
from nilas.study.describe.plan import Plan, Run
from nilas.study.describe.read_factors import RUN_FLAGS
from nilas.study.describe.study import Response

INTERRUPTED = 130
_NUMERICS_FAILED = 3
_TOO_SLOW = 124  # as the command timeout has it
_CHECKPOINT = "checkpoint.h5"
_KEPT_AS_SUMMARY = {"summary.json", "scene.xml", "nilas.log", "record.json"}
_LONGEST_MESSAGE = 600
_NO_REASON = re.compile(r"\W*warn|\d+ faults?$", re.IGNORECASE)


@dataclass
class Child:
    """A run that is under way."""

    run: Run
    process: subprocess.Popen[bytes]
    errors: IO[bytes]
    command: list[str]
    resumed: bool
    started: float
    too_slow: bool = False


class Launcher:
    """Starts runs of a plan. Nothing here waits: that is the scheduler's part."""

    def __init__(self, plan: Plan, program: Path) -> None:
        self.plan = plan
        self.program = program
        # Responses that no finished run had so far, and what is wrong with them, once one ended without them.
        self.watched: list[Response] = []
        self.faults: list[str] = []
        self._scene = scene_hash(plan.study.scene)
        self._afresh: set[str] = set()

    def key(self, run: Run) -> str:
        """Hash of all that the results of a run depend on, the program left out."""
        overrides = self.overrides(run)
        folder = self.plan.study.scene.parent
        inputs = [input_hash(folder, value) for value in overrides.values()]
        made_of = json.dumps([self._scene, list(overrides.items()), inputs, run.seed])
        return hashlib.sha256(made_of.encode()).hexdigest()[:24]

    def overrides(self, run: Run) -> dict[str, str]:
        """The values of ``--set``: those of the study, then those of the point.

        A replicate with the ice of the scene has its number as that of the perturbed run.
        """
        own = {"seed/@twin": str(run.seed)} if self.plan.study.seeds.perturbed else {}
        return dict(self.plan.study.overrides) | dict(run.point.overrides) | own

    def command(self, run: Run) -> list[str]:
        """The command that makes a run from its beginning."""
        study = self.plan.study
        words = [str(self.program), "run", str(study.scene), "--out", str(self.plan.folder(run))]
        words += ["--force", "--quiet", "--threads", str(study.run.threads)]
        if not study.seeds.perturbed:
            words += ["--seed", str(run.seed)]
        if study.run.checkpoint_every:
            words += ["--checkpoint-every", f"{study.run.checkpoint_every:g}"]
        return words + override_words(self.overrides(run))

    def wait_for_earlier_runs(self) -> None:
        """Returns once no process writes a run that was begun and has not ended.

        Raises ``StudyError`` where one goes on writing.
        """
        for begun in self.plan.study.runs_folder.rglob(BEGUN):
            wait_until_left(begun.parent)

    def start(self, run: Run) -> Child:
        """Starts a run: from its newest checkpoint if it was interrupted, else from nothing."""
        folder = self.plan.folder(run)
        resumed = self._can_resume(run)
        command = self.command(run)
        if resumed:
            threads = str(self.plan.study.run.threads)
            command = [
                str(self.program),
                "run",
                "--resume",
                str(folder),
                "--quiet",
                "--threads",
                threads,
            ]
        elif self._was_begun(run) is not None:
            # Files of an earlier beginning are not those of this run.
            shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True, exist_ok=True)
        write_whole(folder / BEGUN, json.dumps({"key": self.key(run)}))
        errors = tempfile.TemporaryFile()
        process = subprocess.Popen(
            command,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL,
            stderr=errors,
            preexec_fn=partial(_prepare_child, os.getpid()),
        )
        return Child(run, process, errors, command, resumed, time.time())

    def finish(self, child: Child, code: int, processor_s: float) -> Record | None:
        """The record of a run that ended, or None where it is to be continued or begun again.

        ``code``: the exit code, or minus the number of the signal that ended it.
        """
        text = _read_end(child.errors)
        if code in (INTERRUPTED, -signal.SIGINT, -signal.SIGTERM) and not child.too_slow:
            return None
        if child.resumed and code not in (0, _NUMERICS_FAILED):
            # Another build of the program, or a torn checkpoint: only a new beginning helps.
            self._afresh.add(child.run.name)
            return None
        folder = self.plan.folder(child.run)
        summary = _summary(folder) if code in (0, _NUMERICS_FAILED) else {}
        message = self._message(child, code, text, summary)
        record = Record(
            run=child.run.name,
            point=child.run.point.name,
            seed=child.run.seed,
            key=self.key(child.run),
            status="done" if code == 0 and summary else "failed",
            exit_code=_TOO_SLOW if child.too_slow else (code if code >= 0 else 128 - code),
            message=message,
            values=flat_numbers(summary),
            overrides=self.overrides(child.run),
        )
        self._add_columns(record, folder)
        self._watch(record, folder)
        record.times = self._times(child, folder, summary, processor_s)
        record.provenance = self._provenance(child, folder, summary)
        self._keep(record, folder)
        return record

    def is_begun_again(self, run: Run) -> bool:
        """Whether a run could not be continued and has to begin again now."""
        return run.name in self._afresh

    def _can_resume(self, run: Run) -> bool:
        if run.name in self._afresh or not (self.plan.folder(run) / _CHECKPOINT).exists():
            return False
        return self._was_begun(run) == self.key(run)

    def _was_begun(self, run: Run) -> str | None:
        """The key of a run that was begun and never finished, "" where it cannot be read."""
        try:
            text = (self.plan.folder(run) / BEGUN).read_text(encoding="utf-8")
        except OSError:
            return None
        try:
            return str(json.loads(text)["key"])
        except (ValueError, KeyError, TypeError):
            return ""

    def _message(self, child: Child, code: int, text: str, summary: dict) -> str:
        """Why a run failed, or ended early, in one line that is the same on every machine."""
        if child.too_slow:
            return f"The run took longer than limit_s, {self.plan.study.run.limit_s:g} s."
        if code == 0 and summary:
            return str(summary.get("ended_early", ""))
        if code < 0:
            return f"Signal {signal.Signals(-code).name} ended the program."
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        # Warnings, and the last line that counts the faults, do not say why.
        told = [line for line in lines if not _NO_REASON.match(line)] or lines
        message = "; ".join(told) or f"The program ended with exit code {code} and no message."
        message = message.replace(str(self.plan.study.out), "OUT")
        return re.sub(r"\s+", " ", message)[:_LONGEST_MESSAGE]

    def _add_columns(self, record: Record, folder: Path) -> None:
        if record.status != "done":
            return
        for response in self.plan.study.responses:
            if response.column:
                try:
                    record.columns[column_key(response)] = column_value(folder, response)
                except ColumnMissing as error:
                    record.message = f"{record.message} {error}".strip()

    def _watch(self, record: Record, folder: Path) -> None:
        """The first run that is done tells whether the responses exist that are watched."""
        if not self.watched or record.status != "done":
            return
        watched, self.watched = self.watched, []
        outputs = outputs_of(folder)
        if outputs is not None:
            self.faults = faults_of(self.plan.study, outputs, watched)

    def _times(self, child: Child, folder: Path, summary: dict, processor_s: float) -> dict:
        files = [path for path in folder.rglob("*") if path.is_file()]
        return {
            # What summary.json says covers earlier sessions of a resumed run too.
            "wall_s": summary.get("wall_s", round(time.time() - child.started, 3)),
            "processor_s": summary.get("processor_s", round(processor_s, 3)),
            "begun": _utc(child.started),
            "ended": _utc(time.time()),
            "files": len(files),
            "bytes": sum(path.stat().st_size for path in files),
        }

    def _provenance(self, child: Child, folder: Path, summary: dict) -> dict:
        scene = folder / "scene.xml"
        return {
            "program": program_facts(self.program),
            "libraries": summary.get("versions", {}),
            "scene_sha256": self._scene,
            "scene_as_run_sha256": file_hash(scene) if scene.is_file() else "",
            "study_sha256": file_hash(self.plan.study.file),
            "machine": machine_facts(),
            "command": child.command,
            "resumed": child.resumed,
        }

    def _keep(self, record: Record, folder: Path) -> None:
        """Removes what the study does not keep of a run that is done."""
        (folder / BEGUN).unlink(missing_ok=True)
        keep = self.plan.study.run.keep
        if keep == "all" or record.status != "done":
            return
        kept = _KEPT_AS_SUMMARY if keep == "summary" else set()
        for path in list(folder.iterdir()):
            if path.is_dir() and not path.is_symlink():
                shutil.rmtree(path, ignore_errors=True)
            elif path.name not in kept:
                path.unlink(missing_ok=True)


def override_words(overrides: dict[str, str]) -> list[str]:
    """Overrides as words of a command line: flags of ``nilas run`` first, then ``--set``.

    >>> override_words({"time/@end": "5", "--scale": "16"})
    ['--scale', '16', '--set', 'time/@end=5']
    """
    flags = [
        word for path, value in overrides.items() if path in RUN_FLAGS for word in (path, value)
    ]
    settings = [f"{path}={value}" for path, value in overrides.items() if path not in RUN_FLAGS]
    return flags + (["--set", *settings] if settings else [])


def _prepare_child(parent: int) -> None:
    """Takes the signals of the scheduler off, and asks to be stopped where it dies.

    Ctrl-C in a terminal goes to all processes of the group. The child leaves the group, so that
    the scheduler alone decides how a run is stopped.
    """
    os.setpgid(0, 0)
    signal.pthread_sigmask(signal.SIG_SETMASK, [])
    set_parent_death_signal = 1  # PR_SET_PDEATHSIG of Linux
    ctypes.CDLL(None).prctl(set_parent_death_signal, signal.SIGTERM)
    if os.getppid() != parent:  # It died before the request.
        os.kill(os.getpid(), signal.SIGKILL)


def _read_end(stream: IO[bytes]) -> str:
    """The last text that a run wrote on standard error."""
    size = stream.seek(0, os.SEEK_END)
    stream.seek(max(0, size - 20000))
    text = stream.read().decode("utf-8", errors="replace")
    stream.close()
    return text


def _summary(folder: Path) -> dict:
    try:
        return json.loads((folder / "summary.json").read_text(encoding="utf-8"))
    except (OSError, ValueError):
        return {}


def _utc(seconds: float) -> str:
    return time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(seconds))
