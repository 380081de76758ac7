"""Currents of both motors against time, with setpoints, channels and events."""

from typing import TYPE_CHECKING

from PySide6.QtCore import Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.telemetry import board_traces
from trex_gui.devices.trex.protocol.parameters import MotorParameter
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.plotting.page import PlotPage
from trex_gui.ui.plotting.traces import Traces
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.builders import column

if TYPE_CHECKING:
    from trex_gui.ui.plotting.panel import TracePanel


def current_limit(device: Device, motor: int) -> float | None:
    """Return the current limit in A that the board stores; `None` when off or not known."""
    key = MotorParameter.CURRENT_LIMIT.of(motor)
    wire = device.parameters.stored_of(key)
    return wire * device.parameters.spec_of(key).scale if wire else None


class CurrentsPage(PlotPage):
    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("currentsPage")
        self._device = device
        self._limits: dict[str, float] = {}
        self._panel: TracePanel | None = None
        self._note = ""

        device.link_changed.connect(self._on_device_changed)
        device.state_changed.connect(self._on_device_changed)
        device.telemetry.frame_due.connect(self._on_frame_due)
        device.telemetry.text_due.connect(self._on_text_due)
        device.events.happened.connect(self._on_text_due)

    def add_plot(self) -> None:
        from trex_gui.ui.plotting.panel import TracePanel  # noqa: PLC0415 - takes as long as Qt

        self._panel = panel = TracePanel(parent=self)
        panel.plot.setObjectName("currentsPlot")
        self._device.notifier.log_also(panel.notifier)
        history, events = self._device.telemetry.currents, self._device.events.all
        panel.set_source(Traces(board_traces(), history, events, self._limits))
        column(panel, into=self)

    @Slot()
    def _on_device_changed(self) -> None:
        if self._panel is None:
            return
        limits = {motor: current_limit(self._device, motor) for motor in (1, 2)}
        self._limits.clear()
        self._limits |= {f"motor{m}_current": limit for m, limit in limits.items() if limit}
        state = self._device.state
        if state is None:
            note = empty = self.tr("Connect to a board to see its motor currents.")
            if self._device.link is ConnectionState.DISCONNECTED:
                empty = self.tr(
                    "No board is connected. Choose a port at the top and press Connect; without "
                    "hardware, choose the demo board."
                )
        elif self._device.is_joint:
            note = empty = self.tr("Joint mode: the board does not sense currents.")
        else:
            empty = self.tr("No current has been read yet.")
            step = state.signature.model.current_unit * 1000
            note = self.tr("One count of this board is {0:.0f} mA.").format(step)
        if name := self._device.board_name:  # the curves remain when it is disconnected
            self._panel.export.heading = self.tr("Motor currents, {0}").format(name)
        # The result of an export remains until the note changes.
        if note != self._note:
            self._note = note
            self._panel.set_note(note)
        self._panel.plot.set_empty_text(empty)
        self._panel.refresh()

    @Slot()
    @only_when_visible
    def _on_frame_due(self) -> None:
        if self._panel is not None:
            self._panel.draw_live()

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        if self._panel is not None:
            self._panel.refresh_figures()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._on_device_changed()
