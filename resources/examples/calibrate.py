"""Calibrate a channel from its stick: python calibrate.py PORT CHANNEL."""

import sys

from trex_gui import Calibration, Trex

channel = int(sys.argv[2])
with Trex(sys.argv[1]) as trex:
    print("Leave the stick in the middle.")
    rest = [row[f"channel_{channel}_raw"] for row in trex.measurements(seconds=2)]
    print("Move it to both ends.")
    moved = [row[f"channel_{channel}_raw"] for row in trex.measurements(seconds=4)]
    middle = sorted(count for count in rest if isinstance(count, int))
    ends = [count for count in moved if isinstance(count, int)]
    if not middle or not ends:
        sys.exit("There is no signal.")
    calibration = Calibration(
        minimum=min(ends),
        neutral=middle[len(middle) // 2],
        maximum=max(ends),
        deadband=trex.calibration(channel).deadband,
    )
    trex.set_calibration(channel, calibration)
    print("Stored:", trex.calibration(channel))
