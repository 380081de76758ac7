"""Drive the boards 7 and 9 of one line as one robot: python drive_two.py PORT SPEED."""

import sys

from trex_gui import StudioError, TrexLine

try:
    with TrexLine(sys.argv[1], boards=(7, 9)) as line:
        speed = int(sys.argv[2])
        line.drive(speed, speed)  # both motors of each board
        line.wait(1)
        line[9].drive(0)  # motor 1 of one board
        line.wait(1)
        line.stop()
        print("Both boards have confirmed the stop.")
except StudioError as error:  # names the board
    sys.exit(str(error))
