"""Every parameter of the board: read, edit, apply."""

from typing import cast

from PySide6.QtCore import (
    QAbstractItemModel,
    QEvent,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    Qt,
    Signal,
    Slot,
)
from PySide6.QtGui import QFont, QKeyEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QFrame,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QPushButton,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QTableView,
    QVBoxLayout,
    QWidget,
)

from trex_gui.link.writing import Written
from trex_gui.model.adviser import BoardAdviser
from trex_gui.model.device import Device, Link
from trex_gui.model.parameter_filter import ParameterFilter
from trex_gui.model.parameters import Column, Role
from trex_gui.protocol.parameters import ParameterSpec
from trex_gui.views.icons import icon, set_icon
from trex_gui.views.theme import theme
from trex_gui.views.widgets.advice_list import AdviceList
from trex_gui.views.widgets.parameter_editors import Editor, NumberEditor, editor_for
from trex_gui.views.widgets.parameter_filters import ParameterFilters

Index = QModelIndex | QPersistentModelIndex


class ParameterDelegate(QStyledItemDelegate):
    """Opens the editor that fits a parameter and marks what is edited or waits for power.

    Signals:
        refused: why what was typed is no value, for people.
    """

    refused = Signal(str)

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        del option
        spec = cast("ParameterSpec", index.data(Role.SPEC))
        editor = editor_for(spec, parent)
        editor.setAccessibleName(spec.name)
        if isinstance(editor, NumberEditor):
            editor.refused.connect(self.refused)
        else:
            # What is ticked or chosen is an edit at once; a number is one with Enter.
            editor.valueChanged.connect(lambda _wire: self.commitData.emit(editor))
        return editor

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Keep an editor open while what was typed into it is no value."""
        if (
            isinstance(watched, NumberEditor)
            and isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.KeyPress
            and event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab}
            and not watched.hasAcceptableInput()
        ):
            watched.tell_problem()
            return True
        return super().eventFilter(watched, event)

    def setEditorData(self, editor: QWidget, index: Index) -> None:
        cast("Editor", editor).setValue(index.data(Role.WIRE))

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: Index) -> None:
        model.setData(index, cast("Editor", editor).value(), Qt.ItemDataRole.EditRole)

    def updateEditorGeometry(
        self, editor: QWidget, option: QStyleOptionViewItem, index: Index
    ) -> None:
        super().updateEditorGeometry(editor, option, index)
        wanted = editor.sizeHint()
        place = editor.geometry()
        place.setWidth(max(place.width(), wanted.width()))
        if wanted.height() > place.height():
            place.adjust(0, -((wanted.height() - place.height()) // 2), 0, 0)
            place.setHeight(wanted.height())
        editor.setGeometry(place)

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        font: QFont = option.font
        dirty = bool(index.data(Role.DIRTY))
        if dirty and index.column() in {Column.NAME, Column.VALUE, Column.WIRE}:
            font.setBold(True)
            option.font = font
        if index.column() != Column.NAME:
            return
        if index.data(Role.PROBLEM):
            self._decorate(option, "warning")
        elif dirty:
            self._decorate(option, "edited")
        elif index.data(Role.WAITING) is not None:
            self._decorate(option, "power")

    @staticmethod
    def _decorate(option: QStyleOptionViewItem, name: str) -> None:
        option.icon = icon(name)
        option.features |= QStyleOptionViewItem.ViewItemFeature.HasDecoration


class ParametersPage(QWidget):
    """The parameter table, the help of the selected row, and what the last Apply did.

    Signals:
        reload_requested: read everything from the board again.
    """

    reload_requested = Signal()

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("parametersPage")
        self._device = device
        self._model = device.parameters
        self._rows = ParameterFilter(self._model, self)

        self._filters = ParameterFilters(self._rows, self)
        self._advice = AdviceList(BoardAdviser(device, self), self)
        self._notice = QLabel(self)
        self._notice.setObjectName("parametersNotice")
        self._notice.setWordWrap(True)
        self._reload = QPushButton(self.tr("Re&load"), self)
        self._reload.setObjectName("reloadButton")
        self._reload.setToolTip(self.tr("Read every parameter from the board again"))
        set_icon(self._reload, "reload")
        self._discard = QPushButton(self.tr("Discard edits"), self)
        self._discard.setObjectName("discardButton")
        set_icon(self._discard, "undo")
        self._view = self._table()
        self._help = QLabel(self)
        self._help.setObjectName("parameterHelp")
        self._help.setWordWrap(True)
        self._help.setTextFormat(Qt.TextFormat.RichText)
        self._help.setAlignment(Qt.AlignmentFlag.AlignTop | Qt.AlignmentFlag.AlignLeft)
        self._help.setMinimumHeight(7 * self._help.fontMetrics().lineSpacing())
        self._help.setFrameShape(QFrame.Shape.StyledPanel)
        self._help.setMargin(8)

        top = QHBoxLayout()
        top.addWidget(self._notice, 1)
        top.addWidget(self._discard)
        top.addWidget(self._reload)
        layout = QVBoxLayout(self)
        layout.addLayout(top)
        layout.addWidget(self._filters)
        layout.addWidget(self._view, 1)
        layout.addWidget(self._advice)
        layout.addWidget(self._help)

        self._reload.clicked.connect(self.reload_requested)
        self._discard.clicked.connect(device.discard_edits)
        self._model.modelReset.connect(self._on_model_reset)
        self._model.dataChanged.connect(self._on_data_changed)
        self._model.pending_changed.connect(self._on_pending_changed)
        self._model.refused.connect(self._on_refused)
        device.applied.connect(self._on_applied)
        device.link_changed.connect(self._on_link_changed)
        self._view.selectionModel().currentChanged.connect(self._on_current_changed)
        theme().changed.connect(self._view.viewport().update)
        self._on_link_changed()

    def _table(self) -> QTableView:
        view = QTableView(self)
        view.setObjectName("parametersView")
        view.setAccessibleName(self.tr("Parameters"))
        view.setModel(self._rows)
        delegate = ParameterDelegate(view)
        delegate.refused.connect(self._on_refused)
        view.setItemDelegate(delegate)
        view.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        view.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
        view.setEditTriggers(
            QAbstractItemView.EditTrigger.DoubleClicked
            | QAbstractItemView.EditTrigger.EditKeyPressed
            | QAbstractItemView.EditTrigger.AnyKeyPressed
            | QAbstractItemView.EditTrigger.SelectedClicked
        )
        view.setAlternatingRowColors(True)
        view.setShowGrid(False)
        view.setWordWrap(False)
        view.setTabKeyNavigation(False)
        view.verticalHeader().hide()
        view.verticalHeader().setDefaultSectionSize(view.fontMetrics().height() + 12)
        header = view.horizontalHeader()
        header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
        header.setHighlightSections(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Interactive)
        header.setSectionResizeMode(Column.VALUE, QHeaderView.ResizeMode.Stretch)
        header.setMinimumSectionSize(6 * view.fontMetrics().averageCharWidth())
        return view

    @Slot()
    def _on_model_reset(self) -> None:
        self._view.resizeColumnsToContents()
        header = self._view.horizontalHeader()
        character = self._view.fontMetrics().averageCharWidth()
        for column, widest in (
            (Column.NAME, 50),
            (Column.WIRE, 8),
            (Column.DEFAULT, 20),
            (Column.RANGE, 28),
            (Column.EFFECT, 16),
        ):
            size = header.sectionSize(column) + 2 * character
            header.resizeSection(column, min(size, widest * character))
        self._on_link_changed()

    @Slot()
    def _on_link_changed(self) -> None:
        up = self._device.link is Link.UP
        self._reload.setEnabled(up)
        self._filters.setEnabled(self._model.rowCount() > 0)
        self._view.setEnabled(up)
        if self._model.rowCount() == 0:
            self._notice.setText(self.tr("Connect to a board to see its parameters."))
            self._help.setText("")
        elif up:
            self._on_pending_changed(len(self._model.pending))
            if not self._view.currentIndex().isValid():
                self._view.setCurrentIndex(self._rows.index(0, Column.VALUE))
        else:
            self._notice.setText(
                self.tr("No board answers. Edits are kept for when the same kind of board is back.")
            )
        self._discard.setEnabled(up and bool(self._model.pending))

    @Slot(int)
    def _on_pending_changed(self, count: int) -> None:
        self._discard.setEnabled(count > 0 and self._device.link is Link.UP)
        waiting = self._model.waiting_for_power
        if count:
            text = self.tr("{0} not applied yet: Apply settings writes them.").format(
                self._count_text(count)
            )
        elif waiting:
            text = self.tr("Stored, but not active before the board is switched off and on: {0}.")
            text = text.format(", ".join(waiting))
        else:
            text = self.tr("Double-click a value to change it. Nothing is written before Apply.")
        self._notice.setText(text)

    @Slot(QModelIndex, QModelIndex)
    def _on_current_changed(self, current: QModelIndex, _previous: QModelIndex) -> None:
        spec = cast("ParameterSpec | None", current.data(Role.SPEC))
        self._help.setText("" if spec is None else self._help_text(spec, current))
        self._view.scrollTo(current)
        self._view.scrollTo(current.siblingAtColumn(Column.NAME))  # which row it is, above all

    def _help_text(self, spec: ParameterSpec, index: QModelIndex) -> str:
        parts = [f"<b>{spec.name}</b> ({spec.number:#04x}, <code>{spec.key}</code>)"]
        parts.append(spec.description)
        limits = self.tr("Range {0}; default {1}.").format(
            spec.range_text(), spec.text(spec.default)
        )
        if not spec.limits_confirmed:
            limits += " " + self.tr("The range is inferred: the board has the last word.")
        if not spec.default_confirmed:
            limits += " " + self.tr("The default is inferred.")
        parts.append(limits)
        if spec.needs_power_cycle:
            parts.append(self.tr("Takes effect when the board is switched off and on."))
        waiting = index.data(Role.WAITING)
        if waiting is not None:
            parts.append("<b>" + self.tr("Still active: {0}.").format(spec.text(waiting)) + "</b>")
        if problem := index.data(Role.PROBLEM):
            parts.append(f"<b>{problem}</b>")
        return "<br>".join(parts)

    @Slot(QModelIndex, QModelIndex)
    def _on_data_changed(self, _first: QModelIndex, _last: QModelIndex) -> None:
        self._on_current_changed(self._view.currentIndex(), QModelIndex())

    @Slot(str)
    def _on_refused(self, reason: str) -> None:
        self._notice.setText(reason)

    @Slot(object)
    def _on_applied(self, results: tuple[Written, ...]) -> None:
        failed = [result for result in results if result.error is not None]
        if failed:
            self._filters.clear()
            place = self._model.index_of(failed[0].what)
            self._view.setCurrentIndex(self._rows.mapFromSource(place))
            text = self.tr("{0} of {1} did not stick; they are marked below.").format(
                len(failed), len(results)
            )
        else:
            text = self.tr("{0} written and read back equal.").format(
                self._count_text(len(results))
            )
            if waiting := self._model.waiting_for_power:
                text += " " + self.tr("Switch the board off and on to make active: {0}.").format(
                    ", ".join(waiting)
                )
        self._notice.setText(text)

    def _count_text(self, count: int) -> str:
        return self.tr("1 setting") if count == 1 else self.tr("{0} settings").format(count)
