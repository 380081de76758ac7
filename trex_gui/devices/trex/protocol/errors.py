"""Error codes and messages of a connection to a board."""

from enum import Enum, IntEnum, unique

from trex_gui.core.errors import BadReply, BadRequest, CodedError, InternalError, NoReply
from trex_gui.core.translation import tr_noop
from trex_gui.core.transport.settings import PortSettings


class ResultCode(IntEnum):
    """Reply to 0xA0-0xA4 and 0xAF."""

    OK = 0
    BAD_PARAMETER = 1
    BAD_VALUE = 2
    NOT_SERIAL_MODE = 3


@unique
class ErrorCode(Enum):
    """Code of an error. The value is the message, with placeholders for the fields."""

    # Connecting
    NO_BOARD = tr_noop(
        "No TReX responds on {0}. Check that the board has power (an LED is lit), that the "
        "adapter's TX goes to SI and its RX to SO (an RS-232 adapter: to the RS-232 pins), "
        "that ground is connected, and that the serial settings match those of the board. If "
        "both LEDs blink together, the board is in learning mode: remove the SO–G jumper, "
        "then switch the board off and on."
    )
    ECHO_ONLY = tr_noop(
        "Everything sent on {0} comes back, and nothing else arrives. Either this is the "
        "RS-232 side of a board that is off or set to another baud rate, or the adapter's TX "
        "and RX are joined."
    )
    OTHER_DEVICE = tr_noop(
        "Something responds on {0}, but not like a TReX. {1} Usually the baud rate, parity or CRC "
        "differs from the board's setting, or another device is connected."
    )
    BOOT_LOADER = tr_noop(
        "The TReX on {0} is in its boot loader, waiting for new firmware. Check that the mix "
        "and SO–G jumpers are off, then switch the board off and on and connect again. Its "
        "serial settings may now be the factory defaults: 19200 baud, no parity, no CRC."
    )
    QIK = tr_noop(
        "The device on {0} responds like a Pololu qik, not like a TReX. This program does "
        "not support it: select the port of the TReX, or connect the adapter to the TReX."
    )
    SEVERAL_BOARDS = tr_noop(
        "Several boards reply at once on {0} at {1}. “Find” tries every device number. If "
        "two boards have the same number, switch one of them off and give the other board a "
        "different number."
    )
    OTHER_LINE = tr_noop(
        "A {1} responds on {0} at {2}, but this connection uses {3}. Connect with the settings "
        "of the board."
    )
    OTHER_POLYNOMIAL = tr_noop(
        "A {1} responds on {0} with CRC polynomial {2}, but this connection uses {3}. Connect "
        "with the settings of the board."
    )
    OTHER_NUMBER = tr_noop(
        "A {1} responds on {0}, but its device number is {2}, and this connection uses {3}. "
        "Connect with the settings of the board."
    )
    REPLIES_LOST = tr_noop(
        "A {1} responds on {0}, but not every time: the line loses or corrupts bytes. Check "
        "the cable and the ground connection, keep motor leads away from the cable, then "
        "connect again."
    )
    # Transactions
    NO_REPLY = tr_noop("No reply to {0}.")
    INCOMPLETE_REPLY = tr_noop("Incomplete reply to {0}: only {1} arrived.")
    CORRUPTED_REPLY = tr_noop("The reply {0} is corrupted: {1}.")
    LATE_REPLIES = tr_noop("Late replies arrived and cannot be matched to requests.")
    READINGS_DIFFER = tr_noop(
        "The board's replies to {0} differ each time: the line corrupts bytes, so the stored "
        "value is unknown. Check the cable and the ground connection, keep motor leads away "
        "from the cable, lower the baud rate, or use CRC."
    )
    # Motors
    STOP_UNCONFIRMED = tr_noop(
        "The stop was sent, but the board does not confirm it. If a motor is still turning, "
        "cut its power."
    )
    STOP_ON_NOISY_LINE = tr_noop(
        "The stop was sent and the board responds, but the line corrupts bytes. The stop is "
        "repeated until the line is quiet. If a motor is still turning, cut its power."
    )
    NO_HEARTBEAT = tr_noop("The program did not respond for more than half a second.")
    MAY_HAVE_RESTARTED = tr_noop(
        "The motors that were driven draw no current: the board may have restarted."
    )
    NO_GUARDIAN = tr_noop("The guardian process ended, and another one could not be started.")
    NOT_ARMED = tr_noop(
        "Nothing was sent, because these bytes may move a motor. Arm the motors first."
    )
    MOVES_ANOTHER_BOARD = tr_noop(
        "Nothing was sent, because these bytes may move a motor of another board, which a "
        "stop on this connection does not reach. Use device number {0} in the packet, or "
        "connect with the compact protocol."
    )
    OVERTAKEN_BY_STOP = tr_noop("Nothing was sent, because a stop was requested first.")
    # More than one board on a line
    OTHERS_WHILE_DRIVING = tr_noop(
        "The program does not scan for other boards while motors are armed or may be moving. Stop "
        "the motors first."
    )
    NOT_SELECTED_MOVING = tr_noop(
        "Board {0} was not selected, because the current board has not confirmed its stop. "
        "If a motor is still turning, cut its power."
    )
    NOT_SELECTED_SILENT = tr_noop(
        "Board {0} was not selected, because it does not respond. Check that it has power. The "
        "previous board is still selected."
    )
    NUMBER_TAKEN = tr_noop(
        "Another board on this line has the device number {0}. Select an unused number."
    )
    LEFT_GROUP = tr_noop(
        "Board {0} no longer follows the group: it stopped responding, was stopped, or restarted."
    )
    NO_SUCH_BOARD = tr_noop("Board {0} is not one of the boards that are driven together here.")
    OF_BOARD = tr_noop("Board {0}: {1}")
    IN_GROUP = tr_noop(
        "While boards are driven together, you cannot change a device number, select a "
        "board, or send a packet that stores a setting. Connect to this board alone."
    )
    # Boards that are served to clients
    OTHER_DRIVES = tr_noop("Another user drives this board. Ask that user to hand over control.")
    MAY_NOT_DRIVE = tr_noop("You may watch this board and stop it, but not drive or change it.")
    MAY_NOT_TAKE = tr_noop("Only an owner may take over from another user.")
    LEASE_LOST = tr_noop("Control was handed over, or the heartbeat did not reach the robot.")
    # Writes
    BAD_PARAMETER = tr_noop(
        "{0}: the board does not know this parameter (code 1); its firmware may be too old"
    )
    BAD_VALUE = tr_noop("{0}: the board rejects this value (code 2)")
    NOT_SERIAL_MODE = tr_noop(
        "{0}: the board is not in serial mode (code 3); switch it off, remove the mode "
        "jumper and switch it on again"
    )
    PARAMETER_MISMATCH = tr_noop("{0} could not be verified: wrote {1}, but read back {2}")
    CALIBRATION_MISMATCH = tr_noop("{0} could not be verified: read back {1}")
    OTHER_SOURCE = tr_noop("{0} is for {1} inputs, but the board now reads {2} inputs")
    OTHER_BOARD = tr_noop("Another board responds now: {0}. Nothing was written to it.")
    OTHER_BOARD_AFTER_WRITING = tr_noop(
        "Another board responds now: {0}. Settings may have been written to it. Compare it "
        "with its last snapshot."
    )
    OTHER_VALUES = tr_noop(
        "The board no longer stores the settings that were read from it: it is another "
        "board, or its settings were changed in the meantime. Nothing was written."
    )
    STRAY_WRITE = tr_noop(
        "The line corrupted bytes while {0} was being written, and another setting may have "
        "been changed instead. Read the board again and compare it with the last snapshot. "
        "{1}"
    )
    TOO_MANY_DIFFER = tr_noop(
        "{0} settings differ from the values that were read before, so none was restored: "
        "another board may be connected."
    )
    WRITE_CANCELLED = tr_noop("The write was cancelled before this setting was written.")
    LINE_SETTINGS_UNCERTAIN = tr_noop(
        "{0} {1} may have been reset to the factory default: after a power cycle, the board "
        "would run at {2}"
    )
    # The session
    SCANNING = tr_noop("The board is not responding; scanning for it.")
    CLOSED = tr_noop("The connection was closed before the request was complete.")
    INTERNAL = tr_noop("Internal error in the connection: {0}")


