"""Tells how far a study is."""

from __future__ import annotations

import time

from nilas.study.carry_out.record import Record
from nilas.study.tell import warn
from nilas.study.words import duration

# A longer study tells every hundredth part of itself when nobody watches.
_EACH_RUN_UP_TO = 400


class Progress:
    """Lines on standard error: one for each run, or for each hundredth of a long study."""

    def __init__(self, done_before: int, quiet: bool) -> None:
        self.quiet = quiet
        self._ended = done_before
        self._begun = time.monotonic()
        self._here = 0
        self._told = -1

    def say(self, text: str) -> None:
        if not self.quiet:
            warn(text)

    def ended(self, record: Record, left: int) -> None:
        """A run ended, and ``left`` are waiting or running."""
        self._ended += 1
        self._here += 1
        total = self._ended + left
        percent = 100 * self._ended // total
        failed = record.status != "done"
        if total > _EACH_RUN_UP_TO and percent == self._told and not failed and left:
            return
        self._told = percent
        width = len(str(total))
        line = f"[{self._ended:{width}}/{total}] {record.run}  {duration(record.times['wall_s'])}"
        if failed:
            line += f"  FAILED: {record.message}"
        elif record.message:
            line += f"  {record.message}"
        if left:
            spent = time.monotonic() - self._begun
            line += f"  {duration(spent / self._here * left)} left"
        self.say(line)
