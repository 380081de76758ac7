"""`python -m trex_gui` opens the window."""

import sys

from trex_gui.app import main

sys.exit(main())
