"""Search field for pages, parameters, menu entries, messages and help."""

from collections.abc import Callable, Iterable

from PySide6.QtCore import QEvent, QObject, QRect, Qt, Slot
from PySide6.QtGui import QStandardItem, QStandardItemModel
from PySide6.QtWidgets import QCompleter, QLineEdit, QTreeView, QWidget
from shiboken6 import Shiboken

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.ui.help.search import Findable, Kind, SearchIndex
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets import builders as ui

_ICONS: dict[Kind, str] = {
    "page": "board",
    "parameter": "settings",
    "action": "console",
    "message": "warning",
    "help": "help",
}
_VISIBLE = 12  # hits that are visible without scrolling
_FIELD, _LIST, _TITLE = 56, 110, 52  # widths in average characters
_HIT = Qt.ItemDataRole.UserRole


class SearchField(QLineEdit):
    """Search field with a list of hits. Enter opens the selected hit. Esc closes the list."""

    def __init__(self, findables: Callable[[], Iterable[Findable]], parent: QWidget) -> None:
        """`findables`: called at the start of each search."""
        super().__init__(parent)
        ui.named(self, "searchField", accessible=title_of(tr("Search every&thing")))
        self.setPlaceholderText(tr("Search everything (Ctrl+K)"))
        self._findables = findables
        self._index: SearchIndex | None = None  # exists during a search
        self._focus_before: QWidget | None = None  # focused widget before the search
        self._model = QStandardItemModel(0, 2, self)
        self._hits = ui.named(QTreeView(), "searchHits", accessible=tr("Hits"))
        self._hits.setHeaderHidden(True)
        self._hits.setRootIsDecorated(False)
        self._hits.installEventFilter(self)
        self._completer = completer = QCompleter(self._model, self)
        completer.setCompletionMode(QCompleter.CompletionMode.UnfilteredPopupCompletion)
        completer.setMaxVisibleItems(_VISIBLE)
        completer.setPopup(self._hits)
        completer.setWidget(self)
        completer.activated.connect(self._on_chosen)
        self.textEdited.connect(self._show_hits)
        follow_theme(self, "width", self._limit_width)

    def _limit_width(self) -> None:
        self.setMaximumWidth(_FIELD * self.fontMetrics().averageCharWidth())

    @Slot()
    def start(self) -> None:
        if (focused := self.window().focusWidget()) is not self:
            self._focus_before = focused
        self.window().activateWindow()
        self.setFocus(Qt.FocusReason.ShortcutFocusReason)
        self._show_hits()

    @Slot()
    def _show_hits(self) -> None:
        self._index = self._index or SearchIndex(self._findables())
        self._model.setRowCount(0)
        no_hit = Findable("help", "", tr("Nothing was found."))
        for hit in self._index.find(self.text()) or [no_hit]:
            text = " · ".join(filter(None, (hit.place, " ".join(hit.text.split())[:120])))
            title, details = QStandardItem(icon(_ICONS[hit.kind]), hit.title), QStandardItem(text)
            title.setData(hit, _HIT)
            title.setAccessibleText(f"{hit.title}. {text}")
            details.setForeground(theme().color("muted"))
            self._model.appendRow([title, details])
        character = self.fontMetrics().averageCharWidth()
        width = min(_LIST * character, self.window().width())
        self._completer.complete(QRect(self.width() - width, 0, width, self.height()))
        self._hits.setColumnWidth(0, _TITLE * character)
        self._hits.setCurrentIndex(self._hits.model().index(0, 0))

    @Slot()
    def _on_chosen(self) -> None:
        hit = self._hits.currentIndex().siblingAtColumn(0).data(_HIT)
        self._hits.hide()  # restores the focus before the hit changes it
        hit.show()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Hide and watched is self._hits:
            self.clear()
            self._index = None
            if self._focus_before is not None and Shiboken.isValid(self._focus_before):
                self._focus_before.setFocus()
            self._focus_before = None
        return super().eventFilter(watched, event)
