"""The parameters of a draft: filters, table, and the selected one; of a board or of a file."""

from PySide6.QtCore import QModelIndex, Qt, Signal, Slot
from PySide6.QtWidgets import QVBoxLayout, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.linter import SettingsLinter
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.model.settings.draft import SettingsDraft
from trex_gui.devices.trex.views.pages.parameters.card import ParameterCard
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilter, ParameterFilters
from trex_gui.devices.trex.views.pages.parameters.view import ParameterView
from trex_gui.ui.widgets.builders import button, column, label, named, row


class ParameterTable(QWidget):
    """The parameters of a board or of a file; has no access to a board."""

    power_cycle_requested = Signal()

    def __init__(
        self,
        draft: SettingsDraft,
        linter: SettingsLinter,
        parent: QWidget | None = None,
        head: QWidget | None = None,
    ) -> None:
        """`head` is shown beside the filters."""
        super().__init__(parent)
        self._model = draft.parameters
        self._rows = ParameterFilter(self._model, self)
        self._place = ""  # key of the cell that the user has selected
        self._is_elsewhere = False

        self._filters = ParameterFilters(self._rows, self)
        self._view = ParameterView(self._rows, self)
        self._no_match = self._no_match_note()
        self._linter = linter
        self._card = ParameterCard(draft, linter, self._view, self)
        above = row(*([(head, 2)] if head else []), (self._filters, 3), spacing=16)
        column(above, (row((self._view, 5), (self._card, 2), spacing=16), 1), into=self, margins=0)

        self._view.selectionModel().currentChanged.connect(self._on_current_changed)
        self._view.clicked.connect(self._on_current_changed)
        self._card.activate.clicked.connect(self.power_cycle_requested)
        linter.changed.connect(self._on_linter_changed)
        self._filters.entered.connect(self._view.setFocus)
        rows = self._rows
        for changed in (rows.modelReset, rows.layoutChanged, rows.rowsInserted, rows.rowsRemoved):
            changed.connect(self._on_rows_changed)
        self._on_rows_changed()
        self._on_linter_changed()

    @Slot()
    def _on_linter_changed(self) -> None:
        keys = (key for finding in self._linter.findings for key in finding.keys)
        self._rows.set_found(frozenset(keys))
        self._filters.show_counts()

    def _no_match_note(self) -> QWidget:
        viewport, centre = self._view.viewport(), Qt.AlignmentFlag.AlignCenter
        note = named(QWidget(viewport), "noParameterMatches")
        text = label(note, text=tr("No parameter matches."))
        show_all = button(note, "showAllParameters", tr("&Show all parameters"))
        show_all.clicked.connect(self._filters.clear)
        column((text, 0, centre), (show_all, 0, centre), into=note)
        QVBoxLayout(viewport).addWidget(note, 0, centre)
        return note

    def set_rows_enabled(self, enabled: bool) -> None:
        """Enable edits; disabled rows can still be searched."""
        self._view.setEnabled(enabled)
        self._card.set_can_edit(enabled)

    def show_parameter(self, key: str) -> None:
        """Select a parameter, which may be filtered out."""
        if self._model.index_of(key).isValid():
            self._filters.clear()
            self._view.setCurrentIndex(self._rows.index_of(key))

    @Slot(QModelIndex)
    def _on_current_changed(self, current: QModelIndex) -> None:
        if current.isValid():
            self._is_elsewhere = False
            self._place = self._view.current_key
            above = current.sibling(current.row() - 1, ParameterColumn.NAME)
            if not self._rows.keys_at(above.row()):
                self._view.scrollTo(above)  # no key reaches a heading
            if current.row() > 1:
                self._view.scrollTo(current)
        self._view.viewport().update()  # the whole row is marked
        self._card.show_current()

    @Slot()
    def _on_rows_changed(self) -> None:
        """Keep the user's value selected while it is shown; else select the first."""
        self._view.arrange()
        self._no_match.setVisible(self._model.count > 0 and self._rows.rowCount() == 0)
        is_lost = self._is_elsewhere or not self._view.currentIndex().isValid()
        if is_lost and self._rows.rowCount() > 0:
            place = self._rows.index_of(self._place)
            if place.isValid():
                self._view.setCurrentIndex(place)
            elif not self._view.currentIndex().isValid():
                wanted = self._place
                self._view.setCurrentIndex(self._rows.best_match())
                self._is_elsewhere = bool(wanted)
                self._place = wanted or self._place
        self._card.show_current()
