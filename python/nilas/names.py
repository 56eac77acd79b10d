"""Messages about names that do not exist."""

import difflib
from collections.abc import Iterable

from nilas.errors import UnknownName

_FEW = 40  # of more things than this not all names are listed
_NEAREST = 3


def unknown(
    statement: str, name: str, allowed: Iterable[str], form: str = "{}", what: str = ""
) -> UnknownName:
    """An error that suggests the nearest names, or tells the allowed ones.

    ``form``: how a name is shown. ``what``: what the names belong to, in the plural, where there
    may be any number of them. Of many only the number, the first and the last are told.

    >>> str(unknown("There is no fruit 'aple'", "aple", ["apple", "pear"]))
    "There is no fruit 'aple'; did you mean apple?"
    >>> str(unknown("There is no fruit 'x'", "x", ["apple", "pear"]))
    "There is no fruit 'x'; allowed: apple, pear."
    >>> floes = [f"floe {number}" for number in range(1, 501)]
    >>> str(unknown("There is no body 'flo 7'", "flo 7", floes, what="bodies"))
    "There is no body 'flo 7'; did you mean floe 7, floe 97 or floe 87? There are 500 bodies, from floe 1 to floe 500."
    >>> str(unknown("There is no body 'x'", "x", floes, what="bodies"))
    "There is no body 'x'; there are 500 bodies, from floe 1 to floe 500."
    """
    names = list(dict.fromkeys(one for one in allowed if one))
    shown = [form.format(one) for one in names]
    is_long = bool(what) and len(names) > _FEW
    number = f"here are {len(names)} {what}, from {shown[0]} to {shown[-1]}." if is_long else ""
    count = _NEAREST if is_long else 1
    near = [form.format(one) for one in difflib.get_close_matches(name, names, n=count)]
    if near:
        suggestion = f"{statement}; did you mean {_either(near)}?"
        return UnknownName(f"{suggestion} T{number}" if number else suggestion)
    if number:
        return UnknownName(f"{statement}; t{number}")
    return UnknownName(f"{statement}; allowed: {', '.join(shown) or 'none'}.")


def _either(names: list[str]) -> str:
    return " or ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)
