"""The board that is connected as curves: currents with their limits, speeds, channels."""

from PySide6.QtCore import QObject, Slot

from trex_gui.model.device import Device
from trex_gui.model.trace.source import TraceInfo
from trex_gui.model.trace.traces import Traces
from trex_gui.protocol.flags import CHANNELS


class LiveTraces(QObject):
    """Keeps `traces` fed from a device; the history itself is the telemetry's."""

    def __init__(self, device: Device, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._device = device
        self._limits: dict[str, float] = {}
        self.traces = Traces(
            self._infos(), device.telemetry.currents, device.events.all, self._limits
        )
        device.state_changed.connect(self._on_state_changed)
        self._on_state_changed()

    def _infos(self) -> list[TraceInfo]:
        """Return what the columns of `Series` are, in that order."""
        return [
            *(
                TraceInfo(
                    f"motor{motor}_current",
                    self.tr("Motor {0}").format(motor),
                    "A",
                    f"motor{motor}",
                    str(motor),
                )
                for motor in (1, 2)
            ),
            *(
                TraceInfo(
                    f"motor{motor}_wish",
                    self.tr("Speed {0} wished").format(motor),
                    "",
                    f"motor{motor}",
                    self.tr("S{0}").format(motor),
                    shown=False,
                )
                for motor in (1, 2)
            ),
            *(
                TraceInfo(
                    f"channel{channel}",
                    self.tr("Channel {0}").format(channel),
                    "",
                    _CHANNEL_COLOURS[channel],
                    self.tr("C{0}").format(channel),
                    shown=False,
                )
                for channel in CHANNELS
            ),
        ]

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


_CHANNEL_COLOURS = {1: "good", 2: "warning", 3: "dirty", 4: "muted", 5: "plot_text"}
