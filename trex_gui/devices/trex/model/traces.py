"""The curves of a board, connected or recorded: currents, speed setpoints, channels."""

from PySide6.QtCore import QCoreApplication, QObject, Slot

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.flags import CHANNELS
from trex_gui.devices.trex.protocol.parameters import MotorParameter
from trex_gui.ui.plotting.data.traces import TraceInfo, Traces

_CHANNEL_COLORS = {1: "good", 2: "warning", 3: "dirty", 4: "muted", 5: "plot_text"}


def board_traces() -> list[TraceInfo]:
    """Return the columns of `telemetry.Series`, in that order."""

    def tr(text: str, number: int) -> str:
        return QCoreApplication.translate("board_traces", text).format(number)

    return [
        *(
            TraceInfo(f"motor{m}_current", tr("Motor {0}", m), "A", f"motor{m}", str(m))
            for m in (1, 2)
        ),
        *(
            TraceInfo(
                f"motor{m}_setpoint", tr("Speed setpoint {0}", m), "", f"motor{m}", f"S{m}", False
            )
            for m in (1, 2)
        ),
        *(
            TraceInfo(f"channel{c}", tr("Channel {0}", c), "", _CHANNEL_COLORS[c], f"C{c}", False)
            for c in CHANNELS
        ),
    ]


def current_limit(device: Device, motor: int) -> float | None:
    """Return the current limit in A that the board stores; `None` when off or not known."""
    key = MotorParameter.CURRENT_LIMIT.of(motor)
    wire = device.parameters.stored_of(key)
    return wire * device.parameters.spec_of(key).scale if wire else None


class LiveTraces(QObject):
    """The curves of the connected board with its current limits, as `traces`."""

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
            limit = current_limit(self._device, motor)
            if limit is not None:
                self._limits[f"motor{motor}_current"] = limit
