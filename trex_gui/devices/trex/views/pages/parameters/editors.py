"""Delegate and editors of the parameter table. The value of an editor is a wire value."""

import re
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Sequence
from typing import cast

from PySide6.QtCore import (
    QAbstractItemModel,
    QEvent,
    QObject,
    QPoint,
    QRect,
    QSize,
    Qt,
    Signal,
    Slot,
)
from PySide6.QtGui import QFont, QKeyEvent, QPainter, QPalette, QPen
from PySide6.QtWidgets import (
    QAbstractItemView,
    QAbstractSpinBox,
    QStyle,
    QStyledItemDelegate,
    QStyleOptionViewItem,
    QWidget,
)

from trex_gui.core.decimals import quantity
from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.parameters.parameters import Index, ParameterModel, ParameterRole
from trex_gui.devices.trex.model.parameters.text import (
    ParameterColumn,
    frequency_code,
    frequency_range,
    frequency_text,
    frequency_wires,
)
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.protocol.flags import ALL_CHANNELS, CHANNELS, channel_mask, channels_in
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import ParameterKind, ParameterSpec
from trex_gui.devices.trex.views.count_editor import BARE, UnitSpinBox
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets.behaviour import ENTER
from trex_gui.ui.widgets.builders import ComboBox, check_box, combo_box, plain, row

_TOLERANCE = 1.01  # factor by which an entered frequency may lie outside its limits
_ICON = 16  # pixels
_SIGNS = {"warning": "warning", "edited": "dirty", "power": "icon"}  # icon → colour
_UNTOUCHED = "untouched"  # property of an editor that the user has not changed
_STEPS = QAbstractSpinBox.StepEnabledFlag
_BOTH_STEPS = _STEPS.StepUpEnabled | _STEPS.StepDownEnabled


