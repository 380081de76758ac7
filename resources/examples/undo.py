"""Bring back what a board stored before the last change: python undo.py PORT."""

import sys

from trex_gui import StudioError, Trex, snapshots

try:
    with Trex(sys.argv[1]) as trex:
        board = trex.status().product, trex.parameter("device_number")
        own = [
            one
            for one in snapshots()
            if (one.product, one.device_number) == board and not one.problem
        ]
        if not own:
            sys.exit("There is no snapshot of a board with this number.")
        print(f"Before {own[0].reason!r} at {own[0].adapter}, {own[0].taken:%Y-%m-%d %H:%M} UTC:")
        rows = trex.compare_settings(own[0].path)
        for row in rows:
            print(f"{row.name}: {row.text_before} -> {row.text_after}")
        if rows and input("Restore this? [y/N] ") == "y":
            print(f"{len(trex.apply_settings(rows))} restored.")
except StudioError as error:
    sys.exit(str(error))
