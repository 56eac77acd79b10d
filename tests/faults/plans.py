"""Chooses which calls fail, how, and in which time."""

from __future__ import annotations

import errno
import random
import time
from collections.abc import Iterator

from interpose import Plan

# What makes a call of each class fail in practice.
_ERRORS = {
    "open": (errno.EMFILE, errno.EACCES),
    "read": (errno.EIO,),
    "write": (errno.ENOSPC, errno.EIO),
    "sync": (errno.EIO,),
    "rename": (errno.ENOSPC, errno.EACCES),
    "unlink": (errno.EACCES,),
    "truncate": (errno.EIO,),
    "folder": (errno.ENOSPC, errno.EACCES),
    "close": (errno.ENOSPC,),
    "lock": (errno.ENOLCK, errno.EWOULDBLOCK),
    "stat": (errno.EIO,),
    "memory": (errno.ENOMEM,),
    "mmap": (errno.ENOMEM,),
    "process": (errno.EAGAIN,),
    "thread": (errno.EAGAIN,),
}
# Faults that stay: a full disk, a broken one, and a machine without memory.
_LASTING = {"write", "read", "memory", "sync", "open"}
KINDS = tuple(_ERRORS)


def plans(kind: str, calls: int, most: int, chance: random.Random, only: int | None = None) -> list[Plan]:
    """Plans for a class of so many calls: all of them, or as many as `most`, drawn evenly; or those of one call.

    Their order is drawn, too, so that those tried until some instant are a sample of all.
    """
    if only is not None:
        return [plan for plan in _all(kind, min(only, calls)) if plan.at == only][:most]
    every = list(_all(kind, calls)) if calls * 3 <= 20000 else list(_spread(kind, calls, min(most, calls), chance))
    return chance.sample(every, min(len(every), most))


def _all(kind: str, calls: int) -> Iterator[Plan]:
    for at in range(1, calls + 1):
        for error in _ERRORS[kind]:
            yield Plan(kind, at, str(error))
        if kind == "write":
            yield Plan(kind, at, "short")
        if kind in _LASTING:
            yield Plan(kind, at, str(_ERRORS[kind][0]), lasting=True)


def _spread(kind: str, calls: int, most: int, chance: random.Random) -> Iterator[Plan]:
    """One call of each of as many stretches as there are plans: most allocations are at the start."""
    for k in range(most):
        at = 1 + int(calls * (k + chance.random()) / most)
        yield Plan(kind, at, str(_ERRORS[kind][0]), lasting=kind in _LASTING and k % 2 == 1)


def share_of_time(end: float, shares: int) -> float:
    """When the first of so many equal shares of the time until the end is over."""
    now = time.monotonic()
    return now + max(0.0, end - now) / shares
