"""List what a board stores, as wire values and with units: python list_parameters.py PORT."""

import sys

from trex_gui import Trex

with Trex(sys.argv[1]) as trex:
    for key, wire in trex.parameters.items():
        print(f"{key:28}{wire:4}  {trex.parameter_text(key)}")
