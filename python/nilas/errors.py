"""The exceptions of the package. All of them are ``NilasError``.

Every message is a whole sentence that names the place and what is allowed, as the program's messages do.

>>> issubclass(InputError, NilasError)
True
"""


class NilasError(Exception):
    """Anything that went wrong in Nilas.

    >>> issubclass(FileError, NilasError) and issubclass(Defect, NilasError)
    True
    """


class InputError(NilasError, ValueError):
    """A scene, a problem or an argument is wrong. It is a ValueError too.

    >>> import nilas
    >>> try:
    ...     nilas.Simulation(small_scene, threads=0)
    ... except nilas.InputError as error:
    ...     print(error)
    threads must be at least 1
    """


class UnknownName(InputError, KeyError):
    """A body, a column or another thing of this name does not exist. The message names those that come near.

    It is a KeyError too, as that of a dictionary.

    >>> example_run.bodies.place("shp")
    Traceback (most recent call last):
    nilas.errors.UnknownName: There is no body 'shp'; did you mean ship?
    """

    __str__ = Exception.__str__  # that of KeyError puts the message in quotes


class FileError(NilasError, OSError):
    """A file cannot be opened, read or written. It is an OSError too.

    >>> import nilas
    >>> nilas.Simulation("there-is-none.xml")  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    nilas.errors.FileError: there-is-none.xml: ...
    """


class SimulationError(NilasError):
    """The numerics failed: a body left finite numbers, or a solver stopped a scene that asks for it.

    >>> import nilas
    >>> hasty = {"tolerance": 1e-14, "on_failure": "stop", "max_iterations": 1, "solver": "nsgs"}
    >>> settings = {f"contact/@{name}": value for name, value in hasty.items()}
    >>> nilas.Simulation(small_scene, settings=settings).run()  # doctest: +ELLIPSIS
    Traceback (most recent call last):
    nilas.errors.SimulationError: ...
    """


class Defect(NilasError):
    """A fault of Nilas itself. Please report it.

    >>> issubclass(Defect, InputError)
    False
    """
