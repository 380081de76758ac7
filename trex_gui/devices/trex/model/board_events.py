"""Stops, Apply, faults, and lost and restored connections of one board."""

from PySide6.QtCore import QObject, Slot

from trex_gui.core.events import EventKind
from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.motors import Motors
from trex_gui.ui.log import EventLog

_NAMED = 3  # written settings that an event names; the rest are counted


class BoardEvents(EventLog):
    """Events of the board: reports of its mirror, stops, and writes by Apply."""

    def __init__(self, motors: Motors, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._motors = motors
        motors.stop_requested.connect(self._on_stop_requested)

    def record_applied(self, results: tuple[WriteResult, ...], names: tuple[str, ...]) -> None:
        """Log what Apply has written. `names` are those of `results`."""
        done = [name for name, one in zip(names, results, strict=True) if one.error is None]
        failed = len(results) - len(done)
        text = ", ".join(done[:_NAMED])
        if len(done) > _NAMED:
            text = tr("{0} and {1} more").format(text, len(done) - _NAMED)
        if failed:
            text = tr("{0} ({1} failed)").format(text, failed).strip()
        self.add(EventKind.APPLY, tr("Apply: {0}").format(text), is_problem=failed > 0)

    @Slot()
    def _on_stop_requested(self) -> None:
        reason = self._motors.stop_reason
        text = tr("Stop: {0}").format(reason) if reason else tr("Stop")
        self.add(EventKind.STOP, text)
