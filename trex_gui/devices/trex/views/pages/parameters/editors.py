"""The right editor for each kind of parameter, all of one shape: wire values in and out."""

import re

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QSpinBox, QWidget

from trex_gui.core.errors import BadRequest, sentence
from trex_gui.devices.trex.model.parameters.text import FULL_SPEED_MS, duration
from trex_gui.devices.trex.protocol.flags import ALL_CHANNELS, CHANNELS, channel_mask, channels_in
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import ParameterKind, ParameterSpec

_TIME = re.compile(r"(\d+(?:[.,]\d*)?|[.,]\d+)\s*(ms|s)\b.*", re.IGNORECASE)
_IN_BRACKETS = re.compile(r"\s*\([^)]*\)?\s*$")
_TOLERANCE = 1.01


class NumberEditor(QSpinBox):
    """Steps through wire values and shows them in their physical unit.

    A value may be typed in any unit that the parameter understands.

    Signals:
        rejected: why the input is not a value, for the user.
    """

    rejected = Signal(str)

    def __init__(self, spec: ParameterSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._spec = spec
        self.setRange(spec.minimum, spec.maximum)
        self.setKeyboardTracking(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccelerated(True)
        self.setToolTip(spec.range_text())

    def textFromValue(self, val: int) -> str:
        return self._spec.text(val)

    def valueFromText(self, text: str) -> int:
        try:
            return self.meant(text)
        except BadRequest:
            return self.value()

    def validate(self, text: str, pos: int) -> tuple[QValidator.State, str, int]:
        try:
            self.meant(text)
        except BadRequest:
            return QValidator.State.Intermediate, text, pos
        return QValidator.State.Acceptable, text, pos

    def fixup(self, text: str) -> str:
        """Say why what was typed is dropped when the editor is left."""
        self.report_problem()
        return super().fixup(text)

    def report_problem(self) -> None:
        """Say why what stands in the editor is no value, if it is none."""
        try:
            self.meant(self.text())
        except BadRequest as error:
            self.rejected.emit(sentence(error))

    def meant(self, text: str) -> int:
        """Return the wire value of the input.

        Raises:
            BadRequest: none, or one outside the limits; names them.
        """
        return self._spec.wire(text)


class AccelerationEditor(NumberEditor):
    """Tells and takes the time to full speed, too."""

    def __init__(self, spec: ParameterSpec, parent: QWidget | None = None) -> None:
        super().__init__(spec, parent)
        slow, fast = (duration(FULL_SPEED_MS / wire) for wire in (1, spec.maximum))
        self._times = self.tr("{0} to {1}").format(slow, fast)
        self.setToolTip(
            self.tr("{0}; or the time to full speed, {1}").format(spec.range_text(), self._times)
        )

    def textFromValue(self, val: int) -> str:
        text = super().textFromValue(val)
        return self.tr("{0} ({1})").format(text, duration(FULL_SPEED_MS / val)) if val else text

    def meant(self, text: str) -> int:
        found = _TIME.fullmatch(text.strip())
        if found is None:
            return super().meant(_IN_BRACKETS.sub("", text))
        milliseconds = float(found[1].replace(",", ".")) * (1 if found[2].lower() == "ms" else 1000)
        shortest, longest = FULL_SPEED_MS / self._spec.maximum, FULL_SPEED_MS
        if not shortest / _TOLERANCE <= milliseconds <= longest * _TOLERANCE:
            raise BadRequest(
                self.tr("{0} reaches full speed in {1}, not in {2}").format(
                    self._spec.name, self._times, text.strip()
                )
            )
        return round(FULL_SPEED_MS / milliseconds)


class ChoiceEditor(QComboBox):
    """A drop-down of what the parameter's values mean.

    A value that the table does not know is shown as such, and kept until another is chosen.

    Signals:
        valueChanged: another value is shown.
    """

    valueChanged = Signal(int)

    def __init__(self, spec: ParameterSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        for wire, word in spec.choices.items():
            self.addItem(word, wire)
        self.currentIndexChanged.connect(lambda _index: self.valueChanged.emit(self.value()))

    def value(self) -> int:
        wire = self.currentData()
        return wire if isinstance(wire, int) else 0

    def setValue(self, wire: int) -> None:
        if self.findData(wire) < 0:
            self.addItem(self.tr("unknown ({0})").format(wire), wire)
        with QSignalBlocker(self):
            self.setCurrentIndex(self.findData(wire))


class ChannelsEditor(QWidget):
    """Five check boxes, one for each channel.

    Signals:
        valueChanged: a box was ticked or cleared.
    """

    valueChanged = Signal(int)

    def __init__(self, spec: ParameterSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAutoFillBackground(True)
        self._others = 0
        self._boxes: dict[int, QCheckBox] = {}

        layout = QHBoxLayout(self)
        layout.setContentsMargins(4, 0, 4, 0)
        for channel in CHANNELS:
            box = QCheckBox(str(channel), self)
            box.setObjectName(f"channel{channel}Box")
            box.setAccessibleName(self.tr("{0}: channel {1}").format(spec.name, channel))
            layout.addWidget(box)
            self._boxes[channel] = box
        layout.addStretch(1)
        self.setFocusProxy(self._boxes[1])

        for box in self._boxes.values():
            box.toggled.connect(lambda _on: self.valueChanged.emit(self.value()))

    def value(self) -> int:
        ticked = (channel for channel, box in self._boxes.items() if box.isChecked())
        return channel_mask(ticked) | self._others

    def setValue(self, wire: int) -> None:
        self._others = wire & ~ALL_CHANNELS  # bits of no channel stay as they are
        ticked = channels_in(wire)
        for channel, box in self._boxes.items():
            with QSignalBlocker(box):
                box.setChecked(channel in ticked)


class LineSettingsEditor(QWidget):
    """Baud rate, error detection and stop bits of the serial line.

    Signals:
        valueChanged: another setting is shown.
    """

    valueChanged = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAutoFillBackground(True)
        self._unknown: int | None = None
        self._baud = QComboBox(self)
        self._baud.setObjectName("baudField")
        self._baud.setAccessibleName(self.tr("Baud rate"))
        for baud in baud_rates():
            self._baud.addItem(self.tr("{0} baud").format(baud), baud)
        self._detection = QComboBox(self)
        self._detection.setObjectName("detectionField")
        self._detection.setAccessibleName(self.tr("Error detection"))
        for detection, text in (
            (Detection.NONE, self.tr("no check")),
            (Detection.CRC7, self.tr("CRC-7")),
            (Detection.EVEN, self.tr("even parity")),
            (Detection.ODD, self.tr("odd parity")),
        ):
            self._detection.addItem(text, detection)
        self._stop_bits = QComboBox(self)
        self._stop_bits.setObjectName("stopBitsField")
        self._stop_bits.setAccessibleName(self.tr("Stop bits"))
        self._stop_bits.addItem(self.tr("1 stop bit"), 1)
        self._stop_bits.addItem(self.tr("2 stop bits"), 2)

        self._fields = (self._baud, self._detection, self._stop_bits)

        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        for field in self._fields:
            field.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            layout.addWidget(field)
        self.setFocusProxy(self._baud)

        for field in self._fields:
            field.currentIndexChanged.connect(self._on_field_changed)

    @Slot()
    def _on_field_changed(self) -> None:
        if self._unknown is not None:
            self._unknown = None
            for field in self._fields:
                if field.currentIndex() < 0:
                    with QSignalBlocker(field):
                        field.setCurrentIndex(0)
        self.valueChanged.emit(self.value())

    def settings(self) -> LineSettings:
        """The line settings shown."""
        return LineSettings(
            int(self._baud.currentData()),
            Detection(self._detection.currentData()),
            int(self._stop_bits.currentData()),
        )

    def value(self) -> int:
        return self.settings().to_wire() if self._unknown is None else self._unknown

    def setValue(self, wire: int) -> None:
        try:
            self.set_settings(LineSettings.from_wire(wire))
        except BadRequest:
            # A value that names no baud rate is kept until a field is changed.
            self._unknown = wire
            for field in self._fields:
                with QSignalBlocker(field):
                    field.setCurrentIndex(-1)

    def set_settings(self, settings: LineSettings) -> None:
        """Show line settings."""
        self._unknown = None
        for field, data in (
            (self._baud, settings.baud),
            (self._detection, settings.detection),
            (self._stop_bits, settings.stop_bits),
        ):
            with QSignalBlocker(field):
                field.setCurrentIndex(field.findData(data))


Editor = NumberEditor | ChoiceEditor | ChannelsEditor | LineSettingsEditor


def editor_for(spec: ParameterSpec, parent: QWidget | None = None) -> Editor:
    """Return a new editor that fits the parameter."""
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
