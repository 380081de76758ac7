"""Compare a settings file with the board or another file, and take values of the other side."""

from collections.abc import Callable

from PySide6.QtCore import Qt, Signal, SignalInstance, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.settings.comparison import compare
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.widgets.behaviour import ReusedDialog
from trex_gui.ui.widgets.builders import button, column, named, no_mnemonic, row
from trex_gui.ui.widgets.labels import Note
from trex_gui.ui.widgets.placement import resize_with_font

GetSettings = Callable[[], Settings | None]


class CompareDialog(ReusedDialog):
    """Compares the file of an editor with other settings, whose values can be taken."""

    taken = Signal(str)  # values of the other side became edits; a message

    def __init__(
        self,
        document: SettingsDocument,
        other: GetSettings,
        other_name: str,
        *,
        renewed_by: SignalInstance | None = None,
        parent: QWidget | None = None,
    ) -> None:
        """Compare with the result of `other`, again whenever `renewed_by` is emitted."""
        super().__init__(parent)
        self.setObjectName("compareDialog")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(tr("{0} and {1}").format(document.name, other_name))
        resize_with_font(self, 940, 560)
        self._document = document
        self._other = other
        self._other_name = other_name
        self._settings: Settings | None = None

        self._trouble = named(Note(2, self), "compareTrouble")
        self._view = ComparisonView(self)
        self._take = button(self, "takeValuesButton", icon="edited", on_click=self._on_take_clicked)
        close = button(self, "closeCompareButton", tr("Close"), default=True, on_click=self.close)
        column(self._trouble, (self._view, 1), row(1, self._take, close), into=self)

        self._view.ticked_changed.connect(self._update_take)
        document.changed.connect(self._on_changed)
        if renewed_by is not None:
            renewed_by.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        # Settings of a board that is gone stay.
        self._settings = self._other() or self._settings
        mine, theirs = self._document.settings, self._settings
        if mine is None or theirs is None:
            return
        trouble = ""
        try:
            comparison = diff_against_draft(self._document.draft, theirs)
        except BadRequest as error:
            trouble = error_sentence(error)
            comparison = compare(mine, theirs)
        text = tr("%n setting(s) differ, {0} match.", "", len(comparison.differing))
        self._view.show_comparison(
            comparison,
            self._document.name,
            self._other_name,
            with_ticks=not trouble,
            summary=text.format(comparison.equal),
            keep_ticks=True,
        )
        self._trouble.show_note(trouble, alarming=True)
        self._take.setVisible(not trouble)
        self._update_take()

    @Slot()
    def _update_take(self) -> None:
        count = len(self._view.table.ticked)
        text = tr("&Copy %n value(s) to {0}", "", count)
        self._take.setText(text.format(no_mnemonic(self._document.name)))
        self._take.setEnabled(count > 0)

    @Slot()
    def _on_take_clicked(self) -> None:
        rows = self._view.table.ticked
        text = tr("Copy values from {0}").format(self._other_name)
        try:
            self._document.draft.stage(rows, text)
        except BadRequest as error:
            self._trouble.show_note(error_sentence(error), alarming=True)
            return
        text = tr("%n value(s) copied from {0}.", "", len(rows))
        self.taken.emit(text.format(self._other_name))
