"""Whether the motors follow the setpoints, why not, and what to do about it."""

from collections.abc import Iterator
from dataclasses import dataclass
from functools import reduce
from math import ceil
from operator import or_

from PySide6.QtCore import QObject, Slot

from trex_gui.core.translation import tr, tr_noop
from trex_gui.devices.trex.driving.blockers import DriveBlocker, Reason, worst_first
from trex_gui.devices.trex.driving.board_reasons import (
    NOISE_COUNTS,
    BoardInputs,
    board_inputs,
    board_reasons,
)
from trex_gui.devices.trex.driving.timeout_stop import turning_text
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import NEARLY_NEUTRAL
from trex_gui.devices.trex.protocol.flags import MOTOR_FAULTS, Status, UartError
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now

_CLOSED = ConnectionState.DISCONNECTED


@dataclass(frozen=True, slots=True, kw_only=True)
class DriveInputs:
    board: BoardInputs | None = None  # what the board reports; `None` while that is unknown
    link: ConnectionState = ConnectionState.CONNECTED
    may_move: bool = False  # whether motors were driven and no stop was confirmed since
    driven: frozenset[int] = frozenset()  # those motors, as far as they are known
    # A warning about a board that may still be driven, with another one at the line
    lost_board: str = ""
    silence_remedy: str = ""  # what to do if the board is lost while it is driven
    reaches_several: bool = False  # whether a command would reach several boards
    locked_for: float = 0.0  # seconds
    is_available: bool = True
    armed: bool = False
    stop_reason: str = ""


@dataclass(frozen=True, slots=True)
class DriveStatus:
    """Why the motors do what they do, and what the user can do about it, in sentences."""

    blocker: DriveBlocker
    text: str
    remedy: str = ""


_SILENT_WHILE_DRIVEN = tr_noop("The board does not respond; the stop is being repeated.")
_DOUBTFUL = tr_noop("{0} Doubtful: the line is noisy and has no CRC.")

_LINK_BLOCKERS = {
    ConnectionState.DISCONNECTED: DriveBlocker.NO_BOARD,
    ConnectionState.CONNECTING: DriveBlocker.OPENING,
    ConnectionState.DISCONNECTING: DriveBlocker.CLOSING,
}


def drive_statuses(now: DriveInputs) -> tuple[DriveStatus, ...]:
    """Return every reason why the motors do what they do, those that stop them first."""
    if now.link is _CLOSED and (now.may_move or now.lost_board):
        return (_lost(now),)
    if now.link is ConnectionState.NOT_RESPONDING:
        return (_silent(now),)
    if now.link is not ConnectionState.CONNECTED:
        return (_status(Reason(_LINK_BLOCKERS[now.link])),)
    if now.board is None:
        return (_status(Reason(DriveBlocker.UNKNOWN)),)
    reasons = [*board_reasons(now.board), *_own_reasons(now, by_serial=now.board.by_serial)]
    return tuple(map(_status, worst_first(reasons)))


def _own_reasons(now: DriveInputs, *, by_serial: bool) -> Iterator[Reason]:
    """Yield why this program sends nothing, or that it does; nothing where channels drive."""
    if now.armed:
        yield Reason(DriveBlocker.RUNNING)
    elif now.may_move:
        yield Reason(DriveBlocker.STOPPING)
    elif not by_serial:
        return
    elif now.locked_for:
        yield Reason(DriveBlocker.LOCKED, (ceil(now.locked_for),))
    elif now.reaches_several:
        yield Reason(DriveBlocker.SEVERAL_BOARDS)
    elif not now.is_available:
        yield Reason(DriveBlocker.NOT_ALLOWED)
    elif now.stop_reason:
        yield Reason(DriveBlocker.STOPPED, (now.stop_reason,))
    else:
        yield Reason(DriveBlocker.NOT_ARMED)


def _status(reason: Reason) -> DriveStatus:
    return DriveStatus(reason.blocker, reason.text(tr), reason.remedy(tr))


def _lost(now: DriveInputs) -> DriveStatus:
    if not now.may_move:
        return DriveStatus(DriveBlocker.LOST, now.lost_board)
    return DriveStatus(DriveBlocker.LOST, turning_text(now.driven), now.silence_remedy)


