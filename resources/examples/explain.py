"""Say why the motors do not run, and which errors occurred: python explain.py PORT."""

import sys

from trex_gui import Trex

with Trex(sys.argv[1]) as trex:
    trex.wait(0.5)  # until the first errors were read
    for reason in trex.motor_status():
        print("-", reason)
    for error in trex.errors():
        if error.count:
            print(f"- {error.name}, {error.count} times: {error.meaning} {error.remedy}")
    for event in trex.events():
        print(f"  {event.time:.1f} s: {event.text}")
