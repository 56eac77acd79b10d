"""``python3 -m nilas.study``."""

import sys

from nilas.study.needs import told
from nilas.study.tell import warn

try:
    from nilas.study.command import main
except ModuleNotFoundError as missing:
    if missing.name != "yaml":
        raise
    warn(told(["yaml"]))
    sys.exit(4)

sys.exit(main())
