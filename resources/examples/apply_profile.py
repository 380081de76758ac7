"""Store the settings of a file, only what differs: python apply_profile.py PORT FILE."""

import sys

from trex_gui import StudioError, Trex

try:
    with Trex(sys.argv[1]) as trex:
        for row in trex.compare_settings(sys.argv[2]):
            print(f"{row.name}: {row.text_before or 'not known'} -> {row.text_after}")
        print(f"{len(trex.apply_settings(sys.argv[2]))} written and read back.")
except StudioError as error:
    sys.exit(str(error))
