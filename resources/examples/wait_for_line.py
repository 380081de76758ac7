"""Wait until no other program uses the line, then read: python wait_for_line.py PORT."""

import sys
import time

from trex_gui import PortUnavailable, Trex

while True:
    try:
        with Trex(sys.argv[1]) as trex:
            print(f"{trex.status().product}: the line is free.")
        break
    except PortUnavailable as error:  # such as: another program uses it
        print(error)
        time.sleep(1)
