"""Compare a settings file with another file, the board or the factory defaults."""

from collections.abc import Callable

from PySide6.QtCore import Qt, Signal, SignalInstance, Slot
from PySide6.QtWidgets import QDialog, QLabel, QPushButton, QWidget

from trex_gui.core.errors import BadRequest, sentence
from trex_gui.devices.trex.model.settings.document import SettingsDocument
from trex_gui.devices.trex.model.settings.draft import diff_against_draft
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.views.comparison_view import ComparisonView
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.widgets.builders import button, column, row
from trex_gui.ui.widgets.labels import Note


class CompareDialog(QDialog):
    """Beside the editor; it follows the edits there, and values can be taken over.

    Signals:
        taken: values of the other side became edits; the count, for the user.
    """

    taken = Signal(str)

    def __init__(
        self,
        document: SettingsDocument,
        other: Callable[[], Settings | None],
        other_name: str,
        *,
        renewed_by: SignalInstance | None = None,
        parent: QWidget | None = None,
    ) -> None:
        """Compare with what `other` returns, again whenever `renewed_by` is emitted."""
        super().__init__(parent)
        self.setObjectName("compareDialog")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(self.tr("{0} and {1}").format(document.name, other_name))
        self.resize(940, 560)
        self._document = document
        self._other = other
        self._other_name = other_name
        self._settings: Settings | None = None
        self._has_rows = False

        self._trouble = Note(1, self)
        self._trouble.setObjectName("compareTrouble")
        self._rows = ComparisonView(self)
        self._foot = QLabel(self)
        self._foot.setWordWrap(True)
        self._take = QPushButton(self)
        self._take.setObjectName("takeValuesButton")
        set_icon(self._take, "edited")
        self._close = button(self, "closeCompareButton", self.tr("Close"), default=True)

        buttons = row((self._foot, 1), self._take, self._close)
        column(self._trouble, (self._rows, 1), buttons, into=self)

        self._take.clicked.connect(self._on_take_clicked)
        self._close.clicked.connect(self.close)
        self._rows.ticked_changed.connect(self._on_ticked_changed)
        document.changed.connect(self._on_changed)
        if renewed_by is not None:
            renewed_by.connect(self._on_changed)
        self._on_changed()

    @Slot()
    def _on_changed(self) -> None:
        # What went away while it was looked at is still worth looking at.
        self._settings = self._other() or self._settings
        mine, theirs = self._document.settings, self._settings
        if mine is None or theirs is None:
            return
        trouble, comparison, takes = "", Comparison(()), True
        try:
            comparison = diff_against_draft(self._document.draft, theirs)
        except BadRequest as error:
            trouble, takes = sentence(error), False
            comparison = compare(mine, theirs)
        summary = _summary(comparison)
        if self._has_rows:
            self._rows.renew(comparison, summary)
        else:
            self._rows.show_comparison(
                comparison, self._document.name, self._other_name, with_ticks=takes, summary=summary
            )
            self._has_rows = True
        self._trouble.show_note(trouble, alarming=True)
        self._trouble.setVisible(bool(trouble))
        self._take.setVisible(takes)
        self._on_ticked_changed()

    @Slot()
    def _on_ticked_changed(self) -> None:
        count = len(self._rows.table.ticked)
        self._take.setEnabled(count > 0)
        self._take.setText(
            self.tr("&Take 1 value into {0}").format(self._document.name)
            if count == 1
            else self.tr("&Take {0} values into {1}").format(count, self._document.name)
        )

    @Slot()
    def _on_take_clicked(self) -> None:
        rows = self._rows.table.ticked
        text = self.tr("Take values of {0}").format(self._other_name)
        try:
            self._document.draft.stage(rows, text)
        except BadRequest as error:
            self._trouble.show_note(sentence(error), alarming=True)
            self._trouble.show()
            return
        words = (
            self.tr("1 value was taken from {0}.").format(self._other_name)
            if len(rows) == 1
            else self.tr("{0} values were taken from {1}.").format(len(rows), self._other_name)
        )
        self.taken.emit(words)


def _summary(comparison: Comparison) -> str:
    """Return the counts of two equal sides: neither will become the other by itself."""
    differing = len(comparison.differing)
    verb = "differs" if differing == 1 else "differ"
    return f"{len(comparison.rows)} settings: {differing} {verb}, {comparison.equal} match."
