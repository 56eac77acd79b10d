"""The exceptions of the package. All of them are ``NilasError``.

Every message is a whole sentence that names the place and what is allowed, as the program's messages do.

>>> issubclass(InputError, NilasError)
True
"""


class NilasError(Exception):
    """Anything that went wrong in Nilas."""


class InputError(NilasError, ValueError):
    """A scene, a problem or an argument is wrong."""


class UnknownName(InputError, KeyError):
    """A body, a column or another thing of this name does not exist. The message names those that come near.

    It is a KeyError too, as that of a dictionary.
    """

    __str__ = Exception.__str__  # that of KeyError puts the message in quotes


class FileError(NilasError, OSError):
    """A file cannot be opened, read or written."""


class SimulationError(NilasError):
    """The numerics failed: a body left finite numbers, or a solver stopped a scene that asks for it."""


class Defect(NilasError):
    """A fault of Nilas itself. Please report it."""