def _silent(now: DriveInputs) -> DriveStatus:
    if not now.may_move:
        return _status(Reason(DriveBlocker.SILENT))
    remedy = f"{now.silence_remedy} {tr(_SILENT_WHILE_DRIVEN)}"
    return DriveStatus(DriveBlocker.SILENT, turning_text(now.driven), remedy)


def drive_inputs(device: Device, *, is_held: bool = False) -> DriveInputs:
    """Return what decides now; `is_held`: whether safe-start may hold the motors."""
    motors = device.motors
    return DriveInputs(
        board=_board_inputs(device, is_held=is_held),
        link=device.link,
        may_move=device.may_move,
        driven=frozenset(device.driving.driven),
        lost_board=device.driving.lost_board,
        silence_remedy=device.silence_remedy,
        reaches_several=device.driving.reaches_several,
        locked_for=motors.locked_for,
        is_available=motors.is_available,
        armed=motors.armed,
        stop_reason=motors.stop_reason,
    )


def _board_inputs(device: Device, *, is_held: bool) -> BoardInputs | None:
    state, by_serial = device.state, device.telemetry.serial_controls
    if state is None or by_serial is None:
        return None
    recent = [entry.bit for motor in (1, 2) for entry in device.errors.recent(motor, now())]
    return board_inputs(
        state,
        device.telemetry.raw,
        reduce(or_, (bit for bit in recent if isinstance(bit, Status)), Status(0)),
        reduce(or_, (bit for bit in recent if isinstance(bit, UartError)), UartError(0)),
        by_serial=by_serial,
        joint=device.is_joint,
        is_held=is_held,
    )


def recent_fault_text(device: Device) -> str:
    """Return which motor drivers have shut down recently, as sentences; empty if none has."""
    recent = {
        motor: entry
        for motor, bit in MOTOR_FAULTS.items()
        for entry in device.errors.recent(motor, now())
        if entry.bit is bit
    }
    if not recent or not device.is_connected:
        return ""
    text = " ".join(Reason(DriveBlocker.FAULT, (motor,)).text(tr) for motor in recent)
    if all(entry.is_doubtful for entry in recent.values()):
        text = tr(_DOUBTFUL).format(text)
    return text


class SafeStartWatch(QObject):
    """Remembers whether sticks were at rest, or motors drew current, since the board came.

    Inferred: the board has no flag for safe-start. It begins at power-up and when a required
    channel falls silent, and ends when the channels that drive are near neutral, all at once;
    how near is inferred, too. Ref: TReX Jr User's Guide 4.e.
    """

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._is_over = False

        device.telemetry.updated.connect(self._on_telemetry_updated)

    @property
    def may_hold(self) -> bool:
        """Whether a channel commands a speed, no current flows and nothing shows why."""
        values, currents = self._values(), self._device.telemetry.motor_currents
        return (
            bool(values)
            and currents is not None
            and not self._is_over
            and not self._device.is_joint
        )

    @Slot()
    def _on_telemetry_updated(self) -> None:
        values = self._values()
        if not values or _is_silent(self._device):
            self._is_over = False
        elif all(abs(value) <= NEARLY_NEUTRAL for value in values) or self._flows():
            self._is_over = True

    def _values(self) -> tuple[int, ...]:
        """Return the commands of the channels that drive; empty if none does, or unknown."""
        device = self._device
        state, remapped = device.state, device.telemetry.remapped
        if state is None or state.mode.is_serial or remapped is None:
            return ()
        first, second, third, *_ = remapped
        return (first, third) if device.is_joint else (first, second, third)

    def _flows(self) -> bool:
        state, currents = self._device.state, self._device.telemetry.motor_currents
        if state is None or currents is None:
            return False
        return max(currents) > (NOISE_COUNTS + 0.5) * state.signature.model.current_unit


def _is_silent(device: Device) -> bool:
    """Whether a required channel has no signal, which begins safe-start."""
    board = _board_inputs(device, is_held=False)
    return board is not None and board.lacks_signal
