"""Page of the parameters of a board or a file: filters, table and card of the selection."""

from PySide6.QtCore import QModelIndex, Qt, Signal, Slot
from PySide6.QtWidgets import QTabBar, QVBoxLayout, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.linter import BoardLinter, SettingsLinter
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.views.pages.parameters.card import ParameterCard
from trex_gui.devices.trex.views.pages.parameters.view import (
    ParameterChoice,
    ParameterFilter,
    ParameterView,
)
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.theme.theme import set_look
from trex_gui.ui.widgets.builders import button, column, label, named, row, search_field
from trex_gui.ui.widgets.labels import PageHead

_FRAME = 20  # pixels: frame of the search field


class ParameterTable(QWidget):
    power_cycle_requested = Signal()

    def __init__(
        self,
        draft: SettingsDraft,
        linter: SettingsLinter,
        parent: QWidget | None = None,
        header: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._model = draft.parameters
        self._user_key = ""  # key of the cell that the user has selected
        self._is_other_selected = False  # True if this cell is hidden and another cell is selected

        title = tr("Search parameters")
        self._search = search_field(self, "parameterSearch", title, title)
        self._search.setMinimumWidth(self._search.fontMetrics().horizontalAdvance(title) + _FRAME)
        self._choice = named(QTabBar(self), "parameterChoice", accessible=tr("Parameters"))
        set_look(self._choice, "switch")
        self._choice.setDrawBase(False)
        self._choice.setUsesScrollButtons(False)
        for _ in ParameterChoice:
            self._choice.addTab("")
        self._view = ParameterView(self._model, self)
        self._no_match = self._no_match_note()
        self._linter = linter
        self._card = ParameterCard(draft, linter, self._view, self)
        filters = row((self._search, 1), self._choice)
        above = row(*([(header, 2)] if header else []), (filters, 3), spacing=16)
        column(above, (row((self._view, 5), (self._card, 2), spacing=16), 1), into=self, margins=0)

        self._view.selectionModel().currentChanged.connect(self._on_current_changed)
        self._view.clicked.connect(self._on_current_changed)
        self._card.activate.clicked.connect(self.power_cycle_requested)
        self._search.returnPressed.connect(self._view.setFocus)
        filter_changes = self._search.textChanged, self._choice.currentChanged, linter.changed
        value_changes = self._model.modelReset, self._model.pending_changed, draft.loaded
        for changed in (*filter_changes, *value_changes):
            changed.connect(self._update_rows)
        self._update_rows()

    def _no_match_note(self) -> QWidget:
        viewport, center = self._view.viewport(), Qt.AlignmentFlag.AlignCenter
        note = named(QWidget(viewport), "noParameterMatches")
        text = label(note, text=tr("No parameter matches."))
        show_all = button(note, "showAllParameters", tr("&Show all parameters"))
        show_all.clicked.connect(self._show_all)
        column((text, 0, center), (show_all, 0, center), into=note)
        QVBoxLayout(viewport).addWidget(note, 0, center)
        return note

    @Slot()
    def _show_all(self) -> None:
        self._search.clear()
        self._choice.setCurrentIndex(ParameterChoice.ALL)

    def set_rows_enabled(self, enabled: bool) -> None:
        """Enable or disable edits. The search still finds disabled rows."""
        self._view.setEnabled(enabled)
        self._card.set_can_edit(enabled)

    def show_parameter(self, key: str) -> None:
        """Select a parameter for editing, even if it is filtered out."""
        if self._model.index_of(key).isValid():
            self._show_all()
            self._view.setCurrentIndex(self._model.index_of(key))
            self._view.setFocus()

    @Slot(QModelIndex)
    def _on_current_changed(self, current: QModelIndex) -> None:
        if current.isValid():
            self._is_other_selected = False
            self._user_key = self._view.current_key
            above = range(current.row() - 1, -1, -1)
            row_above = next((row for row in above if not self._view.isRowHidden(row)), 0)
            if not self._model.rows[row_above].keys:  # a heading, which cannot be selected
                self._view.scrollTo(self._model.index(row_above, 0))
            if current.row() > 1:
                self._view.scrollTo(current)
        self._view.viewport().update()  # `ParameterDelegate.paint` marks the whole row
        self._card.show_current()

    @Slot()
    def _update_rows(self) -> None:
        keys = frozenset(key for finding in self._linter.findings for key in finding.keys)
        words = self._search.text().casefold().split()
        choice = ParameterChoice(self._choice.currentIndex())
        if self._view.show_rows(ParameterFilter(tuple(words), choice, keys)):
            self._on_rows_changed()
        values = self._model.values
        texts = tr("All"), tr("Changed {0}"), tr("Not default {0}"), tr("Findings {0}")
        not_default = list(filter(values.differs_from_default, values.specs))
        kinds = (), values.modified, not_default, values.specs.keys() & keys
        for tab, members in enumerate(kinds):
            self._choice.setTabText(tab, texts[tab].format(len(members)))
        for widget in (self._search, self._choice):
            widget.setEnabled(self._model.count > 0)

    def _on_rows_changed(self) -> None:
        current, selected = self._view.currentIndex(), self._model.index_of(self._user_key)
        if self._is_other_selected or self._view.is_hidden(current):
            if not self._view.is_hidden(selected):
                self._view.setCurrentIndex(selected)
            elif self._view.is_hidden(current):
                key = self._user_key
                self._view.setCurrentIndex(self._view.filter.best_match(self._model))
                self._is_other_selected, self._user_key = bool(key), key or self._view.current_key
        self._no_match.setVisible(self._model.count > 0 and not self._view.filter.rows(self._model))
        self._card.show_current()


class ParametersPage(QWidget):
    power_cycle_requested = Signal()

    def __init__(self, device: Device, linter: BoardLinter, parent: QWidget) -> None:
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
        # Only Apply writes edits to the board, so a silent board must not interrupt typing.
        is_silent = self._device.link is ConnectionState.NOT_RESPONDING
        can_edit = (connected or is_silent) and not self._device.writer.is_rejected
        self.table.set_rows_enabled(can_edit)
        self._head.show_state(self._state_text(connected=connected))

    def _state_text(self, *, connected: bool) -> str:
        if self._model.count == 0:
            return tr("Connect to a board to see its parameters.")
        if not connected:
            return tr(
                "No board responds. Your edits are saved for the next board of the same model."
            )
        if blocker := self._device.writer.blocker:
            return blocker
        if self._device.draft.reset_pending:
            return tr("Factory defaults take effect after the next power cycle.")
        if waiting := self._model.values.waiting_for_power:
            text = tr("Stored, but not active until the board is switched off and on: {0}.")
            return text.format(", ".join(waiting))
        return tr("Edit, then review. Nothing is written before the review.")

    @Slot(object)
    def _on_applied(self, results: tuple[WriteResult, ...]) -> None:
        failed = [result.key for result in results if result.error is not None]
        if failed:
            self.table.show_parameter(failed[0])
