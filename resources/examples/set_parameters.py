"""Store settings and read them back: python set_parameters.py PORT."""

import sys

from trex_gui import StudioError, Trex

try:
    with Trex(sys.argv[1]) as trex:
        changed = trex.set_parameters(
            serial_timeout="0.5 s", uart_error_shutdown=1, motor1_acceleration=20
        )
        for key in changed:
            print(f"{key}: {trex.parameter_text(key)}")
        print(f"{len(changed)} changed.")
except StudioError as error:
    sys.exit(str(error))
