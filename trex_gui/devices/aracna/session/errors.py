"""Errors of a session with a robot: a code with fields, and the sentence for each code."""

from collections.abc import Callable
from enum import Enum, auto

from trex_gui.core.errors import BadReply, BadRequest, NoReply, StudioError
from trex_gui.core.transport.settings import PortSettings
from trex_gui.devices.aracna.protocol import commands


class ErrorCode(Enum):
    """What went wrong; `_TEXTS` shows the fields of each code."""

    NO_ROBOT = auto()
    ECHO = auto()
    BOOT_LOOP = auto()
    OTHER_DEVICE = auto()
    NOT_READY = auto()
    COMMAND_PENDING = auto()
    TIMEOUT = auto()
    UNEXPECTED_REPLY = auto()
    MOTOR_STUCK = auto()
    STUCK = auto()
    SPEEDS_REJECTED = auto()
    NO_SERVO_POWER = auto()
    SPEEDS_UNCONFIRMED = auto()
    GOALS_MISSED = auto()
    PLAYING = auto()
    SUPERSEDED = auto()
    HALTED = auto()
    RESTARTED = auto()
    OTHER_ROBOT = auto()
    NOT_RESPONDING = auto()
    CLOSED = auto()
    INTERNAL = auto()


def QT_TRANSLATE_NOOP(context: str, text: str) -> str:  # noqa: N802 - the name that lupdate finds
    """Mark a text for translation without Qt."""
    del context
    return text


_TEXTS = {
    ErrorCode.NO_ROBOT: QT_TRANSLATE_NOOP(
        "AracnaErrors",
        "No Aracna answers on {0}. It may still be moving and cannot listen meanwhile; wait until "
        "it has stopped. Check that the robot's board has power, that the adapter's TX goes to its "
        "RX and its RX to its TX (or that both radios are on the same channel), and that ground is "
        "connected.",
    ),
    ErrorCode.ECHO: QT_TRANSLATE_NOOP(
        "AracnaErrors",
        "Everything sent on {0} comes back, and nothing else: the adapter's TX and RX are joined.",
    ),
    ErrorCode.BOOT_LOOP: QT_TRANSLATE_NOOP(
        "AracnaErrors",
        "An Aracna on {0} reports that it starts, but does not answer afterwards. It may be "
        "restarting repeatedly: check its power supply.",
    ),
    ErrorCode.OTHER_DEVICE: QT_TRANSLATE_NOOP(
        "AracnaErrors",
        "Something answers on {0}, but not as an Aracna does: {1}. Another device, perhaps a TReX "
        "at another baud rate, or interference on the line.",
    ),
    ErrorCode.NOT_READY: QT_TRANSLATE_NOOP(
        "AracnaErrors", "The robot has not answered yet; it is still being queried."
    ),
    ErrorCode.COMMAND_PENDING: QT_TRANSLATE_NOOP(
        "AracnaErrors", "One command at a time: the last one has not been answered yet."
    ),
    ErrorCode.TIMEOUT: QT_TRANSLATE_NOOP("AracnaErrors", "The robot did not answer in time."),
    ErrorCode.UNEXPECTED_REPLY: QT_TRANSLATE_NOOP(
        "AracnaErrors", "The reply does not match the command: {0}."
    ),
    ErrorCode.MOTOR_STUCK: QT_TRANSLATE_NOOP(
        "AracnaErrors", "The robot is waiting for motor {0}, which does not arrive."
    ),
    ErrorCode.STUCK: QT_TRANSLATE_NOOP("AracnaErrors", "The robot is stuck: nothing was sent."),
    ErrorCode.NO_SERVO_POWER: QT_TRANSLATE_NOOP(
        "AracnaErrors", "No motor took its speed: do the servos have power?"
    ),
    ErrorCode.SPEEDS_UNCONFIRMED: QT_TRANSLATE_NOOP(
        "AracnaErrors", "The robot did not confirm its speeds, so no motor was moved. {0}"
    ),
    ErrorCode.GOALS_MISSED: QT_TRANSLATE_NOOP(
        "AracnaErrors",
        "{0}: it is blocked, or servo power was off. The sequence does not continue by itself.",
    ),
    ErrorCode.PLAYING: QT_TRANSLATE_NOOP("AracnaErrors", "A sequence is playing: stop it first."),
    ErrorCode.SUPERSEDED: QT_TRANSLATE_NOOP("AracnaErrors", "Newer speeds replaced these."),
    ErrorCode.HALTED: QT_TRANSLATE_NOOP("AracnaErrors", "Stopped before it was sent."),
    ErrorCode.RESTARTED: QT_TRANSLATE_NOOP("AracnaErrors", "The robot's board has restarted."),
    ErrorCode.OTHER_ROBOT: QT_TRANSLATE_NOOP(
        "AracnaErrors", "Another robot answers on this port now."
    ),
    ErrorCode.NOT_RESPONDING: QT_TRANSLATE_NOOP("AracnaErrors", "The robot stopped responding."),
    ErrorCode.CLOSED: QT_TRANSLATE_NOOP(
        "AracnaErrors", "The connection was closed before this was done."
    ),
    ErrorCode.INTERNAL: QT_TRANSLATE_NOOP("AracnaErrors", "Internal error in the connection: {0}"),
}
_SPEED = QT_TRANSLATE_NOOP("AracnaErrors", "motor {0} did not take its speed of {1}, it holds {2}")
_SPEED_UNREADABLE = QT_TRANSLATE_NOOP(
    "AracnaErrors", "motor {0} did not take its speed of {1}, it does not answer"
)
_MISSED = QT_TRANSLATE_NOOP("AracnaErrors", "motor {0} is {1} units off its goal")


