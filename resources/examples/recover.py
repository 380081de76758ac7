"""Restore what a board has lost of the settings applied last: python recover.py PORT."""

import sys

from trex_gui import StudioError, Trex

try:
    with Trex(sys.argv[1]) as trex:
        lost = trex.lost_settings()
        if any(row.key == "device_number" for row in lost):
            sys.exit("This may be another board: it has the device number of the factory.")
        for row in lost:
            print(f"{row.name} is {row.text_before}, and {row.text_after} was applied.")
        print(f"{len(trex.apply_settings(lost))} restored.")
except StudioError as error:
    sys.exit(str(error))
