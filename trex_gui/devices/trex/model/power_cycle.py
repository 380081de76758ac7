"""Power cycle of a board, which makes stored settings active."""

from collections.abc import Collection
from enum import Enum, auto

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.session.reconnecting import LINK_KEYS, after_power_cycle
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import new_timer

_TIMEOUT_MS = 10_000


class PowerCycleStage(Enum):
    """Stage of a power cycle. A silent board counts as switched off."""

    NONE = auto()
    AWAITING_OFF = auto()
    AWAITING_ON = auto()
    BACK = auto()  # the board responds again
    LOST = auto()  # the line was closed
    UNSURE = auto()  # the line was reopened, but stored settings may not be active yet


_STILL_ON = {PowerCycleStage.AWAITING_OFF, PowerCycleStage.UNSURE}  # the board still responds
_WAITING = _STILL_ON | {PowerCycleStage.AWAITING_ON}


class PowerCycle(QObject):
    changed = Signal()  # `stage`, `takes_long` or `expected`

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self.stage = PowerCycleStage.NONE
        self.takes_long = False  # nothing has happened for 10 s
        self.expected: ConnectionSettings | None = None  # new line settings; `None` if unchanged
        self._timeout = new_timer(self, _TIMEOUT_MS, self._on_timeout, single_shot=True)

        device.link_changed.connect(self._on_link_changed)

    @property
    def still_waiting(self) -> tuple[str, ...]:
        """Names of parameters whose stored values are not active yet."""
        return self._device.parameters.values.waiting_for_power

    def start(self, failed: Collection[str] = ()) -> None:
        """Wait until the board is switched off and on.

        `failed` contains keys that were not written. If any of these keys affects the line, the
        search includes all line settings that Apply expected.
        """
        state, settings = self._device.state, self._device.settings
        if state is None or settings is None or not self._device.is_connected:
            return
        signature, stored = state.signature, state.parameters
        if self._device.draft.reset_pending:
            stored = factory_settings(signature.model, signature.firmware).parameters
        expected = after_power_cycle(settings, stored, signature.firmware)
        self.expected = None if expected == settings else expected
        if not any(key in LINK_KEYS for key in failed):
            self._device.connection.expect(() if self.expected is None else (self.expected,))
        self._set_stage(PowerCycleStage.AWAITING_OFF)

    def confirm(self) -> None:
        if self._device.is_connected:
            self._device.record_power_cycled()
            self._set_stage(PowerCycleStage.BACK)

    def end(self) -> None:
        self.expected = None
        self._set_stage(PowerCycleStage.NONE)

    @Slot()
    def _on_link_changed(self) -> None:
        stage, link = self.stage, self._device.link
        is_closed = link in {ConnectionState.DISCONNECTED, ConnectionState.DISCONNECTING}
        if stage in _WAITING and is_closed:
            self._set_stage(PowerCycleStage.LOST)
        elif stage is PowerCycleStage.AWAITING_ON and link is ConnectionState.CONNECTED:
            self._set_stage(PowerCycleStage.BACK)
        elif stage in _STILL_ON and link is ConnectionState.NOT_RESPONDING:
            self._set_stage(PowerCycleStage.AWAITING_ON)
        elif stage is PowerCycleStage.LOST and link is ConnectionState.CONNECTED:
            self._set_stage(PowerCycleStage.UNSURE if self.still_waiting else PowerCycleStage.BACK)

    @Slot()
    def _on_timeout(self) -> None:
        self.takes_long = True
        self.changed.emit()

    def _set_stage(self, stage: PowerCycleStage) -> None:
        self.stage = stage
        self.takes_long = False
        if stage in {PowerCycleStage.AWAITING_OFF, PowerCycleStage.AWAITING_ON}:
            self._timeout.start()
        else:
            self._timeout.stop()
        self.changed.emit()
