"""Command lines that are sent to the robot.

Speeds and positions are sent as one value of one to four digits per motor. The firmware does not
reject invalid lines. Too few values restart it, an empty field counts as 10, and letters count as
digits.
"""

from collections.abc import Sequence

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.aracna.protocol.joints import HIGHEST

BAUD = 38_400  # 38400 8N1, without flow control
QUERY = b".q\n"  # the chip can store these three bytes while the firmware is busy
EMPTY = b"\n"  # ends an incomplete line, which the firmware then handles; otherwise no effect


def led(*, on: bool) -> bytes:
    return b".l1\n" if on else b".l0\n"


def speeds(values: Sequence[int], motors: int) -> bytes:
    """Return the command that sets the servos' speeds, 0-1023 (0: unlimited)."""
    return _line("v", tr_noop("the speed of motor {0} must be 0 to {1}, not {2}"), values, motors)


def positions(values: Sequence[int], motors: int) -> bytes:
    """Return the command that moves the servos to goals, 0-1023."""
    return _line(
        "c", tr_noop("the position of motor {0} must be 0 to {1}, not {2}"), values, motors
    )


def _line(letter: str, rejection: str, values: Sequence[int], motors: int) -> bytes:
    if len(values) != motors:
        raise BadRequest(tr("{0} motors need {0} values, not {1}").format(motors, len(values)))
    for motor, value in enumerate(values):
        if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value <= HIGHEST:
            raise BadRequest(tr(rejection).format(motor, HIGHEST, repr(value)))
    return f".{letter}{','.join(map(str, values))}\n".encode("ascii")
