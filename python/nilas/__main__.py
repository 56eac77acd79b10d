"""`python3 -m nilas` and the command `nilas` of an installed package: the program itself."""

import os
import sys
from typing import NoReturn

from nilas.program import NotFound, program

_FILE_MISSING = 4  # exit code, as the program has it


def main() -> NoReturn:
    """Becomes the program, with the words of the command line.

    >>> import subprocess, sys
    >>> words = [sys.executable, "-m", "nilas", "--version"]
    >>> subprocess.run(words, capture_output=True, text=True).stdout.startswith("nilas")
    True
    """
    try:
        path = os.fspath(program())
    except NotFound as error:
        print(f"error: {error}", file=sys.stderr)
        sys.exit(_FILE_MISSING)
    os.environ.setdefault("NILAS_PYTHON", sys.executable)  # for the commands that the package carries out
    os.execv(path, [path, *sys.argv[1:]])


if __name__ == "__main__":
    main()
