"""The tree of parameters as a table with headings, used with the mouse or with keys alone."""

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QPoint, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QPainter, QPalette
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QStyleOptionViewItem,
    QTreeView,
    QWidget,
)

from trex_gui.devices.trex.model.parameters.filter import ParameterFilter
from trex_gui.devices.trex.model.parameters.parameters import ParameterColumn, Role
from trex_gui.devices.trex.views.pages.parameters.delegate import ParameterDelegate, ResetDelegate
from trex_gui.ui.widgets.behaviour import name_headers

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
"""Widths in average characters; what is left is the value's."""


class ParameterView(QTreeView):
    """Keeps headings spanned and groups open as they were, through reloads and searches.

    While the rows are narrowed down every group is open; then each is as the user left it.

    Signals:
        reset_wanted: the parameter with this key is to be reset to its default.
        menu_wanted: a menu for the current row, and where on the screen.
        rejected: why the input is not a value, for the user.
    """

    reset_wanted = Signal(str)
    menu_wanted = Signal(QPoint)
    rejected = Signal(str)

    def __init__(self, rows: ParameterFilter, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._rows = rows
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
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        self.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.AnyKeyPressed
            | QAbstractItemView.EditTrigger.SelectedClicked
        )
        self.setAlternatingRowColors(True)
        self.setUniformRowHeights(True)
        self.setWordWrap(False)
        self.setTabKeyNavigation(False)
        self.setIndentation(16)
        self._set_up_header()

        self.clicked.connect(self._on_clicked)
        self.doubleClicked.connect(self._on_double_clicked)
        self.collapsed.connect(self._on_collapsed)
        self.expanded.connect(self._on_expanded)
        for changed in (rows.modelReset, rows.rowsInserted, rows.layoutChanged):
            changed.connect(self.arrange)
        self.arrange()

    def _set_up_header(self) -> None:
        header = self.header()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        header.setSectionsMovable(False)
        header.setStretchLastSection(False)
        header.setMinimumSectionSize(24)
        character = self.fontMetrics().averageCharWidth()
        for column, width in _WIDTHS.items():
            header.resizeSection(column, width * character)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setSectionResizeMode(ParameterColumn.RESET, QHeaderView.ResizeMode.Fixed)
        header.setSectionResizeMode(ParameterColumn.VALUE, QHeaderView.ResizeMode.Stretch)

    # --- Groups -------------------------------------------------------------------------

    def arrange(self) -> None:
        """Span the headings, and open the groups that are to be open.

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

    # --- User actions -----------------------------------------------------------------------

    def begin_edit(self, index: QModelIndex) -> None:
        """Open the editor of the row of a cell."""
        value = index.siblingAtColumn(ParameterColumn.VALUE)
        self.setCurrentIndex(value)
        self.edit(value)

    def _on_clicked(self, index: QModelIndex) -> None:
        if index.column() == ParameterColumn.RESET:
            self._press_reset(index)

    def _on_double_clicked(self, index: QModelIndex) -> None:
        is_other = index.column() not in {ParameterColumn.VALUE, ParameterColumn.RESET}
        if is_other and index.data(Role.SPEC) is not None:
            self.begin_edit(index)

    def _press_reset(self, index: QModelIndex) -> None:
        if index.data(Role.RESET) and index.flags() & Qt.ItemFlag.ItemIsEnabled:
            self.reset_wanted.emit(index.data(Role.SPEC).key)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """Ask for the menu of the row under the mouse, or with the menu key of the current one."""
        index, place = self.indexAt(event.pos()), event.pos()
        if event.reason() is QContextMenuEvent.Reason.Keyboard:
            index = self.currentIndex()
            place = self.visualRect(index).center()
        if index.data(Role.SPEC) is not None:
            same_row = index.siblingAtColumn(0) == self.currentIndex().siblingAtColumn(0)
            self.setCurrentIndex(self.currentIndex() if same_row else index)
            self.menu_wanted.emit(self.viewport().mapToGlobal(place))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Let keys reach value and default of a row, wherever in it the last click was."""
        current = self.currentIndex()
        if self.state() is QAbstractItemView.State.EditingState:
            super().keyPressEvent(event)
        elif current.data(Role.GROUP) is not None and event.key() in _PRESS:
            self.setExpanded(current, not self.isExpanded(current))
        elif current.data(Role.SPEC) is None:
            super().keyPressEvent(event)
        elif not self._act(current, event):
            typed = event.text()
            if event.key() == Qt.Key.Key_F2 or (typed and typed.isprintable()):
                self.setCurrentIndex(current.siblingAtColumn(ParameterColumn.VALUE))
            super().keyPressEvent(event)

    def _act(self, current: QModelIndex, event: QKeyEvent) -> bool:
        """Do what a key means in the row of a parameter; return whether it means anything."""
        at_reset = current.column() == ParameterColumn.RESET
        match event.key():
            case key if key in _PRESS and at_reset:
                self._press_reset(current)
            case key if key in _PRESS:
                self.begin_edit(current)
            case Qt.Key.Key_Right if not at_reset and current.siblingAtColumn(
                ParameterColumn.RESET
            ).data(Role.RESET):
                self.setCurrentIndex(current.siblingAtColumn(ParameterColumn.RESET))
            case Qt.Key.Key_Left if at_reset:
                self.setCurrentIndex(current.siblingAtColumn(ParameterColumn.VALUE))
            case _:
                return False
        return True

    # --- Painting -----------------------------------------------------------------------

    def drawRow(  # noqa: N802 # of Qt
        self, painter: QPainter, option: QStyleOptionViewItem, index: Index
    ) -> None:
        """Give headings another background than rows, from one edge to the other."""
        if not index.parent().isValid():
            palette = QPalette(option.palette)
            shade = palette.brush(QPalette.ColorRole.Button)
            palette.setBrush(QPalette.ColorRole.AlternateBase, shade)
            option.palette = palette
            painter.fillRect(option.rect, shade)
        super().drawRow(painter, option, index)
