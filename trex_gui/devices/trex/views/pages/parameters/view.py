"""The tree of parameters as a table with headings, used with the mouse or with keys alone."""

from collections.abc import Callable
from typing import cast

from PySide6.QtCore import (
    QAbstractItemModel,
    QEvent,
    QModelIndex,
    QObject,
    QPoint,
    QRect,
    QSize,
    Qt,
    Slot,
)
from PySide6.QtGui import (
    QAction,
    QContextMenuEvent,
    QGuiApplication,
    QIcon,
    QKeyEvent,
    QKeySequence,
    QPainter,
    QPalette,
    QResizeEvent,
)
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QMenu,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTreeView,
    QWidget,
)

from trex_gui.devices.trex.model.parameters.parameters import Index, ParameterModel, Role
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.protocol.parameters import ParameterSpec, motor_name
from trex_gui.devices.trex.views.count_editor import UnitDelegate
from trex_gui.devices.trex.views.pages.parameters.editors import Editor, NumberEditor, editor_for
from trex_gui.devices.trex.views.pages.parameters.filters import ParameterFilter
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.behaviour import name_headers
from trex_gui.ui.widgets.builders import action

_PRESS = {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space, Qt.Key.Key_Select}
_WIDTHS = {
    ParameterColumn.WIRE: 7,
    ParameterColumn.RESET: 5,
    ParameterColumn.DEFAULT: 16,
    ParameterColumn.RANGE: 26,
    ParameterColumn.SOURCE: 17,
    ParameterColumn.EFFECT: 14,
}
_NAME, _VALUE, _RANGE_MORE = (36, 50), (22, 44), 30
"""Widths in average characters: least and greatest of two columns, and what the range may gain."""

_ICON = 16
_ROOM = 12
_ENTER = {Qt.Key.Key_Return, Qt.Key.Key_Enter}
_UNTOUCHED = "untouched"


