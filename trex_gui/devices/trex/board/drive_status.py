"""Reasons why motors do not follow their setpoints, with remedies."""

from collections.abc import Iterator
from dataclasses import dataclass
from enum import Enum, auto
from math import ceil

from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.client.telemetry import Newest, Remapped
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Reason, worst_first
from trex_gui.devices.trex.driving.board_reasons import (
    BoardInputs,
    board_reasons,
    held_by_safe_start,
)
from trex_gui.devices.trex.driving.timeout_stop import turning_text


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveInputs:
    board: BoardInputs | None = None  # reports of the board; `None` if unknown
    link: DriveBlocker | None = None  # state of the connection; `None` while the board responds
    may_move: bool = False  # True if motors were driven and no stop was confirmed since
    driven: frozenset[int] = frozenset()  # numbers of the driven motors; empty if unknown
    lost_board: str = ""  # warning that the previous board may still be driven
    silence_remedy: str = ""  # remedy if the board is lost while motors are driven
    other_driver: str = ""  # another user who drives this served board
    other_speeds: tuple[int, int, int] = (0, 0, 0)  # setpoints of the other user
    undrivable: int | None = None  # number of a board in the group that cannot be driven
    reaches_several: bool = False  # True if a command would reach several boards
    locked_for: float = 0.0  # remaining lock-out time in seconds
    is_available: bool = True  # False if the motors cannot be armed now
    armed: bool = False
    stop_reason: str = ""  # reason for the last stop; empty if the user pressed stop


@dataclass(frozen=True, slots=True)
class DriveStatus:
    """State of the motors and a remedy, in sentences."""

    blocker: DriveBlocker
    text: str
    remedy: str = ""


class SetpointSource(Enum):
    UNKNOWN = auto()
    JOINT = auto()  # joint mode: both motor drivers power motor 1
    SAFE_START = auto()  # safe-start holds the motor
    CHANNEL = auto()
    NOT_ARMED = auto()  # serial commands control the motor, but are not sent
    SERIAL = auto()
    OTHER_DRIVER = auto()  # serial commands of another user


@dataclass(frozen=True, slots=True)
class MotorSetpoint:
    source: SetpointSource
    speed: int = 0  # -127 to 127
    may_turn: bool = False  # True if a disarmed motor may still turn, because no stop was confirmed


AUXILIARY = 3  # motor of channel 3


def motor_setpoint(motor: int, inputs: DriveInputs, newest: Newest, sent: int) -> MotorSetpoint:
    """Return the setpoint of a motor: 1, 2 or `AUXILIARY`.

    `sent` is the speed in serial commands, -127 to 127.
    """
    source, speed, board = SetpointSource.UNKNOWN, 0, inputs.board
    remapped = newest.get(Remapped)
    if inputs.link is not None or board is None:
        pass
    elif board.joint and motor == 2:
        source = SetpointSource.JOINT
    elif board.by_serial and inputs.other_driver:
        source, speed = SetpointSource.OTHER_DRIVER, inputs.other_speeds[motor - 1]
    elif board.by_serial:
        source = SetpointSource.SERIAL if inputs.armed else SetpointSource.NOT_ARMED
        speed = sent if inputs.armed else 0
    elif remapped is not None and held_by_safe_start(board):
        source = SetpointSource.SAFE_START
    elif remapped is not None:
        source, speed = SetpointSource.CHANNEL, remapped.values[motor - 1]
    return MotorSetpoint(
        source, abs(speed) if motor == AUXILIARY else speed, inputs.may_move and not inputs.armed
    )


_DOUBTFUL = tr_noop("{0} Doubtful: the line is noisy and has no CRC.")
_SILENT_WHILE_DRIVEN = tr_noop("The board does not respond; the stop is being repeated.")


def drive_statuses(inputs: DriveInputs) -> tuple[DriveStatus, ...]:
    """Return the reasons for the state of the motors, most severe first."""
    if inputs.link is DriveBlocker.NO_BOARD and (inputs.may_move or inputs.lost_board):
        return (_lost(inputs),)
    if inputs.link is DriveBlocker.SILENT:
        return (_silent(inputs),)
    board = inputs.board
    if inputs.link is not None or board is None:
        return (_status(Reason(inputs.link or DriveBlocker.UNKNOWN)),)
    reasons = [*board_reasons(board), *_program_reasons(inputs, by_serial=board.by_serial)]
    return tuple(_status(reason, board) for reason in worst_first(reasons))


def _program_reasons(inputs: DriveInputs, *, by_serial: bool) -> Iterator[Reason]:
    if inputs.armed:
        yield Reason(DriveBlocker.RUNNING)
    elif inputs.may_move:
        yield Reason(DriveBlocker.STOPPING)
    elif not by_serial:
        return
    elif inputs.locked_for:
        yield Reason(DriveBlocker.LOCKED, (ceil(inputs.locked_for),))
    elif inputs.other_driver:
        yield Reason(DriveBlocker.OTHER_DRIVES, (inputs.other_driver,))
    elif inputs.reaches_several:
        yield Reason(DriveBlocker.SEVERAL_BOARDS)
    elif inputs.undrivable is not None:
        yield Reason(DriveBlocker.GROUP, (inputs.undrivable,))
    elif not inputs.is_available:
        yield Reason(DriveBlocker.NOT_ALLOWED)
    elif inputs.stop_reason:
        yield Reason(DriveBlocker.STOPPED, (inputs.stop_reason,))
    else:
        yield Reason(DriveBlocker.NOT_ARMED)


def _status(reason: Reason, board: BoardInputs | None = None) -> DriveStatus:
    text, is_fault = reason.text(), reason.blocker is DriveBlocker.FAULT
    if board is not None and is_fault and reason.fields[0] in board.doubtful:
        text = tr(_DOUBTFUL).format(text)
    return DriveStatus(reason.blocker, text, reason.remedy())


def _lost(inputs: DriveInputs) -> DriveStatus:
    if not inputs.may_move:
        return DriveStatus(DriveBlocker.LOST, inputs.lost_board)
    return DriveStatus(DriveBlocker.LOST, turning_text(inputs.driven), inputs.silence_remedy)


def _silent(inputs: DriveInputs) -> DriveStatus:
    if not inputs.may_move:
        return _status(Reason(DriveBlocker.SILENT))
    remedy = f"{inputs.silence_remedy} {tr(_SILENT_WHILE_DRIVEN)}"
    return DriveStatus(DriveBlocker.SILENT, turning_text(inputs.driven), remedy)
