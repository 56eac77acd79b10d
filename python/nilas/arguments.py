"""What arguments must be. A wrong one is named in the message, with what was found.

>>> whole("threads", 2), number("until", 0.5), word("solver", "auto"), several("columns", ["x_m"])
(2, 0.5, 'auto', ['x_m'])
"""

import numbers
import os
from collections.abc import Iterable, Mapping
from typing import Any

from nilas.errors import InputError


def whole(name: str, value: Any) -> int:
    """A whole number.

    >>> whole("threads", 1.5)
    Traceback (most recent call last):
    nilas.errors.InputError: threads is a whole number; found 1.5.
    """
    if isinstance(value, bool) or not isinstance(value, numbers.Integral):
        raise InputError(f"{name} is a whole number; found {value!r}.")
    return int(value)


def number(name: str, value: Any) -> float:
    """A real number.

    >>> number("until", "3")
    Traceback (most recent call last):
    nilas.errors.InputError: until is a number; found '3'.
    """
    if isinstance(value, bool) or not isinstance(value, numbers.Real):
        raise InputError(f"{name} is a number; found {value!r}.")
    return float(value)


def word(name: str, value: Any) -> str:
    """A text.

    >>> word("law", None)
    Traceback (most recent call last):
    nilas.errors.InputError: law is a text; found None.
    """
    if not isinstance(value, str):
        raise InputError(f"{name} is a text; found {value!r}.")
    return value


def several(name: str, values: Iterable[str]) -> list[str]:
    """A list of texts: a single text would be taken letter by letter.

    >>> several("columns", "x_m")
    Traceback (most recent call last):
    nilas.errors.InputError: columns is a list; write columns=['x_m'].
    """
    if isinstance(values, str):
        raise InputError(f"{name} is a list; write {name}=[{values!r}].")
    if not isinstance(values, Iterable):
        raise InputError(f"{name} is a list; found {values!r}.")
    return list(values)


def path(name: str, value: Any, other: str = "") -> str:
    """A path of a file. ``other``: what else is allowed, for the message.

    >>> path("scene", None, "a nilas.Scene")
    Traceback (most recent call last):
    nilas.errors.InputError: scene is a nilas.Scene or the path of a file; found None.
    """
    if not isinstance(value, (str, os.PathLike)):
        either = f"{other} or " if other else ""
        found = "None" if value is None else f"a {type(value).__name__}"
        raise InputError(f"{name} is {either}the path of a file; found {found}.")
    return os.fspath(value)


def settings_of(settings: Mapping[str, Any] | None) -> dict[str, Any]:
    """Values by the paths of ``--set``; none for None.

    >>> settings_of([("time/@end", 2)])
    Traceback (most recent call last):
    nilas.errors.InputError: settings is a dict, as {'time/@end': 2}; found [('time/@end', 2)].
    """
    if settings is None:
        return {}
    if not isinstance(settings, Mapping):
        raise InputError(f"settings is a dict, as {{'time/@end': 2}}; found {settings!r}.")
    return dict(settings)
