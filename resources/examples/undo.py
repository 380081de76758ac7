"""Bring back what a board stored before the last change: python undo.py PORT."""

import sys

from trex_gui import StudioError, Trex, snapshots

try:
    with Trex(sys.argv[1]) as trex:
        number = trex.parameter("device_number")
        own = [one for one in snapshots() if one.device_number == number and not one.problem]
        if not own:
            sys.exit("There is no snapshot of this board.")
        print(f"Before {own[0].reason!r}, {own[0].taken:%Y-%m-%d %H:%M} UTC:")
        for key in trex.apply_settings(own[0].path):
            print(f"{key} restored.")
except StudioError as error:
    sys.exit(str(error))
