"""Errors of a session with a robot: codes, fields and sentences."""

from collections.abc import Sequence
from enum import Enum, unique

from trex_gui.core.errors import BadReply, BadRequest, CodedError, InternalError, NoReply
from trex_gui.core.texts import hex_text, signed_text
from trex_gui.core.translation import tr_noop
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.protocol import commands

TOLERANCE = 12
"""Maximum difference in units (3.5 degrees) at which a goal counts as reached.

A free servo stops at its goal if its compliance margin is 0. A greater difference means that the
servo carries a load, or that it lost power during the motion."""

ABORT_TOLERANCE = 50
"""Difference in units above which a sequence is aborted, as in the authors' self-test.

A greater difference means that the motor is blocked, or that servo power was off."""


@unique
class ErrorCode(Enum):
    """Error of a session. The value is its sentence with placeholders."""

    NO_ROBOT = tr_noop(
        "No Aracna responds on {0}. If the robot is moving, wait until it stops: it does not "
        "listen while it moves. Check that the robot's board has power, that the adapter's "
        "TX is connected to the board's RX and the adapter's RX to the board's TX (or that "
        "both radios are on the same channel), and that ground is connected."
    )
    ECHO = tr_noop(
        "No Aracna responds on {0}: everything sent comes back, and nothing else arrives. "
        "The adapter's TX and RX are joined; an Aracna never echoes."
    )
    BOOT_LOOP = tr_noop(
        "An Aracna on {0} reports that it has started, but does not respond afterwards. It "
        "may be restarting repeatedly. Check its power supply."
    )
    OTHER_DEVICE = tr_noop(
        "A reply arrived on {0}, but not from an Aracna: {1}. The cause may be another "
        "device, perhaps a TReX at another baud rate, or interference on the line."
    )
    NOT_READY = tr_noop("The robot has not replied yet. Wait until it responds, then try again.")
    COMMAND_PENDING = tr_noop("The robot has not yet replied to the last command.")
    TIMEOUT = tr_noop("The robot did not reply in time.")
    UNEXPECTED_REPLY = tr_noop("The reply does not match the command: {0}.")
    MOTOR_STUCK = tr_noop(
        "The robot is waiting for motor {0} and reads no commands until this motor responds."
    )
    STUCK = tr_noop("The robot is stuck: nothing was sent.")
    SPEEDS_REJECTED = "{0}"
    SPEED_REJECTED = tr_noop("Motor {0} did not accept speed {1}; it still has speed {2}.")
    SPEED_UNREADABLE = tr_noop("Motor {0} did not accept speed {1}: it does not respond.")
    NO_SERVO_POWER = tr_noop("No motor accepted its speed. Check the servo power.")
    SPEEDS_UNCONFIRMED = tr_noop("The robot did not confirm its speeds, so no motor was moved. {0}")
    GOALS_MISSED = tr_noop(
        "{0} The motor is blocked, or servo power was off. Remove the cause, then play the "
        "sequence again."
    )
    GOAL_MISSED = tr_noop("Motor {0} is at {1}, {2} from its goal {3}.")
    POSITION_UNREADABLE = tr_noop("Motor {0} did not report its position (−1).")
    PLAYING = tr_noop("A sequence is playing: stop it first.")
    SUPERSEDED = tr_noop("A newer request replaced this one.")
    HALTED = tr_noop("Stopped before the command was sent.")
    RESTARTED = tr_noop("The robot's board has restarted.")
    OTHER_ROBOT = tr_noop("Another robot now responds on this port.")
    NOT_RESPONDING = tr_noop("The robot stopped responding.")
    CLOSED = tr_noop("The connection was closed before the request was complete.")
    INTERNAL = tr_noop("Internal error in the connection: {0}")


class RobotError(CodedError):
    """Error of a session with a robot."""


class RobotBusyError(RobotError, BadRequest):
    """The request is rejected in the current state. Nothing was sent."""


class RobotNoReplyError(RobotError, NoReply):
    """The robot or a servo does not reply, or does not comply."""


class RobotBadReplyError(RobotError, BadReply):
    """The received bytes are not a reply to the command."""


class RobotInternalError(RobotError, InternalError):
    """Bug in the session. The field is the text of the exception."""


def diagnose(settings: PortSettings, received: bytes) -> RobotError:
    """Return the reason why no Aracna was found, based on the received bytes."""
    line, query = settings.text(), commands.QUERY.strip()
    if not received.strip(b"\r\n"):
        return RobotNoReplyError(ErrorCode.NO_ROBOT, line)
    if query in received and not received.replace(query, b"").strip(b"\r\n\x00\xff"):
        return RobotNoReplyError(ErrorCode.ECHO, line)
    if not received.replace(b".h", b"").strip(b"\r\nh"):  # only reports of a start
        return RobotNoReplyError(ErrorCode.BOOT_LOOP, line)
    return RobotBadReplyError(ErrorCode.OTHER_DEVICE, line, printable(received))


def suggests_scan(error: BaseException) -> bool:
    return isinstance(error, RobotError) and error.code in {
        ErrorCode.NO_ROBOT,
        ErrorCode.OTHER_DEVICE,
    }


def missed_goals(
    goals: Sequence[int], present: Sequence[int], tolerance: int = TOLERANCE
) -> dict[int, RobotError]:
    """Return an error for each motor that missed its goal or is unreadable."""
    errors = {}
    for motor, (goal, position) in enumerate(zip(goals, present, strict=False)):
        if position < 0:
            errors[motor] = RobotError(ErrorCode.POSITION_UNREADABLE, motor)
        elif abs(position - goal) > tolerance:
            difference = signed_text(position - goal)
            errors[motor] = RobotError(ErrorCode.GOAL_MISSED, motor, position, difference, goal)
    return errors


def rejected_speeds(requested: tuple[int, ...], held: tuple[int, ...]) -> RobotError | None:
    """Return the error for rejected speeds. `None`: all were accepted."""
    if held != requested and all(speed < 0 for speed in held):
        return RobotNoReplyError(ErrorCode.NO_SERVO_POWER)
    errors = tuple(
        RobotError(ErrorCode.SPEED_UNREADABLE, motor, goal)
        if speed < 0
        else RobotError(ErrorCode.SPEED_REJECTED, motor, goal, speed)
        for motor, (goal, speed) in enumerate(zip(requested, held, strict=True))
        if speed != goal
    )
    return RobotNoReplyError(ErrorCode.SPEEDS_REJECTED, errors) if errors else None


def printable(data: bytes) -> str:
    """Return printable text, or up to 12 bytes as hexadecimal numbers."""
    data = data.strip(b"\r\n")
    if data and all(0x20 <= byte < 0x7F for byte in data):
        return data.decode("ascii")
    return hex_text(data[:12]) + (" …" if len(data) > 12 else "")
