"""``python3 -m nilas.study``."""

import sys

from nilas.study.command import main

sys.exit(main())
