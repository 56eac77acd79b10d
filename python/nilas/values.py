"""Values of attributes as the text of a scene file."""

import math
import numbers
from collections.abc import Iterable
from typing import Any

import numpy as np

from nilas.errors import InputError


def written(value: Any) -> str:
    """The text of a value: numbers read back to the same bits, and lists have blanks between their items.

    >>> written(0.1), written(True), written([1, 2.5, 0]), written("coulomb")
    ('0.1', 'true', '1 2.5 0', 'coulomb')
    >>> written(float("nan"))
    Traceback (most recent call last):
    nilas.errors.InputError: A value of a scene must be finite; found nan.
    """
    if isinstance(value, str):
        return value
    if isinstance(value, np.ndarray) and value.ndim == 0:
        value = value.item()
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        if not math.isfinite(value):
            raise InputError(f"A value of a scene must be finite; found {value}.")
        return repr(float(value))
    if hasattr(value, "__fspath__"):
        return str(value.__fspath__())
    if isinstance(value, Iterable) and not isinstance(value, (bytes, dict, set)):
        return " ".join(written(item) for item in value)
    raise InputError(f"{value!r} is no value of a scene; allowed: numbers, words, booleans, paths and lists of them.")