class TrexError(CodedError):
    """An error of a connection to a board."""


class TrexRequestError(TrexError, BadRequest):
    """The request was rejected in the current state. Nothing was sent."""


class TrexNoReplyError(TrexError, NoReply):
    """The board does not respond, or does not confirm a stop."""


class BoardElsewhere(TrexNoReplyError):  # noqa: N818 - nothing went wrong with the board
    """A board responds, but not with the settings of the connection."""

    @property
    def settings(self) -> PortSettings:
        """The `ConnectionSettings` that reach the board."""
        settings = self.fields[-1]
        assert isinstance(settings, PortSettings)  # noqa: S101 - by construction
        return settings


class TrexBadReplyError(TrexError, BadReply):
    """The reply is invalid, or the stored value differs from the written value."""


class TrexInternalError(TrexError, InternalError):
    """The session failed. `fields[0]` describes the error."""


class OtherBoard(TrexError):  # noqa: N818 - nothing went wrong with the line
    """Another board replies, or the stored values have changed."""


class Skipped(TrexError):  # noqa: N818 - nothing went wrong
    """The write was cancelled before this setting was written."""


class Rejected(TrexError):  # noqa: N818 - reads as a result, like `Outcome`
    """The board rejected a write of this setting."""

    def __init__(self, setting: str, result: ResultCode) -> None:
        super().__init__(ErrorCode[result.name], setting)
        self.result = result


def readings_differ(error: BaseException) -> bool:
    """True if repeated readings of a stored value differed."""
    return isinstance(error, TrexError) and error.code is ErrorCode.READINGS_DIFFER


def suggests_inspection(error: BaseException) -> bool:
    """True if the wires, jumpers or LEDs may show the cause."""
    return isinstance(error, TrexError) and error.code in {
        ErrorCode.NO_BOARD,
        ErrorCode.ECHO_ONLY,
        ErrorCode.OTHER_DEVICE,
    }


def suggests_scan(error: BaseException) -> bool:
    is_shared = isinstance(error, TrexError) and error.code is ErrorCode.SEVERAL_BOARDS
    return is_shared or suggests_inspection(error)
