"""What happened to the robot, newest first, and how its line does."""

import time

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import (
    QFormLayout,
    QGroupBox,
    QLabel,
    QListWidget,
    QSizePolicy,
    QVBoxLayout,
    QWidget,
)

from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.event_log import Event, EventKind
from trex_gui.ui.runtime import now
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.widgets.behaviour import only_when_visible

_MOST = 500


class LogPage(QWidget):
    """A list of sentences with the times at which they were true, and the line's counts."""

    def __init__(self, robot: Robot, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("aracnaLogPage")
        self._robot = robot
        self._list = QListWidget(self)
        self._list.setObjectName("aracnaLog")
        self._list.setAccessibleName(self.tr("What happened"))
        self._list.setWordWrap(True)
        self._list.setAlternatingRowColors(True)
        line = QGroupBox(self.tr("Line"), self)
        self._traffic = _value("aracnaTrafficValue", line)
        self._quality = _value("aracnaQualityValue", line)

        form = QFormLayout(line)
        form.addRow(self.tr("Requests:"), self._traffic)
        form.addRow(self.tr("Failures:"), self._quality)
        layout = QVBoxLayout(self)
        layout.addWidget(self._list, 1)
        layout.addWidget(line)

        robot.events.happened.connect(self._on_happened)
        robot.changed.connect(self._on_changed)
        robot.link_changed.connect(self._on_changed)
        for event in robot.events.all[-_MOST:]:
            self._on_happened(event)

    @Slot(object)
    def _on_happened(self, event: Event) -> None:
        wall = time.time() - (now() - event.time)
        moment = time.strftime("%H:%M:%S", time.localtime(wall))
        self._list.insertItem(0, f"{moment}  {event.text}")
        item = self._list.item(0)
        if event.kind is EventKind.FAULT:
            item.setIcon(icon("warning", "warning"))
        while self._list.count() > _MOST:
            self._list.takeItem(self._list.count() - 1)

    @Slot()
    @only_when_visible
    def _on_changed(self) -> None:
        """Show the counts; they are told once a second."""
        counters = self._robot.counters
        known = (
            self._robot.link in {ConnectionState.CONNECTED, ConnectionState.NOT_RESPONDING}
            and counters.requests > 0
        )
        for label in (self._traffic, self._quality):
            label.setEnabled(known)
        if not known:
            self._traffic.setText(self.tr("N/A"))
            self._quality.setText(self.tr("N/A"))
            return
        over = counters.replies + counters.timeouts + counters.corrupted
        self._traffic.setText(
            self.tr("{0} of {1} answered ({2:.2f} %)").format(
                counters.replies, over, 100 * counters.replies / max(over, 1)
            )
        )
        self._quality.setText(
            self.tr(
                "{0} silent, {1} damaged, {2} strange lines, {3} restarts; slowest answer "
                "{4:.0f}\u00a0ms (motions left out)"
            ).format(
                counters.timeouts,
                counters.corrupted,
                counters.unrecognized,
                counters.restarts,
                1000 * counters.slowest,
            )
        )

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._on_changed()


def _value(name: str, parent: QWidget) -> QLabel:
    label = QLabel(parent)
    label.setObjectName(name)
    label.setWordWrap(True)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
    return label
