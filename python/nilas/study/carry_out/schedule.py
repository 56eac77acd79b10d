"""Carries out runs on this machine, a number of them at a time."""

from __future__ import annotations

import os
import signal
import time
from dataclasses import dataclass

from nilas.study.carry_out.launch import INTERRUPTED, Child, Launcher
from nilas.study.carry_out.progress import Progress
from nilas.study.carry_out.queue import Queue
from nilas.study.carry_out.records import Records, response_value

_SIGNALS = {signal.SIGINT, signal.SIGTERM, signal.SIGCHLD}


@dataclass
class Outcome:
    """What a session did. ``idle_s``: time in which a place was free although runs waited.
    ``out_of_time``: whether it was stopped because its time was used up."""

    ran: int = 0
    failed: int = 0
    interrupted: bool = False
    out_of_time: bool = False
    wall_s: float = 0.0
    processor_s: float = 0.0
    idle_s: float = 0.0
    slots: int = 1

    @property
    def efficiency(self) -> float:
        """Processor time of all runs over the time of all places."""
        return self.processor_s / (self.slots * self.wall_s) if self.wall_s > 0 else 0.0


class Scheduler:
    """Keeps ``slots`` children of the program running until the queue is empty.

    It is one thread that sleeps until a child ends or a signal comes. Signals are blocked but
    while it sleeps, so that none comes amid the writing of a record.
    """

    def __init__(
        self,
        queue: Queue,
        records: Records,
        launcher: Launcher,
        slots: int,
        progress: Progress,
        ends_at: float | None = None,
    ) -> None:
        """``ends_at``: the time of ``time.monotonic`` at which runs are stopped as by Ctrl-C."""
        self.queue = queue
        self.records = records
        self.launcher = launcher
        self.progress = progress
        self.outcome = Outcome(slots=slots)
        self._children: dict[int, Child] = {}
        self._freed: list[float] = []
        self._limit_s = launcher.plan.study.run.limit_s
        self._ends_at = ends_at

    def carry_out(self) -> Outcome:
        """Runs until nothing is left, or until Ctrl-C or SIGTERM. Records are then on disk.

        First it waits for runs of the same folder whose study was killed and that still end.
        """
        self.launcher.wait_for_earlier_runs()
        before = signal.pthread_sigmask(signal.SIG_BLOCK, _SIGNALS)
        begun = time.monotonic()
        try:
            self._fill()
            while self._children:
                self._wait()
                self._fill()
        finally:
            for child in self._children.values():
                _send(child, signal.SIGKILL)
            self.outcome.wall_s = time.monotonic() - begun
            signal.pthread_sigmask(signal.SIG_SETMASK, before)
        return self.outcome

    def _fill(self) -> None:
        """Starts runs until all places are taken."""
        self._watch_the_clock()
        while not self.outcome.interrupted and len(self._children) < self.outcome.slots:
            run = self.queue.next()
            if run is None:
                return
            child = self.launcher.start(run)
            self._children[child.process.pid] = child
            if self._freed:
                self.outcome.idle_s += time.monotonic() - self._freed.pop()

    def _wait(self) -> None:
        """Sleeps until something happens, then deals with it."""
        got = signal.sigtimedwait(_SIGNALS, self._time_left())
        if got is not None and got.si_signo in (signal.SIGINT, signal.SIGTERM):
            self._stop()
        self._watch_the_clock()
        self._end_slow()
        self._reap()

    def _reap(self) -> None:
        ended = []
        # One SIGCHLD may stand for several children.
        for pid in list(self._children):
            found, status, usage = os.wait4(pid, os.WNOHANG)
            if found:
                child = self._children.pop(pid)
                child.process.returncode = os.waitstatus_to_exitcode(status)
                self._freed.append(time.monotonic())
                ended.append((child, usage.ru_utime + usage.ru_stime))
        # The next runs begin first: no processor waits while records are written. Only where the
        # first run is still to show whether the responses exist, others wait for that.
        is_stopping = any(child.process.returncode == INTERRUPTED for child, _ in ended)
        if not is_stopping and not self.launcher.watched:
            self._fill()
        for child, processor_s in ended:
            self._take(child, child.process.returncode, processor_s)

    def _take(self, child: Child, code: int, processor_s: float) -> None:
        self.outcome.processor_s += processor_s
        record = self.launcher.finish(child, code, processor_s)
        if record is None:
            if self.launcher.is_begun_again(child.run) and not self.outcome.interrupted:
                self.progress.say(f"{child.run.name} cannot be continued and begins again.")
                self.queue.put_back(child.run)
            elif not self.outcome.interrupted:
                # Another process stopped the run, as a cluster does at the end of its time.
                self._stop()
            return
        self.records.write(child.run, record)
        failed = record.status != "done"
        self.outcome.ran += 1
        self.outcome.failed += failed
        response = self.queue.stopping_response
        value = response_value(record, response) if response else None
        self.queue.finished(child.run, value, failed, float(record.times["wall_s"]))
        self.progress.ended(record, len(self.queue) + len(self._children))
        if self.launcher.faults and not self.outcome.interrupted:
            self._stop()

    def _watch_the_clock(self) -> None:
        """Stops the runs once the time of the session is used up."""
        if self._ends_at is None or self.outcome.interrupted or time.monotonic() < self._ends_at:
            return
        self.outcome.out_of_time = True
        self._stop()

    def _stop(self) -> None:
        """The first request lets runs write their checkpoints. The second ends them at once."""
        if self.outcome.interrupted:
            for child in self._children.values():
                _send(child, signal.SIGKILL)
            return
        self.outcome.interrupted = True
        if self._children:
            self.progress.say(
                "Stopping: the runs write their checkpoints. Ctrl-C again ends them at once."
            )
        for child in self._children.values():
            _send(child, signal.SIGINT)

    def _time_left(self) -> float:
        """Seconds until the next run is too slow or the session ends, or a long time."""
        left = 3600.0
        if self._limit_s is not None and self._children:
            oldest = min(child.started for child in self._children.values())
            left = min(left, oldest + self._limit_s - time.time())
        if self._ends_at is not None and not self.outcome.interrupted:
            left = min(left, self._ends_at - time.monotonic())
        return max(left, 0.05)

    def _end_slow(self) -> None:
        if self._limit_s is None:
            return
        for child in self._children.values():
            if not child.too_slow and time.time() - child.started > self._limit_s:
                child.too_slow = True
                _send(child, signal.SIGKILL)


def _send(child: Child, number: int) -> None:
    """Sends a signal. Popen's own method would look for the child's end, and take its status."""
    try:
        os.kill(child.process.pid, number)
    except ProcessLookupError:
        pass
