"""Every parameter of the board: read, edit, apply."""

from PySide6.QtCore import Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.client.writing import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.views.pages.parameters.table import ParameterTable
from trex_gui.ui.devices.connection_state import ConnectionState
from trex_gui.ui.widgets.builders import button, column, label, row


class ParametersPage(QWidget):
    """The parameter table, below pending edits and the result of the last Apply.

    Signals:
        reload_requested: read everything from the board again.
        power_cycle_requested: lead through the one that stored values wait for.
    """

    reload_requested = Signal()
    power_cycle_requested = Signal()

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("parametersPage")
        self._device = device
        self._model = device.parameters

        self._notice = label(self, "parametersNotice", wrap=True)
        self._reload = button(
            self,
            "reloadButton",
            self.tr("Re&load"),
            icon="reload",
            tip=self.tr("Read every parameter from the board again"),
        )
        self._activate = button(
            self,
            "makeActiveButton",
            self.tr("Make active…"),
            icon="power",
            tip=self.tr("Lead through switching the board off and on, and see what is active then"),
        )
        self._discard = button(self, "discardButton", self.tr("Discard edits"), icon="undo")
        self._table = ParameterTable(device.draft, BoardLinter(device, self), self)

        top = row((self._notice, 1), self._activate, self._discard, self._reload)
        column(top, (self._table, 1), into=self)

        self._reload.clicked.connect(self.reload_requested)
        self._activate.clicked.connect(self.power_cycle_requested)
        self._discard.clicked.connect(device.discard_edits)
        self._table.rejected.connect(self._notice.setText)
        self._model.modelReset.connect(self._on_link_changed)
        device.pending_changed.connect(self._on_pending_changed)
        device.applied.connect(self._on_applied)
        device.link_changed.connect(self._on_link_changed)
        self._on_link_changed()

    @Slot(str)
    def show_parameter(self, key: str) -> None:
        """Go to a parameter by its key."""
        self._table.show_parameter(key)

    @Slot()
    def _on_link_changed(self) -> None:
        up = self._device.link is ConnectionState.CONNECTED
        self._reload.setEnabled(up)
        self._activate.setVisible(up and self._waits_for_power)
        self._table.set_rows_enabled(up)
        if self._model.count == 0:
            self._notice.setText(self.tr("Connect to a board to see its parameters."))
        elif up:
            self._on_pending_changed()
        else:
            self._notice.setText(
                self.tr("No board answers. Edits are kept for when the same kind of board is back.")
            )
        self._discard.setEnabled(up and self._device.pending > 0)

    @property
    def _waits_for_power(self) -> bool:
        return bool(self._model.waiting_for_power) or self._device.reset_ordered

    @Slot()
    def _on_pending_changed(self) -> None:
        count = self._device.pending
        self._discard.setEnabled(count > 0 and self._device.link is ConnectionState.CONNECTED)
        waiting = self._model.waiting_for_power
        self._activate.setVisible(
            self._waits_for_power and self._device.link is ConnectionState.CONNECTED
        )
        if self._device.reset_ordered:
            text = self.tr("Factory defaults take effect after the next power cycle.")
        elif count:
            text = self.tr("{0} not applied yet: Apply settings writes them.").format(
                self._count_text(count)
            )
        elif waiting:
            text = self.tr("Stored, but not active before the board is switched off and on: {0}.")
            text = text.format(", ".join(waiting))
        else:
            text = self.tr("Double-click a value to change it. Nothing is written before Apply.")
        self._notice.setText(text)

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        failed = [result for result in results if result.error is not None]
        if any(result.key == ParameterKey.FACTORY_RESET for result in results):
            text = self.tr("Not taken by the board: {0}").format(failed[0].error) if failed else ""
            self._notice.setText(
                text or self.tr("Factory defaults take effect after the next power cycle.")
            )
            return
        if failed:
            self._table.show_parameter(failed[0].key)
            text = self.tr(
                "{0} of {1} settings could not be verified; they are marked below."
            ).format(len(failed), len(results))
        else:
            text = self.tr("{0} written and verified.").format(self._count_text(len(results)))
            if waiting := self._model.waiting_for_power:
                text += " " + self.tr("Switch the board off and on to make active: {0}.").format(
                    ", ".join(waiting)
                )
        self._notice.setText(text)

    def _count_text(self, count: int) -> str:
        return self.tr("1 setting") if count == 1 else self.tr("{0} settings").format(count)