class NumberEditor(UnitSpinBox):
    """Number field that shows and accepts a wire value in any unit of the parameter."""

    def __init__(self, spec: ParameterSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._spec = spec
        self.setRange(spec.minimum, spec.maximum)
        self.setToolTip(plain(spec.range_text()))

    def textFromValue(self, val: int) -> str:
        return str(val) if self.own_first else self._spec.text(val)

    def parse(self, text: str) -> int:
        number = text.strip()
        if not self.own_first or not BARE.fullmatch(number):
            return self._physical_wire(number)
        try:
            wire = int(number)
        except ValueError:
            text = tr("{0} must be {1}, not {2}").format(
                self._spec.name, self._spec.range_text(), number
            )
            raise BadRequest(text) from None
        return self._spec.check(wire)

    def _physical_wire(self, text: str) -> int:
        return self._spec.wire(text)


class AccelerationEditor(NumberEditor):
    """Field for the time to full speed. It also accepts speed steps such as `25 per 100 ms`."""

    def __init__(self, spec: ParameterSpec, parent: QWidget | None = None) -> None:
        super().__init__(spec, parent)
        tip = tr("{0}, or speed steps such as {1}. The board stores the nearest time.")
        self.setToolTip(tip.format(spec.short_range(), f"25 {spec.unit}"))

    def _physical_wire(self, text: str) -> int:
        return super()._physical_wire(f"{text} s" if BARE.fullmatch(text) else text)

    def stepBy(self, steps: int) -> None:
        """Step through times unless wire values are shown. The shortest time is 0 (no ramp)."""
        if self.own_first:
            super().stepBy(steps)
            return
        highest = self.maximum()
        index = (highest + 1 - self.value() if self.value() else 0) + steps
        index = min(max(index, 0), highest)
        self.setValue(highest + 1 - index if index else 0)
        self.selectAll()

    def stepEnabled(self) -> QAbstractSpinBox.StepEnabledFlag:  # noqa: N802 # of Qt
        return _BOTH_STEPS


class FrequencyEditor(UnitSpinBox):
    """Editor for a `frequency_code`. It selects the nearest possible PWM frequency."""

    def __init__(self, codes: Sequence[int], parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._codes = codes
        self._hertz = [device_table().pwm.frequency(*frequency_wires(code)) for code in codes]
        self.setRange(0, frequency_code(FULL_SCALE, FULL_SCALE))
        self.setToolTip(plain(frequency_range(codes)))

    def textFromValue(self, val: int) -> str:
        return frequency_text(val)

    def parse(self, text: str) -> int:
        if text.strip() == frequency_text(self.value()):
            return self.value()
        hertz = quantity(re.sub("[kK]$", "kHz", text.strip()), "Hz") or 0
        if not self._hertz[0] / _TOLERANCE <= hertz <= self._hertz[-1] * _TOLERANCE:
            message = tr("The PWM frequency must be {0}, not {1}.")
            raise BadRequest(message.format(frequency_range(self._codes), text.strip()))
        nearest = min(range(len(self._codes)), key=lambda index: abs(self._hertz[index] - hertz))
        return self._codes[nearest]

    def stepBy(self, steps: int) -> None:
        try:
            hertz = device_table().pwm.frequency(*frequency_wires(self.value()))
        except BadRequest:
            hertz = 0
        below, above = bisect_right(self._hertz, hertz) - 1, bisect_left(self._hertz, hertz)
        index = (below if steps > 0 else above) + steps
        self.setValue(self._codes[min(max(index, 0), len(self._codes) - 1)])
        self.selectAll()

    def stepEnabled(self) -> QAbstractSpinBox.StepEnabledFlag:  # noqa: N802 # of Qt
        return _BOTH_STEPS


class ChoiceEditor(ComboBox):
    """Drop-down list of named values. An unknown value is added as an item."""

    valueChanged = Signal(int)  # wire value after each selection, even of the current item

    def __init__(self, spec: ParameterSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        for wire, word in spec.choices.items():
            self.addItem(word, wire)
        self.activated.connect(lambda _index: self.valueChanged.emit(self.value()))

    def value(self) -> int:
        wire = self.currentData()
        return wire if isinstance(wire, int) else 0

    def setValue(self, wire: int) -> None:
        if self.findData(wire) < 0:
            self.addItem(tr("unknown ({0})").format(wire), wire)
        self.setCurrentIndex(self.findData(wire))


class ChannelsEditor(QWidget):
    valueChanged = Signal(int)  # wire value after the user has clicked a box

    def __init__(self, spec: ParameterSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAutoFillBackground(True)
        self._other_bits = 0
        self._boxes = {
            channel: check_box(
                self,
                f"channel{channel}Box",
                str(channel),
                accessible=tr("{0}: channel {1}").format(spec.name, channel),
                on_click=lambda: self.valueChanged.emit(self.value()),
            )
            for channel in CHANNELS
        }
        self.setFocusProxy(self._boxes[1])
        row(*self._boxes.values(), 1, into=self, margins=(4, 0, 4, 0))

    def value(self) -> int:
        checked = (channel for channel, box in self._boxes.items() if box.isChecked())
        return channel_mask(checked) | self._other_bits

    def setValue(self, wire: int) -> None:
        self._other_bits = wire & ~ALL_CHANNELS
        for channel, box in self._boxes.items():
            box.setChecked(channel in channels_in(wire))


class LineSettingsEditor(QWidget):
    valueChanged = Signal(int)  # wire value after each selection, even of the current item

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAutoFillBackground(True)
        self._unknown: int | None = None

        def field(name: str, title: str, *items: tuple[str, object]) -> ComboBox:
            return combo_box(self, name, title, tip=title, items=items)

        rates = [(tr("{0} baud").format(baud), baud) for baud in baud_rates()]
        self._baud = field("baudField", tr("Baud rate"), *rates)
        self._detection = field(
            "detectionField",
            tr("Error detection"),
            (tr("no error detection"), Detection.NONE),
            (tr("CRC-7"), Detection.CRC7),
            (tr("even parity"), Detection.EVEN),
            (tr("odd parity"), Detection.ODD),
        )
        stop_bits = (tr("1 stop bit"), 1), (tr("2 stop bits"), 2)
        self._stop_bits = field("stopBitsField", tr("Stop bits"), *stop_bits)
        self._fields = (self._baud, self._detection, self._stop_bits)
        row(*self._fields, into=self, margins=0, spacing=4)
        self.setFocusProxy(self._baud)
        for combo in self._fields:
            combo.activated.connect(self._on_activated)

    @Slot()
    def _on_activated(self) -> None:
        self._unknown = None
        for field in self._fields:
            field.setCurrentIndex(max(0, field.currentIndex()))
        self.valueChanged.emit(self.value())

    def settings(self) -> LineSettings:
        return LineSettings(
            int(self._baud.currentData()),
            Detection(self._detection.currentData()),
            int(self._stop_bits.currentData()),
        )

    def value(self) -> int:
        return self.settings().to_wire() if self._unknown is None else self._unknown

    def setValue(self, wire: int) -> None:
        """Show a wire value. An invalid value remains until the user changes a field."""
        try:
            self.set_settings(LineSettings.from_wire(wire))
        except BadRequest:
            self._unknown = wire
            for field in self._fields:
                field.setCurrentIndex(-1)

    def set_settings(self, settings: LineSettings) -> None:
        self._unknown = None
        shown = (settings.baud, settings.detection, settings.stop_bits)
        for field, data in zip(self._fields, shown, strict=True):
            field.setCurrentIndex(field.findData(data))


Editor = NumberEditor | FrequencyEditor | ChoiceEditor | ChannelsEditor | LineSettingsEditor


def editor_for(spec: ParameterSpec, parent: QWidget | None = None) -> Editor:
    match spec.kind:
        case ParameterKind.CHOICE:
            return ChoiceEditor(spec, parent)
        case ParameterKind.CHANNELS:
            return ChannelsEditor(spec, parent)
        case ParameterKind.UART:
            return LineSettingsEditor(parent)
        case ParameterKind.ACCELERATION:
            return AccelerationEditor(spec, parent)
        case _:
            return NumberEditor(spec, parent)


class ParameterDelegate(QStyledItemDelegate):
    """Delegate of a `ParameterModel`.

    The editor of a missing value shows the default. Only Enter or an edit stores a value. A number
    field stays open while its input is invalid.
    """

    def __init__(
        self, model: ParameterModel, has_finding: Callable[[str], bool], view: QAbstractItemView
    ) -> None:
        super().__init__(view)
        self._model, self._has_finding, self._view = model, has_finding, view

    def createEditor(self, parent: QWidget, option: QStyleOptionViewItem, index: Index) -> QWidget:
        del option
        key, text = str(index.data(ParameterRole.KEY)), self._model.text
        editor: Editor
        if len(text.keys_of(key)) > 1:
            editor = FrequencyEditor(text.frequencies, parent)
        else:
            editor = editor_for(self._model.values.specs[key], parent)
        editor.setAccessibleName(text.title(key))
        editor.setProperty(_UNTOUCHED, index.data(Qt.ItemDataRole.EditRole) is None)

        def on_touched() -> None:
            editor.setProperty(_UNTOUCHED, False)
            if not isinstance(editor, UnitSpinBox):
                self.commitData.emit(editor)  # a number is committed on Enter

        editor.valueChanged.connect(on_touched)
        if isinstance(editor, UnitSpinBox):
            editor.rejected.connect(self._model.rejected)
            editor.lineEdit().textEdited.connect(on_touched)
        return editor

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        is_press = event.type() == QEvent.Type.KeyPress
        key = event.key() if is_press and isinstance(event, QKeyEvent) else None
        if key in ENTER:
            watched.setProperty(_UNTOUCHED, False)
        if (
            isinstance(watched, UnitSpinBox)
            and key in {*ENTER, Qt.Key.Key_Tab, Qt.Key.Key_Backtab}
            and not watched.hasAcceptableInput()
        ):
            watched.report_problem()
            return True
        return super().eventFilter(watched, event)

    def setEditorData(self, editor: QWidget, index: Index) -> None:
        if isinstance(editor, UnitSpinBox) and editor.lineEdit().isModified():
            return  # the user is typing
        wire, untouched = index.data(Qt.ItemDataRole.EditRole), editor.property(_UNTOUCHED)
        if wire is None:
            wire = self._model.default_number(str(index.data(ParameterRole.KEY)))
        cast("Editor", editor).setValue(wire)
        editor.setProperty(_UNTOUCHED, untouched)  # `setValue` is not an edit by the user

    def setModelData(self, editor: QWidget, model: QAbstractItemModel, index: Index) -> None:
        if not editor.property(_UNTOUCHED):
            model.setData(index, cast("Editor", editor).value(), Qt.ItemDataRole.EditRole)
            if isinstance(editor, UnitSpinBox) and editor.rounding:
                self._model.rounded.emit(editor.rounding)

    def updateEditorGeometry(
        self, editor: QWidget, option: QStyleOptionViewItem, index: Index
    ) -> None:
        super().updateEditorGeometry(editor, option, index)
        geometry = editor.geometry()
        center_y = geometry.center().y()
        geometry.setSize(geometry.size().expandedTo(editor.sizeHint()))
        geometry.moveCenter(QPoint(geometry.center().x(), center_y))
        view = editor.parentWidget()
        if view is not None and geometry.right() > view.width():
            geometry.moveRight(max(geometry.width(), view.width()) - 1)
        editor.setGeometry(geometry)

    def initStyleOption(self, option: QStyleOptionViewItem, index: Index) -> None:
        super().initStyleOption(option, index)
        option.state &= ~QStyle.StateFlag.State_Selected  # `paint` shows the selection
        if index.data(ParameterRole.GROUP) is not None:
            option.state |= QStyle.StateFlag.State_Enabled
            _set_text_color(option, "muted", bold=True)
        elif index.column() != ParameterColumn.NAME:
            if index.data(ParameterRole.DIRTY):
                _set_text_color(option, "dirty", bold=True)
            elif index.data(Qt.ItemDataRole.EditRole) is None:
                _set_text_color(option, "muted")

    def sizeHint(self, option: QStyleOptionViewItem, index: Index) -> QSize:
        return super().sizeHint(option, index) + QSize(_ICON + 2, 0)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        cell, is_value = QRect(option.rect), index.column() != ParameterColumn.NAME
        if index.data(ParameterRole.GROUP) is not None:
            painter.setPen(theme().color("hairline"))
            painter.drawLine(cell.topLeft(), cell.topRight())
        else:
            option.rect = cell.adjusted(_ICON + 2, 0, 0, 0)
            if index.row() == self._view.currentIndex().row():
                painter.fillRect(cell, theme().color("selected"))
        super().paint(painter, option, index)
        option.rect = cell
        if not is_value:
            return
        if sign := self._sign(index):
            box = QRect(cell.left() + 2, cell.top(), _ICON, cell.height())
            icon(sign, _SIGNS[sign]).paint(painter, box)
        if option.state & QStyle.StateFlag.State_Selected:
            width = 2 if option.state & QStyle.StateFlag.State_HasFocus else 1
            painter.setPen(QPen(theme().color("accent"), width))
            painter.drawRect(cell.adjusted(1, 1, -1, -1))

    def _sign(self, index: Index) -> str:
        key = str(index.data(ParameterRole.KEY))
        if index.data(ParameterRole.PROBLEM) or self._has_finding(key):
            return "warning"
        if index.data(ParameterRole.DIRTY):
            return "edited"
        return "power" if index.data(ParameterRole.ACTIVE) is not None else ""


def _set_text_color(option: QStyleOptionViewItem, color: str, *, bold: bool = False) -> None:
    """Set the theme colour of enabled text."""
    palette = QPalette(option.palette)
    for group in (QPalette.ColorGroup.Active, QPalette.ColorGroup.Inactive):
        palette.setColor(group, QPalette.ColorRole.Text, theme().color(color))
    option.palette = palette
    if bold:
        font = option.font
        font.setWeight(QFont.Weight.DemiBold)
        option.font = font
