"""Plot of a board's currents, on a page or in a window. Importing this module loads pyqtgraph."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QCloseEvent, QKeySequence, QShortcut, QShowEvent
from PySide6.QtWidgets import QMainWindow, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.telemetry import board_traces
from trex_gui.devices.trex.protocol.descriptions import CURRENT_ACCURACY
from trex_gui.devices.trex.views.motor_controls import MotorBar
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.plotting.panel import TracePanel
from trex_gui.ui.plotting.traces import Traces
from trex_gui.ui.theme.icons import application_icon
from trex_gui.ui.widgets.behaviour import only_when_visible
from trex_gui.ui.widgets.builders import column
from trex_gui.ui.widgets.placement import fit_on_screen, restore_geometry, save_geometry


class CurrentsPanel(TracePanel):
    def __init__(self, device: Device, parent: QWidget, *, key: str = "currents") -> None:
        super().__init__(parent, key=key)
        self._device = device
        self._limits: dict[str, float] = {}
        self._note_text = ""
        self.plot.setObjectName("currentsPlot")
        device.notifier.forward_log(self.notifier)
        history, events = device.telemetry.currents, device.events.all
        self.set_source(Traces(board_traces(), history, events, self._limits))

        device.link_changed.connect(self._on_device_changed)
        device.state_changed.connect(self._on_device_changed)
        device.telemetry.frame_due.connect(self.draw_live)
        device.telemetry.text_due.connect(self._on_text_due)
        device.events.happened.connect(self._on_text_due)

    @Slot()
    def _on_device_changed(self) -> None:
        limits = {motor: self._device.current_limit(motor) for motor in (1, 2)}
        self._limits.clear()
        self._limits |= {f"motor{m}_current": limit for m, limit in limits.items() if limit}
        state = self._device.state
        if state is None:
            note = empty_text = tr("Connect to a board to see its motor currents.")
            if self._device.link is ConnectionState.DISCONNECTED:
                empty_text = tr(
                    "No board is connected. Select a port at the top of the main window and "
                    "press Connect. If you have no hardware, select the demo board."
                )
        elif self._device.board.is_joint:
            note = empty_text = tr("Joint mode: the board does not sense currents.")
        else:
            empty_text = tr("No current has been read yet.")
            step = state.signature.model.current_unit * 1000
            note = tr("One count of this board is {0:.0f} mA.").format(step)
            note = f"{note} {tr(CURRENT_ACCURACY)}"
        settings, title = self._device.settings, title_of(tr("C&urrents"))
        if settings is not None and settings.group:
            title = tr("Board {0}").format(settings.device_number)
        self._head.show_title(title)
        if name := self._device.board_name:  # otherwise the curves and their heading remain
            self.export.heading = f"{tr('Motor currents')}, {name}"
        if note != self._note_text:  # the result of an export remains until the note changes
            self._note_text = note
            self.set_note(note)
        self.plot.set_empty_text(empty_text)
        self.refresh()

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        self.refresh_figures()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._on_device_changed()


class PlotWindow(QMainWindow):
    _KEY = "plot_window"

    def __init__(self, device: Device) -> None:
        super().__init__()
        self.setObjectName("plotWindow")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowIcon(application_icon())
        self.setWindowTitle(tr("Motor currents"))
        self.panel = CurrentsPanel(device, self, key=self._KEY)
        bar = MotorBar(device, "plotStopButton", self)
        bar.fill(bar.armed, 1)
        frame = QWidget(self)
        column((self.panel, 1), bar, into=frame)
        self.setCentralWidget(frame)
        QShortcut(QKeySequence(QKeySequence.StandardKey.Close), self, self.close)
        restore_geometry(self, self._KEY, 900, 560)
        fit_on_screen(self)

    def closeEvent(self, event: QCloseEvent) -> None:
        save_geometry(self, self._KEY)
        super().closeEvent(event)
