"""``python3 -m nilas.validate``."""

import sys

from nilas.validate.command import main

sys.exit(main())
