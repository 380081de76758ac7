"""Turn motor 1 for two seconds, and stop it for sure: python drive.py PORT SPEED."""

import sys

from trex_gui import StudioError, Trex

try:
    with Trex(sys.argv[1]) as trex:
        trex.drive(motor_1=int(sys.argv[2]))
        trex.wait(2)  # not time.sleep: a program that does not respond is stopped
        trex.stop()
        print("The board has confirmed the stop.")
except StudioError as error:
    sys.exit(str(error))
