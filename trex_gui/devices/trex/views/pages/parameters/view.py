"""The tree of parameters as a table with headings, used with the mouse or with keys alone."""

from collections.abc import Callable

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, Qt, Signal
from PySide6.QtGui import (
    QAction,
    QContextMenuEvent,
    QGuiApplication,
    QKeyEvent,
    QKeySequence,
    QPainter,
    QPalette,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QMenu,
    QStyleOptionViewItem,
    QTreeView,
    QWidget,
)

from trex_gui.devices.trex.model.parameters.parameters import Role
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.protocol.parameters import motor_name
from trex_gui.devices.trex.views.pages.parameters.delegate import ParameterDelegate, ResetDelegate
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilter
from trex_gui.ui.widgets.behaviour import name_headers
from trex_gui.ui.widgets.builders import action

Index = QModelIndex | QPersistentModelIndex

_PRESS = {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space, Qt.Key.Key_Select}
_WIDTHS = {
    ParameterColumn.NAME: 47,
    ParameterColumn.WIRE: 7,
    ParameterColumn.RESET: 5,
    ParameterColumn.DEFAULT: 16,
    ParameterColumn.RANGE: 26,
    ParameterColumn.SOURCE: 17,
    ParameterColumn.EFFECT: 14,
}
"""Widths in average characters; VALUE takes the rest."""


