"""Messages about names that do not exist."""

import difflib

from nilas.errors import InputError


def unknown(statement: str, name: str, allowed: list[str], form: str = "{}") -> InputError:
    """An error that suggests the nearest name, or lists the allowed ones where none is near.

    >>> str(unknown("There is no fruit 'aple'", "aple", ["apple", "pear"]))
    "There is no fruit 'aple'; did you mean apple?"
    >>> str(unknown("There is no fruit 'x'", "x", ["apple", "pear"]))
    "There is no fruit 'x'; allowed: apple, pear."
    """
    near = difflib.get_close_matches(name, allowed, n=1)
    if near:
        return InputError(f"{statement}; did you mean {form.format(near[0])}?")
    names = ", ".join(form.format(one) for one in allowed) or "none"
    return InputError(f"{statement}; allowed: {names}.")
