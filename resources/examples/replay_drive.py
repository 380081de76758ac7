"""Drive as a CSV file says, and stop: python replay_drive.py PORT FILE.

Its columns are time_s, motor_1 and motor_2: seconds from the start, and speeds of -127 to 127.
"""

import csv
import sys
from pathlib import Path

from trex_gui import StudioError, Trex

with Path(sys.argv[2]).open(newline="") as file:
    steps = [
        (float(row["time_s"]), int(row["motor_1"]), int(row["motor_2"]))
        for row in csv.DictReader(file)
    ]
try:
    with Trex(sys.argv[1]) as trex:
        now = 0.0
        for moment, left, right in steps:
            trex.wait(moment - now)
            now = moment
            trex.drive(left, right)
        trex.stop()
except StudioError as error:
    sys.exit(str(error))
