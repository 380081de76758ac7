"""Messages about a board that was lost while it was driven."""

from functools import partial

from PySide6.QtCore import QObject, Slot

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.timeout_stop import TimeoutTrial
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.session.messages import Batch
from trex_gui.ui.notifier import Answer
from trex_gui.ui.runtime import now

_MARGIN_S = 1.0  # time for the motor to come to rest


class LossWhileDriven(QObject):
    """Reports the confirmed stop of a board that was lost while it was driven.

    If that board has latched a serial timeout, asks the user whether the timeout stopped the motor.
    The program cannot know, because it sends its own stop first. The user is not asked about
    simulated boards.
    """

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._lost_at: float | None = None
        self._lost_place = ""
        self._has_shutdown = False  # UART-Error Shutdown was on when the board was lost
        self._silent_for: float | None = None  # seconds of silence before the user is asked
        self._has_timed_out = False

        device.connection.not_responding.connect(self._on_lost)
        device.connection.line_closed.connect(self._on_lost)
        device.driving.changed.connect(self._on_confirmed)
        device.connection.ready.connect(self._on_confirmed)  # the stop may already be confirmed
        device.sampled.connect(self._on_sampled)

    @Slot()
    def _on_lost(self) -> None:
        device = self._device
        if device.driving.driven and self._lost_at is None:
            self._lost_at = now()
            self._lost_place = device.driving.place
            shutdown = device.parameters.values.stored.get(ParameterKey.UART_ERROR_SHUTDOWN) or 0
            self._has_shutdown, self._silent_for = bool(shutdown & 1), None  # as in `timeout_stop`
            self._has_timed_out = False

    @Slot()
    def _on_confirmed(self) -> None:
        device, lost_at = self._device, self._lost_at
        if lost_at is None or device.stop_may_matter or not device.is_connected:
            return
        self._lost_at, settings = None, device.settings
        if settings is None or device.driving.place != self._lost_place:
            return  # this may be another board; `driving` warns about it
        device.notifier.info.emit(tr("The board is back. It has confirmed the stop."))
        seconds = now() - lost_at
        if not settings.name and seconds > (device.serial_timeout_s or 0) + _MARGIN_S:
            self._silent_for = seconds
            self._prompt()

    @Slot(object)
    def _on_sampled(self, batch: Batch) -> None:
        statuses = (sample for sample in batch.samples if isinstance(sample, LatchedStatus))
        if any(status.uart & UartError.TIMEOUT for status in statuses):
            self._has_timed_out = True
            self._prompt()

    def _prompt(self) -> None:
        if self._silent_for is None or not self._has_timed_out:
            return
        text = tr(
            "The board is back. It has confirmed the stop. It received nothing for {0:.0f} "
            "s: did its Serial Timeout stop the motor during that time?"
        ).format(Number(self._silent_for))
        self._silent_for = None
        record_trial, shutdown = self._device.board.memory.record_trial, self._has_shutdown
        worked, failed = TimeoutTrial(True, shutdown), TimeoutTrial(False, shutdown)
        self._device.notifier.prompt(
            text,
            Answer("timeoutWorked", tr("It stopped"), partial(record_trial, worked)),
            Answer("timeoutFailed", tr("It kept turning"), partial(record_trial, failed)),
        )
