"""What is said once a board that was lost while it was driven has confirmed a stop."""

from PySide6.QtCore import QObject, Slot

from trex_gui.core.translation import Number
from trex_gui.devices.trex.driving.timeout_stop import TimeoutStop, TimeoutTrial
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.board_records import utc_now
from trex_gui.ui.notifier import Answer
from trex_gui.ui.runtime import now

_MARGIN_S = 1.0  # between the timeout and the moment at which a user sees that a motor stands still


class LossWhileDriven(QObject):
    """Reports the confirmed stop, and asks whether the serial timeout had stopped the motor.

    The answer is saved for the board. Only the user can tell: the first thing that the program
    sends to a board that is back is a stop. A simulated board is not asked about.
    """

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._lost_at: float | None = None
        self._lost_with: ConnectionSettings | None = None

        device.connection.not_responding.connect(self._on_lost)
        device.connection.line_closed.connect(self._on_lost)
        device.driving.confirmed.connect(self._on_confirmed)
        device.connection.ready.connect(self._on_confirmed)  # it may be confirmed before

    @Slot()
    def _on_lost(self) -> None:
        if self._device.driving.driven and self._lost_at is None:
            self._lost_at, self._lost_with = now(), self._device.settings

    @Slot()
    def _on_confirmed(self) -> None:
        device, lost_at = self._device, self._lost_at
        if lost_at is None or device.may_stop_matter or not device.is_connected:
            return
        self._lost_at, lost, here = None, self._lost_with, device.settings
        if lost is None or here is None or lost.url != here.url:
            return  # perhaps another board, of which `driving` warns
        seconds = now() - lost_at
        is_open = device.timeout_stop in {TimeoutStop.DOUBTFUL, TimeoutStop.EXPECTED}
        waited = seconds > (device.serial_timeout_s or 0) + _MARGIN_S
        if here.name or not is_open or not waited:
            device.notifier.info.emit(self.tr("The board is back. It has confirmed the stop."))
            return
        text = self.tr(
            "The board is back. It has confirmed the stop. For {0:.0f} s it received nothing: did "
            "its Serial Timeout stop the motor meanwhile?"
        )
        device.notifier.ask(
            text.format(Number(seconds)),
            Answer("timeoutWorked", self.tr("It stopped"), lambda: self._save(stopped=True)),
            Answer("timeoutFailed", self.tr("It kept turning"), lambda: self._save(stopped=False)),
        )

    def _save(self, *, stopped: bool) -> None:
        shutdown = self._device.parameters.stored_of(ParameterKey.UART_ERROR_SHUTDOWN) == 1
        self._device.memory.record_trial(TimeoutTrial(stopped, shutdown, utc_now()))
