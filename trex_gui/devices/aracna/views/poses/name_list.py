"""Editable list of poses or sequences, and its buttons."""

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtGui import QAction, QPaintEvent
from PySide6.QtWidgets import QAbstractItemView, QListWidget, QListWidgetItem, QToolButton, QWidget

from trex_gui.core.errors import BadRequest
from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.aracna.model.library import ItemKey, ItemKind, Library
from trex_gui.devices.aracna.poses.gaits import GAITS, Gait
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import paint_placeholder

_LINES = 3  # minimum height, in rows


class NameList(QListWidget):
    """Editable list of poses or sequences. Built-in gaits follow the sequences.

    F2 renames an item, Del deletes it, and Alt with an arrow key moves it.
    """

    current_changed = Signal()

    def __init__(
        self,
        library: Library,
        kind: ItemKind,
        notifier: Notifier,
        placeholder: str,
        parent: QWidget | None = None,
    ) -> None:
        """`placeholder`: text in an empty list."""
        super().__init__(parent)
        self._library = library
        self._kind = kind
        self._notifier = notifier
        self._placeholder = placeholder
        self._keys: list[ItemKey] = []
        self._last_current: ItemKey | None = None
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.SelectedClicked
        )
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setContextMenuPolicy(Qt.ContextMenuPolicy.ActionsContextMenu)
        self.setTextElideMode(Qt.TextElideMode.ElideRight)
        self.setMinimumHeight(_LINES * (self.fontMetrics().height() + 6))
        self._rename = row_action(self, tr("Rename"), "F2", self.edit_name)
        self._duplicate = row_action(self, tr("Duplicate"), "", self._on_duplicate, "copy")
        self._delete = row_action(self, title_of(tr("&Delete…")), "Del", self._on_delete, "clear")
        self._up = row_action(self, tr("Move up"), "Alt+Up", lambda: self._move(-1))
        self._down = row_action(self, tr("Move down"), "Alt+Down", lambda: self._move(1))

        self.selectionModel().currentChanged.connect(self._on_current_changed)
        self.itemChanged.connect(self._on_renamed)
        library.changed.connect(self._show_names)
        self._show_names()
        self._update_actions()

    def buttons(self, parent: QWidget) -> list[QToolButton]:
        kind = "Pose" if self._kind is ItemKind.POSE else "Sequence"
        return [
            action_button(parent, f"aracnaDuplicate{kind}", self._duplicate),
            action_button(parent, f"aracnaDelete{kind}", self._delete),
            action_button(parent, f"aracna{kind}Up", self._up, Qt.ArrowType.UpArrow),
            action_button(parent, f"aracna{kind}Down", self._down, Qt.ArrowType.DownArrow),
        ]

    @property
    def current(self) -> ItemKey | None:
        row = self.currentRow()
        return self._keys[row] if 0 <= row < len(self._keys) else None

    def select(self, key: ItemKey | None) -> None:
        self.setCurrentRow(self._keys.index(key) if key in self._keys else -1)

    def select_and_edit(self, name: str) -> None:
        self.select(ItemKey(name))
        self.edit_name()

    @Slot()
    def edit_name(self) -> None:
        if self._rename.isEnabled():
            self.setFocus()
            self.edit(self.currentIndex())

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.count() == 0:
            paint_placeholder(self, self._placeholder)

    @Slot()
    def _on_duplicate(self) -> None:
        if (key := self.current) is None:
            return
        gait = self._library.playable(key) if key.built_in else None
        if isinstance(gait, Gait):
            name = self._library.add_gait(gait)
        else:
            name = self._library.duplicate(self._kind, key.name)
        self.select(ItemKey(name))

    @Slot()
    def _on_delete(self) -> None:
        if (key := self.current) is not None and not key.built_in:
            row = self.currentRow()
            self._library.delete(self._kind, key.name)
            self.setCurrentRow(min(row, self.count() - 1))

    def _move(self, offset: int) -> None:
        key, row = self.current, self.currentRow() + offset
        if key is not None and not key.built_in and row >= 0:
            self._library.move(self._kind, key.name, row)

    @Slot()
    def _on_current_changed(self) -> None:
        self._last_current = self.current
        self._update_actions()
        self.current_changed.emit()

    @Slot(QListWidgetItem)
    def _on_renamed(self, item: QListWidgetItem) -> None:
        name = self._keys[self.row(item)].name
        try:
            self._library.rename(self._kind, name, item.text())
        except BadRequest as error:
            self._notifier.error.emit(tr("Not renamed: {0}.").format(error))
        self._show_names()  # the library may have rejected or trimmed the name

    @Slot()
    def _show_names(self) -> None:
        """Show the library's items. The current item stays current if possible."""
        keys, current = self._keys_in_library(), self._last_current
        with QSignalBlocker(self):
            is_renamed = len(keys) == len(self._keys) and current not in keys
            self._keys = keys
            while self.count() < len(keys):
                self.addItem("")
            while self.count() > len(keys):
                self.takeItem(self.count() - 1)
            for row, key in enumerate(keys):
                self._show_item(self.item(row), key)
            if not is_renamed:
                self.select(current)
        if self.current != current:
            self._on_current_changed()

    def _keys_in_library(self) -> list[ItemKey]:
        if self._kind is ItemKind.POSE:
            return [ItemKey(name) for name in self._library.project.pose_names]
        sequences = [ItemKey(sequence.name) for sequence in self._library.project.sequences]
        return sequences + [ItemKey(gait.name, built_in=True) for gait in GAITS]

    def _show_item(self, item: QListWidgetItem, key: ItemKey) -> None:
        flags = Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable
        if not key.built_in:
            flags |= Qt.ItemFlag.ItemIsEditable
        item.setFlags(flags)
        item.setText(tr("{0} (built in)").format(key.name) if key.built_in else key.name)
        item.setToolTip(ui.plain(self._about(key)))

    def _about(self, key: ItemKey) -> str:
        gait = self._library.playable(key) if key.built_in else None
        if not isinstance(gait, Gait):
            return ""
        ours = tr("Uses the authors' poses, but was not made by them.")
        return f"{tr(gait.about)} {ours}" if gait.ours else tr(gait.about)

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
    on_click: ui.Handler | None = None,
) -> QToolButton:
    """Create a tool button that gets the focus when clicked."""
    button = ui.tool_button(
        parent, name, text, icon=icon, tip=tip, accessible=tip, on_click=on_click
    )
    button.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    return button


def row_action(
    view: QAbstractItemView, text: str, shortcut: str, slot: ui.Trigger, icon: str = ""
) -> QAction:
    context = Qt.ShortcutContext.WidgetShortcut
    added = ui.action(
        view, "", text, icon=icon, shortcut=shortcut, context=context, on_trigger=slot
    )
    view.addAction(added)
    return added


def action_button(
    parent: QWidget, name: str, action: QAction, arrow: Qt.ArrowType = Qt.ArrowType.NoArrow
) -> QToolButton:
    button = small_button(parent, name, action.text())
    button.setArrowType(arrow)
    button.setDefaultAction(action)
    return button
