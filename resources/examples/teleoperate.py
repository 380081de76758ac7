"""Drive with the keys of a terminal: python teleoperate.py PORT.

w and s: forward and back; a and d: turn; space: stop; q: end.
"""

import queue
import sys
import threading

import click

from trex_gui import StudioError, Trex

SPEEDS = {"w": (40, 40), "s": (-40, -40), "a": (-30, 30), "d": (30, -30)}
keys: queue.SimpleQueue[str] = queue.SimpleQueue()


def read_keys() -> None:
    while (key := click.getchar()) != "q":
        keys.put(key)
    keys.put("q")


threading.Thread(target=read_keys, daemon=True).start()
try:
    with Trex(sys.argv[1]) as trex:
        key = ""
        while key != "q":
            trex.wait(0.1)  # without a call for half a second the motors are stopped
            key = "" if keys.empty() else keys.get()
            if key in SPEEDS:
                trex.drive(*SPEEDS[key])
            elif key:
                trex.stop()
except StudioError as error:
    sys.exit(str(error))
