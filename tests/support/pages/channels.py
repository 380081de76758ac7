"""Drivers of the Channels page and of its calibration plot."""

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


class CurvePlotDriver(WidgetDriver):
    """Driver of a calibration plot and its handles."""

    def __init__(self, plot: CurvePlot, qtbot: QtBot) -> None:
        super().__init__(plot, qtbot)
        self.plot = plot

    @property
    def viewport(self) -> QWidget:
        return self.find(QWidget, "curveViewport")

    def place(self, handle: Handle) -> QPoint:
        """Return the position of a handle in pixels."""
        assert self.plot.curve is not None
        frame = self.plot._canvas.frame
        y = frame.bottom() - GRIP if handle.is_deadband else frame.top() + 2
        return QPoint(round(self.plot.x_of(handle.count(self.plot.curve.calibration))), round(y))

    def press(self, place: QPoint) -> None:
        QTest.mousePress(self.viewport, LEFT, pos=place)

    def move(self, place: QPoint) -> None:
        QTest.mouseMove(self.viewport, place)

    def release(self, place: QPoint) -> None:
        QTest.mouseRelease(self.viewport, LEFT, pos=place)

    def drag_handle(self, handle: Handle, count: int, *, release: bool = True) -> None:
        """Drag a handle to a count in a few steps."""
        start = self.place(handle)
        end = QPoint(round(self.plot.x_of(count)), start.y())
        self.press(start)
        for step in (0.3, 0.7, 1.0):
            self.move(start + (end - start) * step)
        if release:
            self.release(end)


def input_of(page: WidgetDriver, channel: int) -> str:
    """Return the spoken input of a channel's strip."""
    return spoken_state(page.find(ChannelStrip, f"channel{channel}Strip"))


class ChannelsDriver(WidgetDriver):
    """Channels page, in the main window or alone."""

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
        """Send control lines, power-cycle the board and connect again."""
        self.disconnect()
        simulator.do(*lines, "power cycle")
        self.connect(simulator.url)

    # --- Read ---------------------------------------------------------------------------

    @property
    def plot(self) -> CurvePlot:
        return self.find(CurvePlot, "curvePlot")

    @property
    def shown_note(self) -> str:
        return self.text("calibrationNote")

    @property
    def live(self) -> str:
        """Text about the live input."""
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
        self.widget.grab()  # completes the layout
        CurvePlotDriver(self.plot, self.qtbot).drag_handle(handle, count, release=release)

    def release_handle(self) -> None:
        CurvePlotDriver(self.plot, self.qtbot).release(QPoint())

    def action(self, key: str) -> QAction:
        """Return the entry of the page's menu with this key."""
        assert self.is_enabled("changeButton")
        action = self.find(QAction, f"{key}Action")
        assert action.isVisible(), key
        return action

    def apply(self) -> None:
        """Write all edits without a review."""
        self.device.writer.apply()
        self.wait(lambda: not self.device.writer.running)


@contextmanager
def channels_page(qtbot: QtBot) -> Iterator[ChannelsDriver]:
    """Show the Channels page without the main window."""
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
