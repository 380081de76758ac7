"""The log of a robot and the statistics of its line."""

from PySide6.QtCore import Slot
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QFormLayout, QWidget

from trex_gui.core.translation import Number, tr
from trex_gui.devices.aracna.model.robot import Robot
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.help.messages import MessageHelp
from trex_gui.ui.log import Log, LogPage
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible


class RobotLogPage(LogPage):
    def __init__(
        self, robot: Robot, log: Log, message_help: MessageHelp, parent: QWidget | None = None
    ) -> None:
        super().__init__(log, "aracna", robot.notifier, message_help, parent)
        self._robot = robot
        line = ui.Card(tr("Line"), self)
        self._traffic, self._failures = (
            ui.label(line, name, wrap=True, expand=True, selectable=True)
            for name in ("aracnaTrafficValue", "aracnaQualityValue")
        )
        form = QFormLayout(line)
        form.addRow(tr("Requests:"), self._traffic)
        form.addRow(tr("Failures:"), self._failures)
        self.rows.addWidget(line)
        robot.changed.connect(self._on_changed)

    @Slot()
    @only_when_visible
    def _on_changed(self) -> None:
        stats = self._robot.state.stats
        is_valid = stats.requests > 0 and self._robot.link in {
            ConnectionState.CONNECTED,
            ConnectionState.NOT_RESPONDING,
        }
        traffic = failures = tr("N/A")
        if is_valid:
            finished = stats.replies + stats.timeouts + stats.corrupted
            traffic = tr("{0} replies to {1} requests ({2:.2f} %)").format(
                stats.replies, finished, Number(100 * stats.replies / max(finished, 1))
            )
            failures = tr(
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
