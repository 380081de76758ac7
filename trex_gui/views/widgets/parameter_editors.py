"""The right editor for each kind of parameter, all of one shape: wire values in and out."""

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QValidator
from PySide6.QtWidgets import QCheckBox, QComboBox, QHBoxLayout, QSpinBox, QWidget

from trex_gui.protocol.errors import BadRequest
from trex_gui.protocol.flags import CHANNELS, channel_mask, channels_in
from trex_gui.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.protocol.parameters import Kind, ParameterSpec


class NumberEditor(QSpinBox):
    """Steps through wire values and shows them in their physical unit.

    A value may be typed in any unit that the parameter understands.
    """

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
            return self._spec.wire(text)
        except BadRequest:
            return self.value()

    def validate(self, text: str, pos: int) -> tuple[QValidator.State, str, int]:
        try:
            self._spec.wire(text)
        except BadRequest:
            return QValidator.State.Intermediate, text, pos
        return QValidator.State.Acceptable, text, pos


class ChoiceEditor(QComboBox):
    """A drop-down of what the parameter's values mean.

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
        self.setCurrentIndex(self.findData(wire))


class ChannelsEditor(QWidget):
    """Five tick boxes, one a channel.

    Signals:
        valueChanged: a box was ticked or cleared.
    """

    valueChanged = Signal(int)

    def __init__(self, spec: ParameterSpec, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setAutoFillBackground(True)
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
        return channel_mask(channel for channel, box in self._boxes.items() if box.isChecked())

    def setValue(self, wire: int) -> None:
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

        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(4)
        for field in (self._baud, self._detection, self._stop_bits):
            field.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
            layout.addWidget(field)
        self.setFocusProxy(self._baud)

        for field in (self._baud, self._detection, self._stop_bits):
            field.currentIndexChanged.connect(lambda _index: self.valueChanged.emit(self.value()))

    def settings(self) -> LineSettings:
        """The line settings shown."""
        return LineSettings(
            int(self._baud.currentData()),
            Detection(self._detection.currentData()),
            int(self._stop_bits.currentData()),
        )

    def value(self) -> int:
        return self.settings().to_wire()

    def setValue(self, wire: int) -> None:
        try:
            settings = LineSettings.from_wire(wire)
        except BadRequest:
            return
        self.set_settings(settings)

    def set_settings(self, settings: LineSettings) -> None:
        """Show line settings."""
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
        case Kind.CHOICE:
            return ChoiceEditor(spec, parent)
        case Kind.CHANNELS:
            return ChannelsEditor(spec, parent)
        case Kind.UART:
            return LineSettingsEditor(parent)
        case _:
            return NumberEditor(spec, parent)
