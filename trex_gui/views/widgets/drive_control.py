"""One motor's hand-hold: slider, entry box, brake, and what the board reports beside it."""

from PySide6.QtCore import QEvent, QObject, QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import (
    QGridLayout,
    QGroupBox,
    QLabel,
    QPushButton,
    QSpinBox,
    QWidget,
)

from trex_gui.views.widgets.speed_slider import SpeedSlider

FULL_SPEED = 127


class DriveControl(QGroupBox):
    """A slider and an entry box that always show the same speed.

    It shows a wish and asks for another; it does not decide what is sent. The mouse wheel
    scrolls the page and never drives a motor.

    Signals:
        speed_wanted: a speed of `lowest` to 127 that a person chose.
        brake_wanted: the brake button was pressed.
    """

    speed_wanted = Signal(int)
    brake_wanted = Signal()

    def __init__(
        self, title: str, name: str, *, two_way: bool = True, parent: QWidget | None = None
    ) -> None:
        super().__init__(title, parent)
        lowest = -FULL_SPEED if two_way else 0

        self._slider = SpeedSlider(lowest, self)
        self._slider.setObjectName(f"{name}Slider")
        self._slider.setAccessibleName(self.tr("{0}, speed").format(title))
        self._entry = QSpinBox(self)
        self._entry.setObjectName(f"{name}Entry")
        self._entry.setAccessibleName(self.tr("{0}, speed as a number").format(title))
        self._entry.setRange(lowest, FULL_SPEED)
        self._entry.setKeyboardTracking(False)
        self._entry.setAlignment(Qt.AlignmentFlag.AlignRight)
        self._entry.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        for widget in (self._slider, self._entry):
            widget.installEventFilter(self)
        self._zero = QPushButton(self.tr("Zero"), self)
        self._zero.setObjectName(f"{name}Zero")
        self._zero.setToolTip(self.tr("Speed 0: the motor is not driven and coasts"))
        self._brake = QPushButton(self.tr("Brake"), self)
        self._brake.setObjectName(f"{name}Brake")
        self._brake.setToolTip(self.tr("Full brake: the motor's terminals are shorted"))
        self._brake.setVisible(two_way)
        self._asked = QLabel(self)
        self._asked.setObjectName(f"{name}Asked")
        self._reported = QLabel(self)
        self._reported.setObjectName(f"{name}Reported")

        layout = QGridLayout(self)
        layout.setHorizontalSpacing(10)
        layout.addWidget(self._slider, 0, 0, 1, 2)
        layout.addWidget(self._entry, 0, 2)
        layout.addWidget(self._zero, 0, 3)
        layout.addWidget(self._brake, 0, 4)
        layout.addWidget(self._asked, 1, 0)
        layout.addWidget(self._reported, 1, 1)
        layout.setColumnStretch(0, 1)
        layout.setColumnStretch(1, 1)

        self._slider.valueChanged.connect(self._on_slider_changed)
        self._entry.valueChanged.connect(self._on_entry_changed)
        self._zero.clicked.connect(self._on_zero_clicked)
        self._brake.clicked.connect(self.brake_wanted)

    def show_wish(self, speed: int, text: str) -> None:
        """Show the wish in force, without asking for it again."""
        with QSignalBlocker(self._slider), QSignalBlocker(self._entry):
            if not self._slider.isSliderDown():
                self._slider.setValue(speed)
            self._entry.setValue(speed)
        if self._asked.text() != text:
            self._asked.setText(text)

    def show_report(self, text: str) -> None:
        """Show what the board says of this motor."""
        if self._reported.text() != text:
            self._reported.setText(text)

    def let_go(self) -> None:
        """End a drag that is under way, so that the slider can be set."""
        self._slider.setSliderDown(False)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Wheel:
            event.ignore()
            return True
        return super().eventFilter(watched, event)

    @Slot(int)
    def _on_slider_changed(self, speed: int) -> None:
        with QSignalBlocker(self._entry):
            self._entry.setValue(speed)
        self.speed_wanted.emit(speed)

    @Slot(int)
    def _on_entry_changed(self, speed: int) -> None:
        with QSignalBlocker(self._slider):
            self._slider.setValue(speed)
        self.speed_wanted.emit(speed)

    @Slot()
    def _on_zero_clicked(self) -> None:
        self.speed_wanted.emit(0)
