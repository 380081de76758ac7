"""Every parameter of the board: read, edit, apply."""

from PySide6.QtCore import Qt, Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.views.pages.parameters.table import ParameterTable
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets.builders import button, column, named, row
from trex_gui.ui.widgets.labels import Note


class ParametersPage(QWidget):
    """The parameter table, below pending edits and the result of the last Apply."""

    reload_requested = Signal()
    power_cycle_requested = Signal()

    def __init__(self, device: Device, linter: BoardLinter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("parametersPage")
        self._device = device
        self._model = device.parameters

        self._notice = named(Note(2, self), "parametersNotice")
        self._notice.setAlignment(Qt.AlignmentFlag.AlignVCenter)
        text, tip = tr("Ma&ke active…"), tr("Show the steps for switching the board off and on")
        self._activate = button(self, "makeActiveButton", text, icon="power", tip=tip)
        self._discard = button(self, "discardButton", tr("Discard edi&ts"), icon="undo")
        text, tip = tr("Re&load"), tr("Read every parameter from the board again")
        self._reload = button(self, "reloadButton", text, icon="reload", tip=tip)
        self.table = ParameterTable(device.draft, linter, self)

        top = row((self._notice, 1), self._activate, self._discard, self._reload)
        column(top, (self.table, 1), into=self)

        self._activate.clicked.connect(self.power_cycle_requested)
        self._discard.clicked.connect(device.draft.discard_edits)
        self._reload.clicked.connect(self.reload_requested)
        self._model.rejected.connect(self._notice.setText)
        self._model.rounded.connect(self._notice.setText)
        self._model.modelReset.connect(self._on_changed)
        device.draft.pending_changed.connect(self._on_changed)
        device.applied.connect(self._on_applied)
        device.link_changed.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        connected = self._device.is_connected
        waiting = bool(self._model.values.waiting_for_power) or self._device.draft.reset_pending
        self._reload.setEnabled(connected)
        self._activate.setVisible(connected and waiting)
        self._discard.setEnabled(connected and self._device.draft.pending > 0)
        # Edits go to the board with Apply only; a silent one interrupts nobody who is typing.
        is_silent = self._device.link is ConnectionState.NOT_RESPONDING
        can_edit = (connected or is_silent) and not self._device.writer.is_rejected
        self.table.set_rows_enabled(can_edit)
        self._notice.setText(self._state_text(connected=connected))

    def _state_text(self, *, connected: bool) -> str:
        if self._model.count == 0:
            return tr("Connect to a board to see its parameters.")
        if not connected:
            return tr(
                "No board is responding. Edits are kept until the same kind of board is connected."
            )
        if blocker := self._device.writer.blocker:
            return blocker
        if self._device.draft.reset_pending:
            return tr("Factory defaults take effect after the next power cycle.")
        if pending := self._device.draft.pending:
            return tr("%n pending change(s): review them to write them.", "", pending)
        if waiting := self._model.values.waiting_for_power:
            text = tr("Stored, but not active until the board is switched off and on: {0}.")
            return text.format(", ".join(waiting))
        return tr(
            "Click a value and type, or double-click it. Nothing is written until you click Apply."
        )

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        failed = [result for result in results if result.error is not None]
        if any(result.key == ParameterKey.FACTORY_RESET for result in results):
            text = tr("Factory defaults take effect after the next power cycle.")
            if failed:
                text = tr("Rejected by the board: {0}").format(error_sentence(failed[0].error))
        elif failed:
            self.table.show_parameter(failed[0].key)
            text = tr("{0} of {1} could not be verified; marked below.")
            text = text.format(len(failed), len(results))
        else:
            text = tr("%n setting(s) written and verified.", "", len(results))
            if waiting := self._model.values.waiting_for_power:
                next_step = tr("Switch the board off and on to make active: {0}.")
                text = f"{text} {next_step.format(', '.join(waiting))}"
        self._notice.setText(text)
