"""Table of parameters for mouse and keyboard."""

from collections.abc import Callable
from dataclasses import dataclass
from enum import IntEnum, auto

from PySide6.QtCore import QEvent, QModelIndex, QPoint, Qt, Signal, Slot
from PySide6.QtGui import (
    QAction,
    QContextMenuEvent,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QMouseEvent,
    QResizeEvent,
    QShowEvent,
)
from PySide6.QtWidgets import QAbstractItemView, QMenu, QTableView, QWidget

from trex_gui.core.texts import title_of
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.parameters.parameters import ParameterModel, ParameterRole
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.views.pages.parameters.editors import ParameterDelegate
from trex_gui.ui.theme.theme import follow_theme, set_look
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import ENTER, only_when_visible

_EDIT_KEYS = ENTER | {Qt.Key.Key_Space, Qt.Key.Key_Select}
_MIN_NAME_WIDTH = 20  # minimum width of the name column in characters


class ParameterChoice(IntEnum):
    ALL = 0
    CHANGED = auto()
    NOT_DEFAULT = auto()
    WITH_FINDINGS = auto()


@dataclass(frozen=True, slots=True)
class ParameterFilter:
    words: tuple[str, ...] = ()  # in lower case, searched for in names, keys and descriptions
    shown: ParameterChoice = ParameterChoice.ALL
    finding_keys: frozenset[str] = frozenset()  # keys of parameters with a linter finding

    def rows(self, model: ParameterModel) -> list[int]:
        rows: list[int] = []
        heading: list[int] = []
        for number, row in enumerate(model.rows):
            if not row.keys:
                heading = [number]
            elif self._accepts(model, row.keys):
                rows += [*heading, number]
                heading = []
        return rows

    def best_match(self, model: ParameterModel) -> QModelIndex:
        """Return the first visible value whose name contains all words, or else the first value."""
        keys = [keys[0] for row in self.rows(model) if (keys := model.rows[row].keys)]
        names = ((key, model.text.title(key).casefold()) for key in keys)
        named = (key for key, name in names if all(word in name for word in self.words))
        return model.index_of(next(named, keys[0] if keys else ""))

    def _accepts(self, model: ParameterModel, keys: tuple[str, ...]) -> bool:
        values = model.values
        members = [member for key in keys for member in model.text.keys_of(key)]
        is_shown = {
            ParameterChoice.CHANGED: values.is_modified,
            ParameterChoice.NOT_DEFAULT: values.differs_from_default,
            ParameterChoice.WITH_FINDINGS: self.finding_keys.__contains__,
        }.get(self.shown)
        if is_shown is not None and not any(map(is_shown, members)):
            return False
        specs = [values.specs[key] for key in members]
        texts = [text for spec in specs for text in (spec.name, spec.key, spec.description)]
        searched = " ".join((*texts, *map(model.text.title, keys))).casefold()
        return all(word in searched for word in self.words)


