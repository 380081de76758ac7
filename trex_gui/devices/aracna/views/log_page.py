"""The log page: events, newest first, and the statistics of the line."""

import time

from PySide6.QtCore import Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QFormLayout, QGroupBox, QListWidget, QWidget

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.event_log import Event, EventKind
from trex_gui.ui.runtime import now
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible

_MAX_EVENTS = 500


class LogPage(QWidget):
    def __init__(self, robot: Robot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaLogPage")
        self._robot = robot
        self._list = ui.named(QListWidget(self), "aracnaLog", accessible=self.tr("Events"))
        self._list.setWordWrap(True)
        self._list.setAlternatingRowColors(True)
        line = QGroupBox(self.tr("Line"), self)
        self._traffic, self._failures = (
            ui.label(line, name, wrap=True, expand=True, selectable=True)
            for name in ("aracnaTrafficValue", "aracnaQualityValue")
        )
        form = QFormLayout(line)
        form.addRow(self.tr("Requests:"), self._traffic)
        form.addRow(self.tr("Failures:"), self._failures)
        ui.column((self._list, 1), line, into=self)

        robot.events.happened.connect(self._on_happened)
        robot.changed.connect(self._on_changed)
        for event in robot.events.all[-_MAX_EVENTS:]:
            self._on_happened(event)

    @Slot(object)
    def _on_happened(self, event: Event) -> None:
        wall_clock = time.time() - (now() - event.time)
        moment = time.strftime("%H:%M:%S", time.localtime(wall_clock))
        self._list.insertItem(0, f"{moment}  {event.text}")
        if event.kind is EventKind.FAULT:
            self._list.item(0).setIcon(icon("warning", "warning"))
        while self._list.count() > _MAX_EVENTS:
            self._list.takeItem(self._list.count() - 1)

    @Slot()
    @only_when_visible
    def _on_changed(self) -> None:
        stats = self._robot.state.stats
        is_valid = stats.requests > 0 and self._robot.link in {
            ConnectionState.CONNECTED,
            ConnectionState.NOT_RESPONDING,
        }
        traffic = failures = self.tr("N/A")
        if is_valid:
            finished = stats.replies + stats.timeouts + stats.corrupted
            traffic = self.tr("{0} replies to {1} requests ({2:.2f} %)").format(
                stats.replies, finished, 100 * stats.replies / max(finished, 1)
            )
            failures = self.tr(
                "Timeouts: {0}, corrupted: {1}, unrecognized lines: {2}, restarts: {3}; slowest "
                "reply: {4:.0f}\u00a0ms (without motions)"
            ).format(
                stats.timeouts,
                stats.corrupted,
                stats.unrecognized,
                stats.restarts,
                1000 * stats.slowest,
            )
        for label, text in ((self._traffic, traffic), (self._failures, failures)):
            label.setEnabled(is_valid)
            label.setText(text)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._on_changed()
