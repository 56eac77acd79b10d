"""The exceptions of the package.

Every message is a whole sentence that names the place and what is allowed, as the program's messages do.

>>> issubclass(InputError, NilasError)
True
"""


class NilasError(Exception):
    """Anything that went wrong in Nilas."""


class InputError(NilasError, ValueError):
    """A scene, a problem or an argument is wrong."""


class FileError(NilasError, OSError):
    """A file cannot be opened, read or written."""


class SimulationError(NilasError):
    """The numerics failed: a body left finite numbers, or a solver stopped a scene that asks for it."""


class Defect(NilasError):
    """A fault of Nilas itself. Please report it."""
