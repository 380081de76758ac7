"""Lines to the robot, strictly: what the firmware makes of anything else is no error but harm.

Too few values restart it, an empty field is a 10, letters are arithmetic; so nothing leaves here
but whole lines with one value of one to four digits for each motor, and a bare newline.
"""

from collections.abc import Sequence

from trex_gui.core.errors import BadRequest
from trex_gui.devices.aracna.protocol.units import HIGHEST

BAUD = 38_400
"""Its UART, 8N1, without flow control."""

QUERY = b".q\n"
"""Three bytes: as many as survive in the chip while the firmware is busy."""

NOTHING = b"\n"
"""Ends what may stand in the firmware's line buffer; by itself it does nothing."""

LED = {True: b".l1\n", False: b".l0\n"}


def speeds(values: Sequence[int], motors: int) -> bytes:
    """Return the line that gives every servo a speed, 0-1023; 0 is as fast as it can.

    Raises:
        BadRequest: too few values, too many, or one out of range.
    """
    return _line("v", "speed", values, motors)


def positions(values: Sequence[int], motors: int) -> bytes:
    """Return the line that sends every servo to a goal, 0-1023.

    Raises:
        BadRequest: too few values, too many, or one out of range.
    """
    return _line("c", "position", values, motors)


def _line(letter: str, what: str, values: Sequence[int], motors: int) -> bytes:
    if len(values) != motors:
        raise BadRequest(f"{motors} motors need {motors} values, not {len(values)}")
    for motor, value in enumerate(values):
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= HIGHEST:
            raise BadRequest(f"the {what} of motor {motor} is 0 to {HIGHEST}, not {value!r}")
    return f".{letter}{','.join(map(str, values))}\n".encode("ascii")
