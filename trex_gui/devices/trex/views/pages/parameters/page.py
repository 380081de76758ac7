"""Page to read, edit and apply every parameter of the board."""

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.views.pages.parameters.table import ParameterTable
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.widgets.builders import column
from trex_gui.ui.widgets.labels import PageHead


class ParametersPage(QWidget):
    power_cycle_requested = Signal()

    def __init__(self, device: Device, linter: BoardLinter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("parametersPage")
        self._device = device
        self._model = device.parameters

        self._head = PageHead(tr("Parameters"), self)
        self.table = ParameterTable(device.draft, linter, self, self._head)
        column((self.table, 1), into=self, margins=16)

        self.table.power_cycle_requested.connect(self.power_cycle_requested)
        self._model.rejected.connect(device.notifier.error)
        self._model.rounded.connect(device.notifier.info)
        for changed in (device.draft.loaded, device.draft.pending_changed, device.link_changed):
            changed.connect(self._on_changed)
        device.applied.connect(self._on_applied)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        connected = self._device.is_connected
        # Edits reach the board only with Apply, so a silent board need not interrupt typing.
        is_silent = self._device.link is ConnectionState.NOT_RESPONDING
        can_edit = (connected or is_silent) and not self._device.writer.is_rejected
        self.table.set_rows_enabled(can_edit)
        self._head.show_state(self._state_text(connected=connected))

    def _state_text(self, *, connected: bool) -> str:
        if self._model.count == 0:
            return tr("Connect to a board to see its parameters.")
        if not connected:
            return tr(
                "No board responds. Edits are kept until a board of the same kind is connected."
            )
        if blocker := self._device.writer.blocker:
            return blocker
        if self._device.draft.reset_pending:
            return tr("Factory defaults take effect after the next power cycle.")
        if waiting := self._model.values.waiting_for_power:
            text = tr("Stored, but not active until the board is switched off and on: {0}.")
            return text.format(", ".join(waiting))
        return tr("Edit, then review. Nothing is written before that.")

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        failed = [result.key for result in results if result.error is not None]
        if failed:
            self.table.show_parameter(failed[0])