class ParameterView(QTreeView):
    """Spans headings and remembers closed groups; while rows are filtered every group is open.

    Signals:
        rejected: why the input is not a value, for the user.
    """

    rejected = Signal(str)

    def __init__(self, rows: ParameterFilter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows = rows
        self._model = rows.parameters
        self._closed: set[str] = set()
        self._arranging = False

        self.setObjectName("parametersView")
        self.setAccessibleName(self.tr("Parameters"))
        name_headers(self)
        self.setModel(rows)
        delegate = ParameterDelegate(self)
        delegate.rejected.connect(self.rejected)
        self.setItemDelegate(delegate)
        self.setItemDelegateForColumn(ParameterColumn.RESET, ResetDelegate(self))
        triggers = QAbstractItemView.EditTrigger
        self.setEditTriggers(
            self.editTriggers() | triggers.AnyKeyPressed | triggers.SelectedClicked
        )
        self.setAlternatingRowColors(True)
        self.setUniformRowHeights(True)
        self.setIndentation(16)
        self._set_up_header()
        self._set_up_menu()

        self.clicked.connect(self._on_clicked)
        self.doubleClicked.connect(self._on_double_clicked)
        self.collapsed.connect(self._on_collapsed)
        self.expanded.connect(self._on_expanded)

    def _set_up_header(self) -> None:
        header = self.header()
        header.setSectionsMovable(False)
        header.setStretchLastSection(False)
        header.setMinimumSectionSize(24)
        character = self.fontMetrics().averageCharWidth()
        for column, width in _WIDTHS.items():
            header.resizeSection(column, width * character)
        header.setSectionResizeMode(ParameterColumn.RESET, QHeaderView.ResizeMode.Fixed)
        header.setSectionResizeMode(ParameterColumn.VALUE, QHeaderView.ResizeMode.Stretch)

    # --- Groups -------------------------------------------------------------------------

    def arrange(self) -> None:
        """Span the headings, and open the groups that the user has not closed.

        The group of the current row stays open after a search.
        """
        self._arranging = True
        self._closed.discard(str(self.currentIndex().parent().data(Role.GROUP)))
        for row in range(self._rows.rowCount()):
            heading = self._rows.index(row, 0)
            self.setFirstColumnSpanned(row, QModelIndex(), True)
            is_open = self._rows.is_narrowed or heading.data(Role.GROUP) not in self._closed
            self.setExpanded(heading, is_open)
        self._arranging = False

    def _on_collapsed(self, heading: QModelIndex) -> None:
        if self._arranging:
            return
        self._closed.add(str(heading.data(Role.GROUP)))
        if self.currentIndex().parent() == heading:
            self.setCurrentIndex(heading)  # a row that is not seen must not be edited

    def _on_expanded(self, heading: QModelIndex) -> None:
        if not self._arranging:
            self._closed.discard(str(heading.data(Role.GROUP)))

    # --- Mouse and keys -----------------------------------------------------------------

    @property
    def current_key(self) -> str:
        """The parameter of the current row; empty on a heading."""
        spec = self.currentIndex().data(Role.SPEC)
        return "" if spec is None else str(spec.key)

    def _begin_edit(self, key: str) -> None:
        value = self._rows.index_of(key)
        self.setCurrentIndex(value)
        self.edit(value)

    def _on_clicked(self, index: QModelIndex) -> None:
        if index.column() == ParameterColumn.RESET:
            self._press_reset()

    def _on_double_clicked(self, index: QModelIndex) -> None:
        is_other = index.column() not in {ParameterColumn.VALUE, ParameterColumn.RESET}
        if is_other and index.data(Role.SPEC) is not None:
            self._begin_edit(self.current_key)

    def _press_reset(self) -> None:
        if self.currentIndex().data(Role.RESET):
            self._model.reset(self.current_key)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Let keys reach value and default of a row from any of its columns."""
        current = self.currentIndex()
        if self.state() is QAbstractItemView.State.EditingState:
            super().keyPressEvent(event)
        elif current.data(Role.GROUP) is not None and event.key() in _PRESS:
            self.setExpanded(current, not self.isExpanded(current))
        elif not self.current_key:
            super().keyPressEvent(event)
        elif not self._act(current, event):
            typed = event.text()
            if event.key() == Qt.Key.Key_F2 or (typed and typed.isprintable()):
                self.setCurrentIndex(current.siblingAtColumn(ParameterColumn.VALUE))
            super().keyPressEvent(event)

    def _act(self, current: QModelIndex, event: QKeyEvent) -> bool:
        """Handle a key in the row of a parameter; return whether it was handled."""
        at_reset = current.column() == ParameterColumn.RESET
        match event.key():
            case key if key in _PRESS and at_reset:
                self._press_reset()
            case key if key in _PRESS:
                self._begin_edit(self.current_key)
            case Qt.Key.Key_Right if not at_reset and current.data(Role.RESET):
                self.setCurrentIndex(current.siblingAtColumn(ParameterColumn.RESET))
            case Qt.Key.Key_Left if at_reset:
                self.setCurrentIndex(current.siblingAtColumn(ParameterColumn.VALUE))
            case _:
                return False
        return True

    # --- Context menu -------------------------------------------------------------------

    def _set_up_menu(self) -> None:
        model, copy = self._model, QKeySequence.StandardKey.Copy
        self._edit = self._action("editParameter", self._begin_edit, self.tr("Edit"))
        self._reset = self._action(
            "resetParameter", model.reset, icon="default", shortcut="Ctrl+Backspace"
        )
        self._restore = self._action("restoreParameter", model.restore)
        self._leave_out = self._action(
            "leaveOutParameter", model.leave_out, self.tr("Leave out of the file")
        )
        self._to_other_motor = self._action("copyToOtherMotor", model.copy_to_other_motor)
        self._copy = self._action("copyParameter", self._copy_line, icon="copy", shortcut=copy)
        self._menu = QMenu(self)
        self._menu.setObjectName("parameterMenu")
        self._menu.addAction(self._edit)
        self._menu.addSeparator()
        self._menu.addActions([self._reset, self._restore, self._leave_out, self._to_other_motor])
        self._menu.addSeparator()
        self._menu.addAction(self._copy)
        self.addActions([self._reset, self._copy])

    def _action(
        self,
        name: str,
        act: Callable[[str], None],
        text: str = "",
        *,
        icon: str = "",
        shortcut: QKeySequence.StandardKey | str = "",
    ) -> QAction:
        """Create an action that calls `act` with the key of the current row."""

        def on_trigger() -> None:
            if self.current_key and self.isEnabled():
                act(self.current_key)

        context = Qt.ShortcutContext.WidgetShortcut
        return action(
            self, name, text, icon=icon, shortcut=shortcut, context=context, on_trigger=on_trigger
        )

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Open the menu of the row under the mouse, or with the menu key of the current one."""
        index, place = self.indexAt(event.pos()), event.pos()
        if event.reason() is QContextMenuEvent.Reason.Keyboard:
            index = self.currentIndex()
            place = self.visualRect(index).center()
        if index.data(Role.SPEC) is not None:
            if index.siblingAtColumn(0) != self.currentIndex().siblingAtColumn(0):
                self.setCurrentIndex(index)
            self._prepare_menu()
            self._menu.popup(self.viewport().mapToGlobal(place))

    def _prepare_menu(self) -> None:
        """Describe the effect of each action; disable or hide those without one."""
        model, key = self._model, self.current_key
        spec, stored, value = model.spec_of(key), model.stored_of(key), model.value_of(key)
        self._edit.setEnabled(model.can_edit(key))
        self._reset.setText(model.text.reset(spec))
        self._reset.setEnabled(self.currentIndex().data(Role.RESET) is not None)
        restore = self.tr("Restore stored value")
        if stored is not None:
            restore = f"{restore}: {model.text.with_wire(spec, stored)}"
        self._restore.setText(restore)
        self._restore.setEnabled(model.is_modified(key))
        self._leave_out.setVisible(model.can_leave_out(key))
        other_motor = model.other_motor_of(key)
        self._to_other_motor.setVisible(other_motor is not None)
        if other_motor is not None:
            self._to_other_motor.setText(self.tr("Copy to {0}").format(motor_name(other_motor)))
            self._to_other_motor.setEnabled(value not in {None, model.value_of(other_motor)})
        self._copy.setText(self.tr("Copy as “{0}”").format(f"{key}: {value}"))
        self._copy.setEnabled(value is not None)

    def _copy_line(self, key: str) -> None:
        """Copy the parameter as a line of a settings file."""
        value = self._model.value_of(key)
        if value is not None:
            QGuiApplication.clipboard().setText(f"{key}: {value}")

    # --- Painting -----------------------------------------------------------------------

    def drawRow(  # noqa: N802 # of Qt
        self, painter: QPainter, option: QStyleOptionViewItem, index: Index
    ) -> None:
        """Paint the background of headings from one edge to the other."""
        if not index.parent().isValid():
            palette = QPalette(option.palette)
            shade = palette.brush(QPalette.ColorRole.Button)
            palette.setBrush(QPalette.ColorRole.AlternateBase, shade)
            option.palette = palette
            painter.fillRect(option.rect, shade)
        super().drawRow(painter, option, index)
