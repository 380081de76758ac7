"""Write the motor currents as CSV: python log_currents.py PORT SECONDS."""

import csv
import sys

from trex_gui import Trex

columns = ["time_s", "motor_1_current_A", "motor_2_current_A"]
rows = csv.DictWriter(sys.stdout, columns, extrasaction="ignore")
rows.writeheader()
with Trex(sys.argv[1]) as trex:
    for row in trex.measurements(seconds=float(sys.argv[2])):
        rows.writerow(row)
