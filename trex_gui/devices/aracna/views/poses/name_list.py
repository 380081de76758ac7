"""A list of names: renamed in place, put in order with mouse and keyboard."""

from PySide6.QtCore import QModelIndex, QPoint, QRect, Qt, Signal, Slot
from PySide6.QtGui import QAction, QDropEvent, QKeySequence, QPainter, QPaintEvent
from PySide6.QtWidgets import QAbstractItemView, QListView, QWidget

from trex_gui.devices.aracna.model.names import Motion, Names
from trex_gui.ui.theme.theme import theme

_LINES = 4


class NameList(QListView):
    """Shows names; what a person wants done is a signal.

    F2 renames, Delete deletes, Alt with up and down moves; the same stands in the context menu.

    Signals:
        chosen: another item is current, a `Motion`; or `None`.
        delete_requested, duplicate_requested: of a `Motion`.
        move_requested: a `Motion`, and the row where it is to stand.
    """

    chosen = Signal(object)
    delete_requested = Signal(object)
    duplicate_requested = Signal(object)
    move_requested = Signal(object, int)

    def __init__(self, names: Names, empty: str, parent: QWidget | None = None) -> None:
        """Show `names`; `empty` is said where there are none."""
        super().__init__(parent)
        self._names = names
        self._empty = empty
        self._wanted: Motion | None = None
        self.setModel(names)
        self.setDragDropMode(QAbstractItemView.DragDropMode.InternalMove)
        self.setDefaultDropAction(Qt.DropAction.MoveAction)
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.SelectedClicked
        )
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.setTextElideMode(Qt.TextElideMode.ElideRight)
        self.setMinimumHeight(_LINES * (self.fontMetrics().height() + 6))
        self.rename_action = self._action(self.tr("Rename"), "F2")
        self.duplicate_action = self._action(self.tr("Duplicate"), "")
        self.delete_action = self._action(self.tr("Delete"), QKeySequence.StandardKey.Delete)
        self.up_action = self._action(self.tr("Move up"), "Alt+Up")
        self.down_action = self._action(self.tr("Move down"), "Alt+Down")

        self.rename_action.triggered.connect(self._on_rename)
        self.duplicate_action.triggered.connect(self._on_duplicate)
        self.delete_action.triggered.connect(self._on_delete)
        self.up_action.triggered.connect(self._on_up)
        self.down_action.triggered.connect(self._on_down)
        self.selectionModel().currentChanged.connect(self._on_current_changed)
        names.modelReset.connect(self._on_reset)
        names.dataChanged.connect(self._on_renewed)
        self._allow()

    def _action(self, text: str, shortcut: str | QKeySequence.StandardKey) -> QAction:
        action = QAction(text, self)
        action.setShortcut(QKeySequence(shortcut))
        action.setShortcutContext(Qt.ShortcutContext.WidgetShortcut)
        self.addAction(action)
        return action

    @property
    def current(self) -> Motion | None:
        """The item that is chosen."""
        return self._names.key(self.currentIndex().row())

    def choose(self, key: Motion | None) -> None:
        """Choose an item; one that is not there chooses none."""
        row = -1 if key is None else self._names.row(key)
        self.setCurrentIndex(self._names.index(row) if row >= 0 else QModelIndex())

    def choose_row(self, row: int) -> None:
        """Choose what stands in a row; beyond the end, the last."""
        self.choose(self._names.key(min(row, self._names.rowCount() - 1)))

    def drop_at(self, point: QPoint) -> None:
        """Let the current item be moved to where it was dropped."""
        key = self.current
        if key is None or key.built_in:
            return
        index, row = self.indexAt(point), self._names.rowCount()
        if index.isValid():
            row = index.row() + (point.y() > self.visualRect(index).center().y())
        self.move_requested.emit(key, row - (row > self._names.row(key)))

    # --- What Qt asks -------------------------------------------------------------------

    def dropEvent(self, event: QDropEvent) -> None:
        if event.source() is not self:
            event.ignore()
            return
        self.drop_at(event.position().toPoint())
        event.setDropAction(Qt.DropAction.CopyAction)  # of a move Qt would delete the row
        event.accept()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._names.rowCount() == 0:
            paint_empty(self, self._empty)

    # --- Slots --------------------------------------------------------------------------

    @Slot()
    def _on_rename(self) -> None:
        if self.rename_action.isEnabled():
            self.setFocus()
            self.edit(self.currentIndex())

    @Slot()
    def _on_duplicate(self) -> None:
        if self.current is not None:
            self.duplicate_requested.emit(self.current)

    @Slot()
    def _on_delete(self) -> None:
        if self.current is not None:
            self.delete_requested.emit(self.current)

    @Slot()
    def _on_up(self) -> None:
        self._move(-1)

    @Slot()
    def _on_down(self) -> None:
        self._move(1)

    def _move(self, by: int) -> None:
        key = self.current
        if key is not None and self._names.row(key) + by >= 0:
            self.move_requested.emit(key, self._names.row(key) + by)

    @Slot()
    def _on_current_changed(self) -> None:
        self._wanted = self.current
        self._allow()
        self.chosen.emit(self._wanted)

    @Slot()
    def _on_renewed(self) -> None:
        """A name has changed in its place: what is chosen is called otherwise."""
        if self.current != self._wanted:
            self._on_current_changed()

    @Slot()
    def _on_reset(self) -> None:
        """Keep what is chosen; where it is gone, nothing is."""
        wanted = self._wanted
        self.choose(wanted)
        if wanted is not None and self.current is None:
            self._on_current_changed()

    def _allow(self) -> None:
        key = self.current
        own = key is not None and not key.built_in
        for action in (self.rename_action, self.delete_action, self.up_action, self.down_action):
            action.setEnabled(own)
        self.duplicate_action.setEnabled(key is not None)


def paint_empty(view: QAbstractItemView, text: str) -> None:
    """Say in a view that has nothing to show what could stand there."""
    margin = view.fontMetrics().averageCharWidth()
    area: QRect = view.viewport().rect().adjusted(margin, margin, -margin, -margin)
    with QPainter(view.viewport()) as painter:
        painter.setPen(theme().color("muted"))
        flags = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
        painter.drawText(area, int(flags), text)
