"""The page of the channels, which are calibrated by pointing."""

from collections.abc import Iterator
from contextlib import contextmanager

from PySide6.QtCore import QPoint
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QTabBar, QWidget
from pytestqt.qtbot import QtBot

from tests.support.accessible_names import spoken_state
from tests.support.simulator import SimulatedDevice
from tests.support.window import LEFT, TIMEOUT_MS, WidgetDriver
from trex_gui.devices.trex.model.calibration_moves import Handle
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.views.pages.channels.curve_handles import GRIP
from trex_gui.devices.trex.views.pages.channels.curve_plot import CurvePlot
from trex_gui.devices.trex.views.pages.channels.page import ChannelsPage
from trex_gui.devices.trex.views.pages.channels.strips import ChannelStrip
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.theme.theme import theme


def handle_position(plot: CurvePlot, handle: Handle) -> QPoint:
    """Return where a handle can be grabbed, in pixels."""
    assert plot.curve is not None
    frame = plot._canvas.frame
    y = frame.bottom() - GRIP if handle.is_deadband else frame.top() + 2
    return QPoint(round(plot.x_of(handle.count(plot.curve.calibration))), round(y))


def input_of(page: WidgetDriver, channel: int) -> str:
    """Return what the strip of a channel says of its input."""
    return spoken_state(page.find(ChannelStrip, f"channel{channel}Strip"))


class ChannelsDriver(WidgetDriver):
    """The page, in the main window or by itself."""

    def __init__(self, widget: ChannelsPage, device: Device, qtbot: QtBot) -> None:
        super().__init__(widget, qtbot)
        self.widget = widget
        self.device = device

    def connect(self, url: str) -> None:
        self.device.connect_to(ConnectionSettings(url))
        self.wait(lambda: self.device.link is ConnectionState.CONNECTED)
        self.wait(lambda: self.device.telemetry.raw is not None)

    def disconnect(self) -> None:
        self.device.disconnect_line()
        self.wait(lambda: self.device.link is ConnectionState.DISCONNECTED)

    def restart(self, simulator: SimulatedDevice, *lines: str) -> None:
        """Change jumpers or stored settings, and connect to the restarted board."""
        self.disconnect()
        simulator.do(*lines, "power cycle")
        self.connect(simulator.url)

    # --- Read ---------------------------------------------------------------------------

    @property
    def plot(self) -> CurvePlot:
        return self.find(CurvePlot, "curvePlot")

    @property
    def note(self) -> str:
        return self.text("calibrationNote")

    @property
    def live(self) -> str:
        """What is said of the live input."""
        return self.text("channelLive")

    def strip(self, channel: int) -> ChannelStrip:
        return self.find(ChannelStrip, f"channel{channel}Strip")

    def input(self, channel: int) -> str:
        return input_of(self, channel)

    def shown(self, channel: int = 1) -> Calibration:
        shown = self.device.calibrations.shown(channel)
        assert shown is not None
        return shown

    # --- Operate ------------------------------------------------------------------------

    def select_channel(self, channel: int) -> None:
        QTest.mouseClick(self.strip(channel), LEFT)
        assert self.widget.channel == channel

    def select_source(self, index: int) -> None:
        bar = self.find(QTabBar, "sourceTabs")
        QTest.mouseClick(bar, LEFT, pos=bar.tabRect(index).center())

    def drag_handle(self, handle: Handle, count: int, *, release: bool = True) -> None:
        """Drag a handle of the curve to a count."""
        self.widget.grab()  # lets the layout settle
        viewport = self.find(QWidget, "curveViewport")
        start = handle_position(self.plot, handle)
        end = QPoint(round(self.plot.x_of(count)), start.y())
        QTest.mousePress(viewport, LEFT, pos=start)
        for share in (0.5, 1.0):
            QTest.mouseMove(viewport, start + (end - start) * share)
        if release:
            self.release_handle()

    def release_handle(self) -> None:
        QTest.mouseRelease(self.find(QWidget, "curveViewport"), LEFT)

    def action(self, key: str) -> QAction:
        """Return the entry of the page's menu with this key."""
        assert self.is_enabled("changeButton")
        action = self.find(QAction, f"{key}Action")
        assert action.isVisible(), key
        return action

    def apply(self) -> None:
        """Write all edits, without the window that shows them before."""
        self.device.writer.apply()
        self.wait(lambda: not self.device.writer.running)


@contextmanager
def channels_page(qtbot: QtBot) -> Iterator[ChannelsDriver]:
    """Show the page by itself, without the main window."""
    app = QApplication.instance()
    assert isinstance(app, QApplication)
    theme().install(app)
    device = Device()
    widget = ChannelsPage(device, BoardLinter(device))
    qtbot.addWidget(widget)
    widget.resize(1050, 600)
    widget.show()
    try:
        yield ChannelsDriver(widget, device, qtbot)
    finally:
        qtbot.waitUntil(device.shut_down, timeout=TIMEOUT_MS)
