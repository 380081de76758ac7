"""Whether the motors stand: a stop that is proved, and then no current that says otherwise."""

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.core.errors import StudioError
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.runtime import runtime

_QUIET = 3
"""Readings in a row without a current that make a motor stand."""

_COUNTS = 2.5
"""Counts of the current sensor that a standing motor stays below. Inferred: a reading is an
average of 64 samples and wavers by one; that is 0.38 A of a TReX, 0.1 A of a TReX Jr."""


class StandstillCheck(QObject):
    """Stops the motors, waits for the proof, then watches the currents.

    The proof says that the board took the stop, not that nobody drives the motors again:
    another controller may hang on the same line (User's Guide 5: one UART for both
    connectors). In joint mode the board measures no current; then the proof has to do.

    Signals:
        stood: the stop is proved, and no current flows.
        doubted: the stop is proved, and yet a motor draws a current; a sentence.
        failed: the stop is not proved; why.
    """

    stood = Signal()
    doubted = Signal(str)
    failed = Signal(str)

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._run = 0
        self._since: float | None = None
        self._timer = runtime().timer(self)
        self._timer.setSingleShot(True)
        self._timer.timeout.connect(self._on_patience_over)
        device.telemetry.updated.connect(self._on_updated)

    def stop(self) -> None:
        """Stop the motors and look; what was looked for before is given up."""
        self.give_up()
        run = self._run
        self._device.stop_motors(lambda error: self._on_stopped(run, error))

    def give_up(self) -> None:
        """Tell nothing more."""
        self._run += 1
        self._since = None
        self._timer.stop()

    def _on_stopped(self, run: int, error: StudioError | None) -> None:
        if run != self._run:
            return
        if error is not None:
            self.give_up()
            self.failed.emit(str(error))
            return
        # Readings from before the stop may still be on their way to us; they are quickly past.
        self._since = self._device.telemetry.latest
        self._timer.start(round(self._device.timeouts.standstill * 1000))

    @Slot()
    def _on_updated(self) -> None:
        if self._since is not None and all(
            len(readings) == _QUIET and max(readings) <= self._limit for readings in self._last()
        ):
            self.give_up()
            self.stood.emit()

    @Slot()
    def _on_patience_over(self) -> None:
        drawing = [
            self.tr("motor {0} draws {1:.1f} A").format(motor, readings[-1])
            for motor, readings in enumerate(self._last(), 1)
            if readings and max(readings) > self._limit
        ]
        self.give_up()
        if drawing:
            self.doubted.emit(self.tr(" and ").join(drawing))
        else:
            self.stood.emit()

    @property
    def _limit(self) -> float:
        """Ampere that a standing motor stays below."""
        state = self._device.state
        return 0.0 if state is None else _COUNTS * state.signature.model.current_unit

    def _last(self) -> tuple[list[float], list[float]]:
        """Return the last readings of both motors since the stop, in ampere."""
        currents, since = self._device.telemetry.currents, self._since
        first = int(currents.times.searchsorted(since, side="right")) if since is not None else 0
        first = max(first, len(currents.times) - _QUIET)
        return currents.values(0)[first:].tolist(), currents.values(1)[first:].tolist()
