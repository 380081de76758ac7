"""A list of poses or sequences that is edited in place, and its buttons."""

from PySide6.QtCore import QModelIndex, QPoint, Qt, Signal, Slot
from PySide6.QtGui import QAction, QDropEvent, QPaintEvent
from PySide6.QtWidgets import QAbstractItemView, QListView, QToolButton, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.library import ItemKey, ItemKind, Library
from trex_gui.devices.aracna.model.pose_models import NameModel
from trex_gui.devices.aracna.poses.gaits import Gait
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import paint_placeholder

_LINES = 4


class NameList(QListView):
    """Edits poses or sequences: rename (F2), delete (Del), duplicate, move (Alt+arrows, drag)."""

    chosen = Signal()  # another item is current

    def __init__(
        self,
        library: Library,
        kind: ItemKind,
        notifier: Notifier,
        empty: str,
        parent: QWidget | None = None,
    ) -> None:
        """Show the items of one kind; `empty` is shown while there are none."""
        super().__init__(parent)
        self._library = library
        self._kind = kind
        self._model = model = NameModel(library, kind, notifier, self)
        self._empty = empty
        self._chosen: ItemKey | None = None
        self.setModel(model)
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
        self._rename = self._action(tr("Rename"), "F2", self.edit_name)
        self._duplicate = self._action(tr("Duplicate"), "", self._on_duplicate, "copy")
        self._delete = self._action(tr("Delete"), "Del", self._on_delete, "clear")
        self._up = self._action(tr("Move up"), "Alt+Up", lambda: self._move(-1))
        self._down = self._action(tr("Move down"), "Alt+Down", lambda: self._move(1))

        self.selectionModel().currentChanged.connect(self._on_current_changed)
        model.modelReset.connect(self._on_reset)
        model.dataChanged.connect(self._on_data_changed)
        self._update_actions()

    def _action(self, text: str, shortcut: str, slot: ui.Trigger, icon: str = "") -> QAction:
        context = Qt.ShortcutContext.WidgetShortcut
        action = ui.action(
            self, "", text, icon=icon, shortcut=shortcut, context=context, on_trigger=slot
        )
        self.addAction(action)
        return action

    def buttons(self, parent: QWidget) -> list[QToolButton]:
        """Create buttons for the actions on the current item."""
        kind = "Pose" if self._kind is ItemKind.POSE else "Sequence"
        arrows = Qt.ArrowType
        buttons = []
        for action, name, arrow in (
            (self._duplicate, f"aracnaDuplicate{kind}", arrows.NoArrow),
            (self._delete, f"aracnaDelete{kind}", arrows.NoArrow),
            (self._up, f"aracna{kind}Up", arrows.UpArrow),
            (self._down, f"aracna{kind}Down", arrows.DownArrow),
        ):
            button = small_button(parent, name, action.text(), arrow=arrow)
            button.setDefaultAction(action)
            buttons.append(button)
        return buttons

    @property
    def current(self) -> ItemKey | None:
        return self._model.key(self.currentIndex().row())

    def choose(self, key: ItemKey | None) -> None:
        """Make an item current; none if it is not in the list."""
        row = -1 if key is None else self._model.row(key)
        self.setCurrentIndex(self._model.index(row) if row >= 0 else QModelIndex())

    def choose_and_edit(self, name: str) -> None:
        self.choose(ItemKey(name))
        self.edit_name()

    @Slot()
    def edit_name(self) -> None:
        if self._rename.isEnabled():
            self.setFocus()
            self.edit(self.currentIndex())

    def drop_at(self, point: QPoint) -> None:
        """Move the current item to where it was dropped."""
        key = self.current
        if key is None or key.built_in:
            return
        index, row = self.indexAt(point), self._model.rowCount()
        if index.isValid():
            row = index.row() + (point.y() > self.visualRect(index).center().y())
        self._move_to(key, row - (row > self._model.row(key)))

    def dropEvent(self, event: QDropEvent) -> None:
        if event.source() is not self:
            event.ignore()
            return
        self.drop_at(event.position().toPoint())
        event.setDropAction(Qt.DropAction.CopyAction)  # after a move Qt would delete the row
        event.accept()

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self._model.rowCount() == 0:
            paint_placeholder(self, self._empty)

    @Slot()
    def _on_duplicate(self) -> None:
        if (key := self.current) is None:
            return
        gait = self._library.playable(key) if key.built_in else None
        if isinstance(gait, Gait):
            name = self._library.add_gait(gait)
        else:
            name = self._library.duplicate(self._kind, key.name)
        self.choose(ItemKey(name))

    @Slot()
    def _on_delete(self) -> None:
        """Delete the current item; the next one can be deleted as well."""
        if (key := self.current) is not None and not key.built_in:
            row = self.currentIndex().row()
            self._library.delete(self._kind, key.name)
            self.choose(self._model.key(min(row, self._model.rowCount() - 1)))

    def _move(self, by: int) -> None:
        key = self.current
        if key is not None and not key.built_in and self._model.row(key) + by >= 0:
            self._move_to(key, self._model.row(key) + by)

    def _move_to(self, key: ItemKey, row: int) -> None:
        self._library.move(self._kind, key.name, row)
        self.choose(key)

    @Slot()
    def _on_current_changed(self) -> None:
        self._chosen = self.current
        self._update_actions()
        self.chosen.emit()

    @Slot()
    def _on_data_changed(self) -> None:
        """Notice that the current item was renamed."""
        if self.current != self._chosen:
            self._on_current_changed()

    @Slot()
    def _on_reset(self) -> None:
        """Keep the current item, unless it is gone."""
        chosen = self._chosen
        self.choose(chosen)
        if chosen is not None and self.current is None:
            self._on_current_changed()

    def _update_actions(self) -> None:
        key = self.current
        for action in (self._rename, self._delete, self._up, self._down):
            action.setEnabled(key is not None and not key.built_in)
        self._duplicate.setEnabled(key is not None)


def small_button(
    parent: QWidget,
    name: str,
    tip: str = "",
    *,
    text: str = "",
    icon: str = "",
    arrow: Qt.ArrowType = Qt.ArrowType.NoArrow,
    on_click: ui.Handler | None = None,
) -> QToolButton:
    """Create a tool button that takes the focus when it is clicked."""
    button = ui.tool_button(
        parent, name, text, icon=icon, tip=tip, accessible=tip, on_click=on_click
    )
    button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    button.setArrowType(arrow)
    return button
