"""Times and sizes as people read them."""

from __future__ import annotations


def duration(seconds: float) -> str:
    """A time as people read it.

    >>> duration(4.25), duration(125), duration(7500), duration(200000)
    ('4.2 s', '2 min 5 s', '2 h 5 min', '2 d 7 h')
    """
    if seconds < 60:
        return f"{seconds:.1f} s"
    if seconds < 3600:
        return f"{int(seconds) // 60} min {int(seconds) % 60} s"
    if seconds < 86400:
        return f"{int(seconds) // 3600} h {int(seconds) % 3600 // 60} min"
    return f"{int(seconds) // 86400} d {int(seconds) % 86400 // 3600} h"


def size(count: float) -> str:
    """A number of bytes as people read it.

    >>> size(1234), size(5.6e7)
    ('1.2 kB', '56 MB')
    """
    for limit, unit in ((1e12, "TB"), (1e9, "GB"), (1e6, "MB"), (1e3, "kB")):
        if count >= limit:
            value = count / limit
            return f"{value:.1f} {unit}" if value < 10 else f"{value:.0f} {unit}"
    return f"{count:.0f} B"
