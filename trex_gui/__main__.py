"""`python -m trex_gui`: open the window."""

import sys

from trex_gui.app import main

sys.exit(main())
