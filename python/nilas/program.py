"""Finds the program ``nilas`` and runs its commands."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
import sysconfig
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import IO, TYPE_CHECKING, NamedTuple

from nilas.arguments import path, settings_of, several
from nilas.errors import NilasError

if TYPE_CHECKING:
    from nilas.results.run import Run

_NAME = "nilas"
# What a command's exit code says, from docs/reference/conventions.md.
_CODES = {
    2: "bad input or usage",
    3: "the numerics failed, or a check does not hold",
    4: "a file could not be read or written",
    130: "the command was interrupted",
}


class NotFound(NilasError, FileNotFoundError):
    """The program ``nilas`` is at none of the places where it is looked for.

    >>> issubclass(NotFound, NilasError) and issubclass(NotFound, FileNotFoundError)
    True
    """


class Failed(NilasError, RuntimeError):
    """A command of the program ended with an exit code other than 0.

    ``arguments``: the words after ``nilas``. ``code``: the exit code. ``message``: what the
    program wrote on standard error. ``output``: what it wrote on standard output.

    >>> try:
    ...     call("check", "there-is-none.xml")
    ... except Failed as failure:
    ...     print(failure.code, failure.arguments, "there-is-none.xml" in failure.message)
    4 ['check', 'there-is-none.xml'] True
    """

    def __init__(self, arguments: Sequence[str], code: int, message: str, output: str = "") -> None:
        self.arguments = list(arguments)
        self.code = code
        self.message = message.strip()
        self.output = output
        super().__init__(arguments, code, message, output)

    def __str__(self) -> str:
        meaning = _CODES.get(self.code)
        if meaning is None and self.code < 0:
            meaning = f"signal {signal.Signals(-self.code).name} ended it"
        head = f"nilas {' '.join(self.arguments)}: exit code {self.code}"
        head += f" ({meaning})" if meaning else ""
        return f"{head}\n{self.message}" if self.message else head


class Answer(NamedTuple):
    """What a command wrote: ``output`` on standard output, ``messages`` on standard error.

    >>> call("--version").messages
    ''
    """

    output: str
    messages: str


def program() -> Path:
    """The program ``nilas`` as an absolute path.

    The first of these that exists is taken: the file that the environment variable
    NILAS_PROGRAM names, the one inside this package, the one of the Python installation, the one
    that ``./dev build`` made in the source tree of this package, the one on the search path.

    >>> program().name
    'nilas'
    """
    named = os.environ.get("NILAS_PROGRAM")
    if named:
        if not _is_program(Path(named)):
            raise NotFound(f"NILAS_PROGRAM names {named}, which is no program that can be run.")
        return Path(named).absolute()
    places = _places()
    for place in places:
        if _is_program(place):
            return place
    on_path = _on_search_path()
    if on_path is not None:
        return on_path
    raise NotFound(
        "The program nilas was not found. It was looked for at "
        + ", ".join(str(place) for place in places)
        + " and on the search path PATH. Set NILAS_PROGRAM to its path."
    )


def call(
    *arguments: str | os.PathLike[str],
    folder: str | os.PathLike[str] | None = None,
    echo: bool = False,
) -> Answer:
    """Runs ``nilas ARGUMENTS`` to its end and returns what it wrote.

    ``folder``: the working folder of the command. ``echo``: what the command says is also shown,
    while it works. Ctrl-C reaches the command, which finishes its files, and then raises
    ``KeyboardInterrupt``. Raises ``Failed`` where the exit code is not 0, with the program's own
    message.

    >>> call("--version").output.startswith("nilas")
    True
    >>> call("check", "there-is-no-such-scene.xml")  # doctest: +IGNORE_EXCEPTION_DETAIL
    Traceback (most recent call last):
    nilas.program.Failed: ...
    """
    words = [os.fspath(argument) for argument in arguments]
    process = subprocess.Popen(
        [os.fspath(program()), *words],
        cwd=folder,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    assert process.stdout is not None and process.stderr is not None
    # Both streams are read while the command works, or it would wait when a pipe is full.
    with ThreadPoolExecutor(2) as readers:
        streams = [
            readers.submit(_read, process.stdout, sys.stdout if echo else None),
            readers.submit(_read, process.stderr, sys.stderr if echo else None),
        ]
        _wait(process)
    output, messages = (stream.result() for stream in streams)
    if process.returncode != 0:
        raise Failed(words, process.returncode, messages, output)
    return Answer(output, messages)


def run(
    scene: str | os.PathLike[str],
    *,
    out: str | os.PathLike[str],
    settings: Mapping[str, object] | None = None,
    until: float | None = None,
    seed: int | None = None,
    threads: int | None = None,
    force: bool = False,
    echo: bool = False,
    options: Sequence[str] = (),
) -> Run:
    """Runs a scene as ``nilas run`` does, and returns its run.

    ``scene``: the XML file. ``out``: the run folder. ``settings``: attributes of the scene as
    ``--set`` takes them, ``{"vessel/carriage/@speed": 0.4}``. ``until``: end [s]. ``seed``: seed
    of the ice. ``force``: an earlier run in the folder is replaced. ``echo``: what the program says
    is shown. ``options``: further options
    of the command line. Raises ``Failed`` where the run fails or the scene has a fault.

    >>> first = run(small_scene, out="first", settings={"time/@end": 0.1})
    >>> first.status
    'done'
    """
    from nilas.results.run import Run
    from nilas.values import written

    words = [path("scene", scene), "--out", path("out", out), *several("options", options)]
    if not echo:
        words.append("--quiet")
    for place, value in settings_of(settings).items():
        words += ["--set", f"{place}={written(value)}"]
    for option, number in (("--until", until), ("--seed", seed), ("--threads", threads)):
        if number is not None:
            words += [option, written(number)]
    if force:
        words.append("--force")
    call("run", *words, echo=echo)
    return Run(out)


def _is_program(path: Path) -> bool:
    """Whether a file can be run and is no Python script: such a script calls this package."""
    if not path.is_file() or not os.access(path, os.X_OK):
        return False
    with path.open("rb") as file:
        head = file.readline(200)
    return not (head.startswith(b"#!") and b"python" in head)


def _places() -> list[Path]:
    package = Path(__file__).resolve().parent
    return [
        package / "bin" / _NAME,
        Path(sys.prefix) / "bin" / _NAME,
        Path(sysconfig.get_path("scripts")) / _NAME,
        package.parents[1] / "build" / "release" / _NAME,
    ]


def _on_search_path() -> Path | None:
    for folder in os.get_exec_path():
        place = Path(folder or ".") / _NAME
        if _is_program(place):
            return place.absolute()
    return None


def _read(stream: IO[str], shown: IO[str] | None) -> str:
    """All that a stream holds. Each line is also written to ``shown`` when it comes."""
    lines = []
    with stream:
        for line in stream:
            lines.append(line)
            if shown is not None:
                shown.write(line)
                shown.flush()
    return "".join(lines)


def _wait(process: subprocess.Popen[str]) -> None:
    """Waits for the end. After Ctrl-C the command may finish its files; a second one ends it.

    A terminal sends the signal to the command too, but the interrupt of a notebook does not.
    Two signals are to the command as one.
    """
    try:
        process.wait()
    except KeyboardInterrupt:
        try:
            process.send_signal(signal.SIGINT)
            process.wait()
        except KeyboardInterrupt:
            process.kill()
            process.wait()
        raise
