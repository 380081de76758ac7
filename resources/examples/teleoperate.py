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
    try:
        while (key := click.getchar()) != "q":
            keys.put(key)
    finally:  # also after Ctrl-C, which arrives here
        keys.put("q")


threading.Thread(target=read_keys, daemon=True).start()
try:
    with Trex(sys.argv[1]) as trex:
        typed = ""
        while "q" not in typed:
            trex.wait(0.1)  # without a call for half a second the motors are stopped
            typed = ""
            while not keys.empty():  # all of them: a key that is held repeats faster
                typed += keys.get()
            if typed and set(typed) <= SPEEDS.keys():
                trex.drive(*SPEEDS[typed[-1]])
            elif typed:
                trex.stop()
except StudioError as error:
    sys.exit(str(error))
