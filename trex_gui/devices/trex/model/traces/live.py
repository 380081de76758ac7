"""The board that is connected as curves: currents with their limits, speeds, channels."""

from PySide6.QtCore import QObject, Slot

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.traces.curves import board_traces
from trex_gui.ui.plotting.data.traces import Traces


class LiveTraces(QObject):
    """Keeps `traces` fed from a device; the history itself is the telemetry's."""

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._limits: dict[str, float] = {}
        self.traces = Traces(
            board_traces(), device.telemetry.currents, device.events.all, self._limits
        )
        device.state_changed.connect(self._on_state_changed)
        self._on_state_changed()

    @Slot()
    def _on_state_changed(self) -> None:
        self._limits.clear()
        for motor in (1, 2):
            limit = self._limit_of(motor)
            if limit is not None:
                self._limits[f"motor{motor}_current"] = limit

    def _limit_of(self, motor: int) -> float | None:
        """Current limit of a motor in ampere; `None` when it is off or not known."""
        state = self._device.state
        wire = self._device.parameters.stored_of(f"motor{motor}_current_limit")
        if state is None or not wire:
            return None
        return wire * state.specs[f"motor{motor}_current_limit"].scale