class ParameterDelegate(UnitDelegate):
    """Paints and edits the rows of a `ParameterModel`.

    Where no value is given, the editor shows the default, which becomes the value only when
    something is typed or chosen, or with Enter.
    """

    def __init__(self, model: ParameterModel, parent: QWidget) -> None:
        super().__init__(parent)
        self._model = model

    # --- Editing ------------------------------------------------------------------------

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        del option
        spec = cast("ParameterSpec", index.data(Role.SPEC))
        editor = editor_for(spec, parent)
        editor.setAccessibleName(spec.name)
        editor.setProperty(_UNTOUCHED, index.data(Qt.ItemDataRole.EditRole) is None)

        def on_touched() -> None:
            editor.setProperty(_UNTOUCHED, False)
            if not isinstance(editor, NumberEditor):
                self.commitData.emit(editor)  # a number is an edit with Enter

        editor.valueChanged.connect(on_touched)
        if isinstance(editor, NumberEditor):
            editor.rejected.connect(self._model.rejected)
            editor.lineEdit().textEdited.connect(on_touched)
        return editor

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Let Enter take the value shown."""
        is_press = event.type() == QEvent.Type.KeyPress
        if is_press and isinstance(event, QKeyEvent) and event.key() in _ENTER:
            watched.setProperty(_UNTOUCHED, False)
        return super().eventFilter(watched, event)

    def setEditorData(self, editor: QWidget, index: Index) -> None:
        if isinstance(editor, NumberEditor) and editor.lineEdit().isModified():
            return  # the row has changed while something is typed
        wire = index.data(Qt.ItemDataRole.EditRole)
        spec = cast("ParameterSpec", index.data(Role.SPEC))
        untouched = editor.property(_UNTOUCHED)
        cast("Editor", editor).setValue(spec.default if wire is None else wire)
        editor.setProperty(_UNTOUCHED, untouched)  # not changed by the user

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: Index) -> None:
        if not editor.property(_UNTOUCHED):
            model.setData(index, cast("Editor", editor).value(), Qt.ItemDataRole.EditRole)

    def updateEditorGeometry(
        self, editor: QWidget, option: QStyleOptionViewItem, index: Index
    ) -> None:
        """Give an editor the size that it needs; it may cover neighbouring cells."""
        super().updateEditorGeometry(editor, option, index)
        place = editor.geometry()
        middle = place.center().y()
        place.setSize(place.size().expandedTo(editor.sizeHint()))
        place.moveCenter(QPoint(place.center().x(), middle))
        view = editor.parentWidget()
        if view is not None and place.right() > view.width():
            place.moveRight(max(place.width(), view.width()) - 1)
        editor.setGeometry(place)

    # --- Painting -----------------------------------------------------------------------

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        """Give every row the same height, with or without an icon."""
        size = super().sizeHint(option, index)
        size.setHeight(option.fontMetrics.height() + _ROOM)
        return size

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        match index.column():
            case ParameterColumn.NAME:
                self._show_name(option, index)
            case ParameterColumn.VALUE | ParameterColumn.WIRE:
                if index.data(Role.DIRTY):
                    _embolden(option)
                if index.data(Qt.ItemDataRole.EditRole) is None:
                    _mute(option)
            case ParameterColumn.SOURCE:
                spec = index.data(Role.SPEC)
                if spec is not None and not (spec.limits_confirmed and spec.default_confirmed):
                    _mute(option)

    def _show_name(self, option: QStyleOptionViewItem, index: Index) -> None:
        """Embolden headings and edited rows; show the most important state as an icon."""
        dirty = bool(index.data(Role.DIRTY))
        if dirty or index.data(Role.GROUP) is not None:
            _embolden(option)
        if index.data(Role.PROBLEM):
            name = "warning"
        elif dirty:
            name = "edited"
        elif index.data(Role.WAITING) is not None:
            name = "power"
        else:
            return
        option.icon = icon(name)
        option.features |= QStyleOptionViewItem.ViewItemFeature.HasDecoration


class ResetDelegate(QStyledItemDelegate):
    """Paints the reset button; framed while it has the keyboard focus."""

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        super().paint(painter, option, index)
        if not index.data(Role.RESET):
            return
        place = QRect(0, 0, _ICON, _ICON)
        place.moveCenter(option.rect.center())
        mode = QIcon.Mode.Normal
        if not option.state & QStyle.StateFlag.State_Enabled:
            mode = QIcon.Mode.Disabled
        elif option.state & QStyle.StateFlag.State_Selected:
            mode = QIcon.Mode.Selected
        if option.state & QStyle.StateFlag.State_HasFocus:
            painter.save()
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(option.palette.color(QPalette.ColorRole.HighlightedText))
            painter.drawRoundedRect(place.adjusted(-3, -3, 3, 3), 3, 3)
            painter.restore()
        icon("default").paint(painter, place, Qt.AlignmentFlag.AlignCenter, mode)


def _embolden(option: QStyleOptionViewItem) -> None:
    font = option.font
    font.setBold(True)
    option.font = font


def _mute(option: QStyleOptionViewItem) -> None:
    """Grey a text; disabled ones keep their colour."""
    palette = QPalette(option.palette)
    muted = theme().color("muted")
    for group in (QPalette.ColorGroup.Active, QPalette.ColorGroup.Inactive):
        palette.setColor(group, QPalette.ColorRole.Text, muted)
    option.palette = palette


class ParameterView(QTreeView):
    """Spans headings and remembers closed groups; while rows are filtered every group is open."""

    def __init__(self, rows: ParameterFilter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows = rows
        self._model = rows.parameters
        self._closed: set[str] = set()
        self._arranging = False
        self._unfinished: tuple[str, str] | None = None  # parameter and text of a lost editor
        self._fitted: dict[ParameterColumn, int] = {}  # widths that no user has changed since

        self.setObjectName("parametersView")
        self.setAccessibleName(self.tr("Parameters"))
        name_headers(self)
        self.setModel(rows)
        self.setItemDelegate(ParameterDelegate(self._model, self))
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

        rows.modelAboutToBeReset.connect(self._keep_typed)
        self.clicked.connect(self._on_clicked)
        self.doubleClicked.connect(self._on_double_clicked)
        self.collapsed.connect(self._on_collapsed)
        self.expanded.connect(self._on_expanded)

    def _set_up_header(self) -> None:
        header = self.header()
        header.setSectionsMovable(False)
        header.setStretchLastSection(True)
        header.setMinimumSectionSize(24)
        character = self.fontMetrics().averageCharWidth()
        for column, width in _WIDTHS.items():
            header.resizeSection(column, width * character)
        header.setSectionResizeMode(ParameterColumn.RESET, QHeaderView.ResizeMode.Fixed)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        header, character = self.header(), self.fontMetrics().averageCharWidth()
        shown = [column for column in _WIDTHS if not header.isSectionHidden(column)]
        room = self.viewport().width() // character - sum(_WIDTHS[column] for column in shown)
        name = min(max(room - _VALUE[0], _NAME[0]), _NAME[1])
        value = min(max(room - name, _VALUE[0]), _VALUE[1])
        spare = min(max(room - name - value, 0), _RANGE_MORE)
        ranges = _WIDTHS[ParameterColumn.RANGE] + spare
        self._fit_column(ParameterColumn.NAME, name * character)
        self._fit_column(ParameterColumn.VALUE, value * character)
        self._fit_column(ParameterColumn.RANGE, ranges * character)

    def _fit_column(self, column: ParameterColumn, width: int) -> None:
        """Give a column this width, unless the user has given it another one."""
        present = self.header().sectionSize(column)
        if self._fitted.get(column, present) == present:
            self.header().resizeSection(column, width)
            self._fitted[column] = self.header().sectionSize(column)

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
        self._resume_typing()

    def _on_collapsed(self, heading: QModelIndex) -> None:
        if self._arranging:
            return
        self._closed.add(str(heading.data(Role.GROUP)))
        if self.currentIndex().parent() == heading:
            self.setCurrentIndex(heading)  # a row that is not seen must not be edited

    def _on_expanded(self, heading: QModelIndex) -> None:
        if not self._arranging:
            self._closed.discard(str(heading.data(Role.GROUP)))

    # --- A board that is read again while a value is typed ------------------------------

    @Slot()
    def _keep_typed(self) -> None:
        """Keep what is being typed while the rows are made again, which closes the editor."""
        value = self.currentIndex().siblingAtColumn(ParameterColumn.VALUE)
        editor = self.indexWidget(value)
        if isinstance(editor, NumberEditor) and editor.lineEdit().isModified():
            self._unfinished = self.current_key, editor.text()

    def _resume_typing(self) -> None:
        unfinished, self._unfinished = self._unfinished, None
        if unfinished is None or not self._model.can_edit(unfinished[0]):
            return
        self._begin_edit(unfinished[0])
        editor = self.indexWidget(self.currentIndex())
        if isinstance(editor, NumberEditor):
            editor.lineEdit().selectAll()
            editor.lineEdit().insert(unfinished[1])

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
