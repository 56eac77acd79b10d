"""``python3 -m nilas.loads``."""

import sys

from nilas.loads.command import main

sys.exit(main())