class ParameterView(QTableView):
    """Table of values. Selecting a name selects the first value in its row."""

    wire_value_requested = Signal()  # the user requests the field for wire values

    def __init__(self, model: ParameterModel, parent: QWidget) -> None:
        super().__init__(parent)
        self.filter = ParameterFilter()
        self._visible: list[int] = []  # row numbers
        self._model = model
        ui.flat_table(self, "parametersView", tr("Parameters"))
        self.setModel(model)
        self.setItemDelegate(ParameterDelegate(model, self.has_finding, self))
        self.setAlternatingRowColors(False)
        set_look(self, "card")
        behavior, triggers = QAbstractItemView.SelectionBehavior, QAbstractItemView.EditTrigger
        self.setSelectionBehavior(behavior.SelectItems)
        typed = triggers.EditKeyPressed | triggers.AnyKeyPressed
        self.setEditTriggers(triggers.DoubleClicked | typed)
        self.setWordWrap(False)
        self.horizontalHeader().setStretchLastSection(True)
        self.horizontalHeader().setMinimumSectionSize(1)
        self._set_up_menu()
        follow_theme(self, "columns", self._fit_columns)
        model.modelReset.connect(self._span_rows)
        model.dataChanged.connect(self._fit_columns)
        self._span_rows()

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit_columns()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._fit_columns()

    @Slot()
    @only_when_visible
    def _fit_columns(self) -> None:
        """Fit the name column to its texts. The values of both motors have priority."""
        total, index, width = self.viewport().width(), self._model.index, self.sizeHintForIndex
        names, values = [0], [0]
        for number, row in enumerate(self._model.rows):
            names += [width(index(number, ParameterColumn.NAME)).width()] if row.keys else []
            both = range(1, 3 if len(row.keys) > 1 else 0)
            values += [width(index(number, column)).width() for column in both]
        minimum = _MIN_NAME_WIDTH * self.fontMetrics().averageCharWidth()
        name = max(min(max(names), total - 2 * max(values)), minimum)
        self.setColumnWidth(ParameterColumn.NAME, name)
        for motor in (ParameterColumn.MOTOR1, ParameterColumn.MOTOR2):
            self.setColumnWidth(motor, (total - name) // 2)

    @Slot()
    def _span_rows(self) -> None:
        """Extend headings and board-wide values over several columns."""
        self._visible = list(range(len(self._model.rows)))
        self.clearSpans()
        for number, row in enumerate(self._model.rows):
            if len(row.keys) < 2:
                self.setSpan(number, len(row.keys), 1, len(ParameterColumn) - len(row.keys))
        self._fit_columns()

    def show_rows(self, new_filter: ParameterFilter) -> bool:
        """Show the matching rows. Return true if they changed or if the current row is hidden."""
        self.filter, before = new_filter, self._visible
        self._visible = new_filter.rows(self._model)
        for row in range(len(self._model.rows)):
            self.setRowHidden(row, row not in self._visible)
        return self._visible != before or self.is_hidden(self.currentIndex())

    def is_hidden(self, index: QModelIndex) -> bool:
        return not index.isValid() or index.row() not in self._visible

    def has_finding(self, key: str) -> bool:
        return not self.filter.finding_keys.isdisjoint(self._model.text.keys_of(key))

    @property
    def current_key(self) -> str:
        return str(self.currentIndex().data(ParameterRole.KEY) or "")

    def indexAt(self, pos: QPoint) -> QModelIndex:  # noqa: N802 # of Qt
        return _value_at(super().indexAt(pos))

    def moveCursor(  # noqa: N802 # of Qt
        self, action: QAbstractItemView.CursorAction, modifiers: Qt.KeyboardModifier
    ) -> QModelIndex:
        current, actions = self.currentIndex(), QAbstractItemView.CursorAction
        if not current.isValid():
            return self.filter.best_match(self._model)
        target = super().moveCursor(action, modifiers)
        if action is actions.MovePrevious and _value_at(target) == current:
            target = super().moveCursor(actions.MoveUp, modifiers)
            if target.row() < current.row() and len(self._model.rows[target.row()].keys) > 1:
                target = target.siblingAtColumn(ParameterColumn.MOTOR2)
        return _value_at(target)

    def _start_edit(self, key: str) -> None:
        value = self._model.index_of(key)
        self.setCurrentIndex(value)
        self.edit(value)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        super().mousePressEvent(event)
        if self.indexAt(event.position().toPoint()).data(ParameterRole.KEY) is None:
            self.setCurrentIndex(QModelIndex())  # otherwise keys would edit the previous cell

    def keyPressEvent(self, event: QKeyEvent) -> None:
        is_editing = self.state() is QAbstractItemView.State.EditingState
        if self.current_key and event.key() in _EDIT_KEYS and not is_editing:
            self._start_edit(self.current_key)
        else:
            super().keyPressEvent(event)

    def _set_up_menu(self) -> None:
        model, copy = self._model, QKeySequence.StandardKey.Copy
        self._edit = self._action("editParameter", self._start_edit, tr("Edit"))
        text, request = tr("Try another &wire value…"), self.wire_value_requested.emit
        self._try = self._action("tryParameter", lambda _key: request(), text)
        keys, leave_out = "Ctrl+Backspace", title_of(tr("Leave out of the fi&le"))
        self._reset = self._action("resetParameter", model.reset, icon="default", shortcut=keys)
        text = tr("Und&o edit")
        self._restore = self._action("restoreParameter", model.restore, text, icon="undo")
        self._leave_out = self._action("leaveOutParameter", model.remove, leave_out)
        self._copy = self._action("copyParameter", self._copy_line, icon="copy", shortcut=copy)
        self._restore.setIconText(text)
        self._reset.setIconText(tr("Defa&ult"))
        self._menu = QMenu(self)
        self._menu.setObjectName("parameterMenu")
        self._menu.addActions([self._edit, self._try])
        self._menu.addSeparator()
        self._menu.addActions([self._reset, self._restore, self._leave_out])
        self._menu.addSeparator()
        self._menu.addAction(self._copy)
        self.addActions([self._reset, self._copy])
        self.update_actions()

    @property
    def tools(self) -> tuple[QAction, ...]:
        return self._reset, self._restore

    def _action(
        self,
        name: str,
        handler: Callable[[str], None],
        text: str = "",
        *,
        icon: str = "",
        shortcut: QKeySequence.StandardKey | str = "",
    ) -> QAction:
        def on_trigger() -> None:
            if self.current_key:
                handler(self.current_key)

        context = Qt.ShortcutContext.WidgetShortcut
        return ui.action(
            self, name, text, icon=icon, shortcut=shortcut, context=context, on_trigger=on_trigger
        )

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        index, position = self.indexAt(event.pos()), event.pos()
        if event.reason() is QContextMenuEvent.Reason.Keyboard:
            index = self.currentIndex()
            position = self.visualRect(index).center()
        if index.data(ParameterRole.KEY) is not None:
            self.setCurrentIndex(index)
            self._menu.popup(self.viewport().mapToGlobal(position))

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.EnabledChange:
            self.update_actions()

    def update_actions(self) -> None:
        """Update texts and states of the actions for the current parameter."""
        model, key = self._model, self.current_key
        for action in self.tools:
            action.setVisible(bool(key))
        if not key:
            return
        can_edit = self.isEnabled()
        self._edit.setEnabled(can_edit and model.is_editable(key))
        self._try.setVisible(model.key_with_open_values(key) is not None)
        self._try.setEnabled(can_edit)
        self._reset.setText(model.text.reset(key))
        data = self.currentIndex().data
        self._reset.setEnabled(can_edit and data(ParameterRole.RESET) is not None)
        self._restore.setEnabled(can_edit and bool(data(ParameterRole.DIRTY)))
        self._leave_out.setVisible(model.values.can_remove(key))
        lines = self._lines(key)
        self._copy.setText(tr("Copy as “{0}”").format(", ".join(lines)))
        self._copy.setEnabled(bool(lines))

    def _lines(self, key: str) -> list[str]:
        keys, value_of = self._model.text.keys_of(key), self._model.values.value_of
        wires = {member: value_of(member) for member in keys}
        return [f"{member}: {wire}" for member, wire in wires.items() if wire is not None]

    def _copy_line(self, key: str) -> None:
        if lines := self._lines(key):
            QGuiApplication.clipboard().setText("\n".join(lines))


def _value_at(index: QModelIndex) -> QModelIndex:
    """Return the first value in the row of a name. Other indexes are returned unchanged."""
    is_name = index.column() == ParameterColumn.NAME and index.data(ParameterRole.KEY) is not None
    return index.siblingAtColumn(ParameterColumn.MOTOR1) if is_name else index