def describe(
    code: ErrorCode, fields: tuple[object, ...], translate: Callable[[str], str] = str
) -> str:
    """Return the sentence for an error; `translate` is applied to the texts of this module."""
    match code, fields:
        case ErrorCode.SPEEDS_REJECTED, (tuple(motors),):
            parts = [
                translate(_SPEED_UNREADABLE if held < 0 else _SPEED).format(motor, speed, held)
                for motor, speed, held in motors
            ]
            return f"{_clauses(parts)}."
        case ErrorCode.GOALS_MISSED, (tuple(motors),):
            parts = [translate(_MISSED).format(motor, abs(units)) for motor, units in motors]
            return translate(_TEXTS[code]).format(_clauses(parts))
        case ErrorCode.SPEEDS_UNCONFIRMED, (RobotError() as cause,):
            return translate(_TEXTS[code]).format(describe(cause.code, cause.fields, translate))
    return translate(_TEXTS[code]).format(*fields)


def _clauses(parts: list[str]) -> str:
    text = "; ".join(parts)
    return f"{text[:1].upper()}{text[1:]}"


class RobotError(StudioError):
    """An error with a code; `str` gives its sentence in English."""

    def __init__(self, code: ErrorCode, *fields: object) -> None:
        super().__init__(code, *fields)
        self.code = code
        self.fields = fields

    def __str__(self) -> str:
        return describe(self.code, self.fields)


class RobotBusyError(RobotError, BadRequest):
    """Rejected in the present state; nothing was sent."""


class RobotNoReplyError(RobotError, NoReply):
    """The robot, or one of its servos, does not answer or respond as requested."""


class RobotBadReplyError(RobotError, BadReply):
    """Bytes arrived that are no reply to the command."""


def is_echo(received: bytes) -> bool:
    """Whether only the query itself came back."""
    query = commands.QUERY.strip()
    return query in received and not received.replace(query, b"").strip(b"\r\n\x00\xff")


def is_boot_message(received: bytes) -> bool:
    """Whether the board has reported its start and nothing else."""
    text = received.strip(b"\r\n")
    return bool(text) and not text.replace(b".h", b"").strip(b"\r\nh")


def diagnose(settings: PortSettings, received: bytes) -> RobotError:
    """Return why no Aracna was found, judged by the first bytes received."""
    where = settings.text()
    if not received.strip(b"\r\n"):
        return RobotNoReplyError(ErrorCode.NO_ROBOT, where)
    if is_echo(received):
        return RobotNoReplyError(ErrorCode.ECHO, where)
    if is_boot_message(received):
        return RobotNoReplyError(ErrorCode.BOOT_LOOP, where)
    return RobotBadReplyError(ErrorCode.OTHER_DEVICE, where, printable(received))


def suggests_scan(error: BaseException) -> bool:
    """Whether another device, or none, may be on the port: a scan may find it."""
    return isinstance(error, RobotError) and error.code in {
        ErrorCode.NO_ROBOT,
        ErrorCode.OTHER_DEVICE,
    }


def rejected_speeds(requested: tuple[int, ...], held: tuple[int, ...]) -> RobotError | None:
    """Return the error for speeds that servos did not take; `None` if all did."""
    wrong = tuple(
        (motor, speed, holds)
        for motor, (speed, holds) in enumerate(zip(requested, held, strict=True))
        if speed != holds
    )
    if not wrong:
        return None
    if all(holds < 0 for holds in held):
        return RobotNoReplyError(ErrorCode.NO_SERVO_POWER)
    return RobotNoReplyError(ErrorCode.SPEEDS_REJECTED, wrong)


def printable(data: bytes) -> str:
    """Return printable bytes as text, others as up to 12 hexadecimal numbers."""
    data = data.strip(b"\r\n")
    if data and all(0x20 <= byte < 0x7F for byte in data):
        return data.decode("ascii")
    return data[:12].hex(" ").upper() + (" …" if len(data) > 12 else "")
