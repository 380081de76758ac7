"""Preconditions for learning channels, during which no motor may move."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.translations import error_text


def mode_blocker(device: Device) -> str:
    """Return the reason why the mode prevents learning, or an empty string."""
    state = device.state
    if state is None or state.mode.is_serial:
        return ""
    text = tr(
        "The board is in {0} mode: the sticks drive the motors, and the board rejects "
        "settings. Switch the board off, remove the mode jumper and switch the board on."
    )
    if device.board.serial_controls:
        text = tr(
            "The board is in {0} mode. Channel 5 has switched the motors to serial control; "
            "when its switch moves again, the sticks drive the motors. In this mode the "
            "board rejects settings. Switch the board off, remove the mode jumper and switch "
            "the board on."
        )
    return text.format(state.mode.source.word)


class CalibrationPreconditions(QObject):
    """Watches a board while its channels are learned or tested.

    In RC and analog mode, the sticks drive the motors, and the board rejects settings. Serial
    override (channel 5) ends with the next move of its switch. Armed motors are a violation only
    in steps that use the sticks.
    Ref: Pololu TReX User's Guide 4.a; command documentation 0x82, 0xA0-0xA4, 0xAF.
    """

    violated = Signal(str)  # reason for the user; at most once between `start` and `end`

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._watching = False
        self._watches_motors = False
        self._source: InputSource | None = None

        for changed in (
            device.link_changed,
            device.state_changed,
            device.motors.arming_changed,
            device.telemetry.updated,
        ):
            changed.connect(self._check)

    @property
    def source(self) -> InputSource:
        return self._source or self._device.calibrations.source

    def start(self) -> None:
        self._watching = True
        self._source = self._device.calibrations.source

    def end(self) -> None:
        self._watching = False

    def watch_motors(self, watch: bool) -> None:
        self._watches_motors = watch
        self._check()

    @property
    def blocker(self) -> str:
        """Reason why the sticks must not be moved, or an empty string."""
        state = self._device.state
        if not self._device.is_connected or state is None:
            return tr("Connect to a board first.")
        if not state.mode.is_serial:
            return mode_blocker(self._device)
        return tr("Settings are being written.") if self._device.writer.running else ""

    @Slot()
    def _check(self) -> None:
        if self._watching and (reason := self._violation()):
            self.end()
            self.violated.emit(reason)

    def _violation(self) -> str:
        device, state = self._device, self._device.state
        if device.link is ConnectionState.NOT_RESPONDING:
            return tr("The board does not respond.")
        if device.link is ConnectionState.CONNECTING:
            return tr("Another board was selected.")
        if not device.is_connected or state is None:
            return tr("The connection was closed.")
        if not state.mode.is_serial or state.source is not self._source:
            text = tr("The board was started in another mode.")
            return f"{text} {self.blocker}".rstrip()
        if self._watches_motors and device.motors.armed:
            return tr("The motors were armed, so this has ended.")
        if device.board.serial_controls is False:
            return tr("The sticks drive the motors now: the channels are in control.")
        return ""


_QUIET_READINGS = 3  # consecutive readings without current that confirm standstill

_MAX_COUNTS = 2.5
"""Highest current at standstill, in counts: 0.38 A on a TReX, 0.1 A on a Jr.

A reading is an average of 64 samples (command documentation 0x8D). Inferred: it varies by one
count.
"""


class StandstillCheck(QObject):
    """Stops the motors, then watches the currents.

    After a confirmed stop, another controller on the same line may drive the motors again, because
    both connectors share one UART (forum thread 503). In joint mode the board measures no current,
    so the confirmation suffices.
    """

    confirmed = Signal()  # the stop is confirmed, and no current flows
    doubted = Signal(str)  # motors and their currents, as text
    failed = Signal(str)  # reason for the user

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._run = 0
        self._since: float | None = None
        self._timer = new_timer(self, 0, self._on_timeout, single_shot=True)
        device.telemetry.updated.connect(self._on_updated)

    def start(self) -> None:
        """Stop the motors, and start a new check."""
        self.cancel()
        run = self._run
        self._device.driving.stop(lambda error: self._on_stopped(run, error))

    def cancel(self) -> None:
        self._run += 1
        self._since = None
        self._timer.stop()

    def _on_stopped(self, run: int, error: StudioError | None) -> None:
        if run != self._run:
            return
        if error is not None:
            self.cancel()
            self.failed.emit(error_text(error))
            return
        # Readings taken before the stop may still arrive, but only for a short time.
        self._since = self._device.telemetry.latest
        self._timer.start(round(self._device.timeouts.standstill * 1000))

    @Slot()
    def _on_updated(self) -> None:
        if self._since is not None and all(
            len(readings) == _QUIET_READINGS and max(readings) <= self._limit
            for readings in self._last_currents()
        ):
            self.cancel()
            self.confirmed.emit()

    @Slot()
    def _on_timeout(self) -> None:
        drawing = [
            tr("motor {0} draws {1:.1f} A").format(motor, Number(readings[-1]))
            for motor, readings in enumerate(self._last_currents(), 1)
            if readings and max(readings) > self._limit
        ]
        self.cancel()
        if drawing:
            self.doubted.emit(tr(" and ").join(drawing))
        else:
            self.confirmed.emit()

    @property
    def _limit(self) -> float:
        return _MAX_COUNTS * self._device.telemetry.ampere

    def _last_currents(self) -> tuple[list[float], list[float]]:
        """Return the last currents of both motors since the stop."""
        currents, since = self._device.telemetry.currents, self._since
        first = int(currents.times.searchsorted(since, side="right")) if since is not None else 0
        first = max(first, len(currents.times) - _QUIET_READINGS)
        return currents.values(0)[first:].tolist(), currents.values(1)[first:].tolist()
