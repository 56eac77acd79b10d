"""``python3 -m nilas.study``."""

import os
import sys

from nilas.study.needs import told
from nilas.study.tell import NO_MEMORY, settle, warn

try:
    from nilas.study.command import carried_out

    code = carried_out()
except ModuleNotFoundError as missing:
    if missing.name != "yaml":
        raise
    warn(told(["yaml"]))
    code = 4
except MemoryError:
    warn(NO_MEMORY)
    settle()
    # The end of Python needs memory as well, and would tell at length that there is none.
    os._exit(4)

sys.exit(code)
