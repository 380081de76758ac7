"""Switching a board off and on so that what it stores becomes active, step by step."""

from enum import Enum, auto

from PySide6.QtCore import QObject, Signal, Slot

from trex_gui.devices.trex.discovery.reconnect_candidates import after_power_cycle
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.settings.document import factory_settings
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.runtime import runtime

_LONG = 10_000
"""Milliseconds without news after which there is something to say about it."""


class PowerCycleStage(Enum):
    """How far a power cycle is.

    A silence is taken for a power cut: nothing that the board says tells them apart.
    """

    NONE = auto()
    OFF_WANTED = auto()
    ON_WANTED = auto()
    BACK = auto()
    LOST = auto()
    UNSURE = auto()


class PowerCycle(QObject):
    """Watches the link while a person switches the power; the switch itself is theirs.

    Signals:
        changed: `stage`, `takes_long`, `expected` or `still_waiting`.
    """

    changed = Signal()

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._stage = PowerCycleStage.NONE
        self._takes_long = False
        self._expected: ConnectionSettings | None = None
        self._timeout = runtime().timer(self)
        self._timeout.setSingleShot(True)
        self._timeout.setInterval(_LONG)

        self._timeout.timeout.connect(self._on_timeout)
        device.link_changed.connect(self._on_link_changed)

    @property
    def stage(self) -> PowerCycleStage:
        """How far it is."""
        return self._stage

    @property
    def takes_long(self) -> bool:
        """Whether nothing has happened for so long that a word of help is due."""
        return self._takes_long

    @property
    def expected(self) -> ConnectionSettings | None:
        """How the board will be reached when it is back, where that is another way than now."""
        return self._expected

    @property
    def still_waiting(self) -> tuple[str, ...]:
        """Names of what is stored and not active."""
        return self._device.parameters.waiting_for_power

    def begin(self) -> None:
        """Wait for the power to go off, and on again."""
        state, settings = self._device.state, self._device.settings
        if state is None or settings is None or self._device.link is not ConnectionState.CONNECTED:
            return
        signature = state.signature
        values = state.parameters
        if self._device.reset_ordered:
            values = factory_settings(signature.model, signature.firmware).parameters
        coming = after_power_cycle(settings, values, signature.firmware)
        self._expected = None if coming == settings else coming
        self._device.expect(() if self._expected is None else (self._expected,))
        self._go(PowerCycleStage.OFF_WANTED)

    def confirm(self) -> None:
        """Take a person's word that the power was off and is on again."""
        if self._device.link is ConnectionState.CONNECTED:
            self._device.note_power_cycled()
            self._go(PowerCycleStage.BACK)

    def end(self) -> None:
        """Wait for nothing any more."""
        self._expected = None
        self._go(PowerCycleStage.NONE)

    @Slot()
    def _on_link_changed(self) -> None:
        match self._stage, self._device.link:
            case (
                PowerCycleStage.OFF_WANTED | PowerCycleStage.UNSURE,
                ConnectionState.NOT_RESPONDING,
            ):
                self._go(PowerCycleStage.ON_WANTED)
            case PowerCycleStage.ON_WANTED, ConnectionState.CONNECTED:
                self._go(PowerCycleStage.BACK)
            case (
                PowerCycleStage.OFF_WANTED | PowerCycleStage.ON_WANTED | PowerCycleStage.UNSURE,
                ConnectionState.DISCONNECTED | ConnectionState.DISCONNECTING,
            ):
                self._go(PowerCycleStage.LOST)
            case PowerCycleStage.LOST, ConnectionState.CONNECTED:
                self._go(PowerCycleStage.UNSURE if self.still_waiting else PowerCycleStage.BACK)

    @Slot()
    def _on_timeout(self) -> None:
        self._takes_long = True
        self.changed.emit()

    def _go(self, stage: PowerCycleStage) -> None:
        self._stage = stage
        self._takes_long = False
        if stage in {PowerCycleStage.OFF_WANTED, PowerCycleStage.ON_WANTED}:
            self._timeout.start()
        else:
            self._timeout.stop()
        self.changed.emit()
