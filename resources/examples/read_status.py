"""Read what a board reports, and one setting: python read_status.py PORT."""

import sys

from trex_gui import Trex

with Trex(sys.argv[1]) as trex:
    status = trex.status()
    print(f"{status.product} {status.firmware}: {status.mode}")
    print(f"Currents: {status.currents[0]:.2f} A, {status.currents[1]:.2f} A")
    for number, channel in status.channels.items():
        print(f"Channel {number}: {channel.value}, remapped {channel.remapped}")
    print("Errors:", ", ".join(status.errors) or "none")
    print("Serial timeout:", trex.parameter_text("serial_timeout"))
