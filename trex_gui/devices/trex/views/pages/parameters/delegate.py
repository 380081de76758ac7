"""Opens the editor that fits a parameter, and paints what is edited, inferred or not given."""

from typing import cast

from PySide6.QtCore import (
    QAbstractItemModel,
    QEvent,
    QModelIndex,
    QObject,
    QPersistentModelIndex,
    QPoint,
    QRect,
    QSize,
    Qt,
    Signal,
)
from PySide6.QtGui import QColor, QFont, QIcon, QKeyEvent, QPainter, QPalette
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QWidget

from trex_gui.devices.trex.model.parameters.parameters import Role
from trex_gui.devices.trex.model.parameters.text import ParameterColumn
from trex_gui.devices.trex.protocol.parameters import ParameterSpec
from trex_gui.devices.trex.views.count_editor import UnitDelegate
from trex_gui.devices.trex.views.pages.parameters.editors import Editor, NumberEditor, editor_for
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme

Index = QModelIndex | QPersistentModelIndex

_ICON = 16
_ROOM = 12
_ENTER = {Qt.Key.Key_Return, Qt.Key.Key_Enter}
_UNTOUCHED = "untouched"


class ParameterDelegate(UnitDelegate):
    """Paints and edits the rows of a `ParameterModel`.

    Where no value is given, the editor shows the default, which becomes the value only when
    something is typed or chosen, or with Enter.

    Signals:
        rejected: why the input is not a value, for the user.
    """

    rejected = Signal(str)

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
            editor.rejected.connect(self.rejected)
            editor.lineEdit().textEdited.connect(on_touched)
        return editor

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Let Enter take the value shown."""
        is_press = event.type() == QEvent.Type.KeyPress
        if is_press and isinstance(event, QKeyEvent) and event.key() in _ENTER:
            watched.setProperty(_UNTOUCHED, False)
        return super().eventFilter(watched, event)

    def setEditorData(self, editor: QWidget, index: Index) -> None:
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
    font: QFont = option.font
    font.setBold(True)
    option.font = font


def _mute(option: QStyleOptionViewItem) -> None:
    """Grey a text; disabled ones keep their colour."""
    palette = QPalette(option.palette)
    muted: QColor = theme().color("muted")
    for group in (QPalette.ColorGroup.Active, QPalette.ColorGroup.Inactive):
        palette.setColor(group, QPalette.ColorRole.Text, muted)
    option.palette = palette
