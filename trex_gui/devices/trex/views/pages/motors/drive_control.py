"""One motor's hand-hold: slider, entry box, brake, and what the board reports beside it."""

from PySide6.QtCore import QEvent, QObject, QSignalBlocker, Qt, Signal, Slot
from PySide6.QtWidgets import QWidget

from trex_gui.devices.trex.views.output_bar import OutputBar
from trex_gui.devices.trex.views.pages.motors.speed_entry import SpeedEntry
from trex_gui.devices.trex.views.pages.motors.speed_slider import SpeedSlider
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.elided_label import ElidedLabel

FULL_SPEED = 127


class DriveControl(QWidget):
    """A slider and an entry box that always show the same speed.

    It shows a wish and asks for another; it does not decide what is sent. Where channels drive,
    a bar of what they wish for stands in its place. The mouse wheel scrolls the page and never
    drives a motor.

    Signals:
        speed_wanted: a speed of `lowest` to 127 that a person chose.
        brake_wanted: the brake button was pressed.
        grabbed, released: a hand is on the slider, or no longer.
    """

    speed_wanted = Signal(int)
    brake_wanted = Signal()
    grabbed = Signal()
    released = Signal()

    def __init__(
        self, title: str, name: str, *, two_way: bool = True, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._two_way = two_way
        lowest = -FULL_SPEED if two_way else 0

        self._title = ui.label(self, f"{name}Title", bold=True)
        self._slider = ui.named(SpeedSlider(lowest, self), f"{name}Slider")
        self._entry = ui.named(SpeedEntry(self), f"{name}Entry")
        self._entry.setRange(-FULL_SPEED, FULL_SPEED)
        self._entry.setMinimumWidth(self._entry.sizeHint().width() + 8)  # as wide with any range
        self._entry.setRange(lowest, FULL_SPEED)
        for widget in (self._slider, self._entry):
            widget.installEventFilter(self)
        self._zero = ui.button(
            self,
            f"{name}Zero",
            self.tr("Zero"),
            tip=self.tr("Speed 0: the motor is not driven and coasts"),
            on_click=self._on_zero_clicked,
        )
        self._brake = ui.button(self, f"{name}Brake", self.tr("Brake"), on_click=self.brake_wanted)
        self._bar = ui.named(OutputBar(self, bipolar=two_way), f"{name}Channel")
        self._bar.hide()
        self._asked = ui.label(self, f"{name}Asked")
        self._reported = ui.named(
            ElidedLabel(self.tr("Board: serial in control, 10.00 A…"), self), f"{name}Reported"
        )
        self._reported.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        for button in (self._zero, self._brake):
            button.setMinimumWidth(button.fontMetrics().horizontalAdvance(button.text()) + 20)
        if not two_way:
            self._brake.hide()

        layout = ui.grid(self, margins=0, spacing=(8, 2))
        words = ui.row(self._title, self._asked, 1, self._reported, spacing=10)
        layout.addLayout(words, 0, 0, 1, 4)
        layout.addWidget(self._slider, 1, 0)
        layout.addWidget(self._entry, 1, 1, Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self._zero, 1, 2, Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self._brake, 1, 3, Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self._bar, 2, 0, 1, 4)
        layout.setColumnStretch(0, 1)
        # Without a brake its room is kept: the sliders of all motors are as long.
        layout.setColumnMinimumWidth(3, self._brake.sizeHint().width())

        self._slider.valueChanged.connect(self._on_slider_changed)
        self._slider.grabbed.connect(self.grabbed)
        self._slider.released.connect(self.released)
        self._entry.chosen.connect(self._on_entry_chosen)
        self.set_title(title)

    @property
    def is_held(self) -> bool:
        """Whether a hand is on the slider."""
        return self._slider.held

    def set_title(self, title: str) -> None:
        """Name the motor, in sight and for who does not see it."""
        self._title.setText(title)
        self._slider.setAccessibleName(self.tr("{0}, speed").format(title))
        self._entry.setAccessibleName(self.tr("{0}, speed as a number").format(title))
        self._zero.setAccessibleName(self.tr("{0}, speed zero").format(title))
        self._brake.setAccessibleName(self.tr("{0}, brake").format(title))
        self._bar.setAccessibleName(self.tr("{0}, what its channel wishes").format(title))

    def set_ceiling(self, ceiling: int) -> None:
        """Offer no speed beyond this one, 1-127."""
        self._slider.set_ceiling(ceiling)
        self._entry.set_limits(-ceiling if self._two_way else 0, ceiling)

    def set_brake_text(self, tip: str) -> None:
        """Say what the brake button does now."""
        self._brake.setToolTip(tip)
        self._brake.setAccessibleDescription(tip)

    def set_channel_driven(self, driven: bool) -> None:
        """Show the bar of a channel in place of everything that asks for a speed."""
        for widget in (self._slider, self._entry, self._zero):
            widget.setVisible(not driven)
        self._brake.setVisible(self._two_way and not driven)
        self._bar.setVisible(driven)

    def show_channel(self, value: int | None) -> None:
        """Show what a channel wishes for, -127 to 127; `None`: it has no signal."""
        self._bar.set_connected(True)
        self._bar.set_value(value if value is None or self._two_way else abs(value))

    def show_wish(self, speed: int, text: str) -> None:
        """Show the wish in force, without asking for it again."""
        with QSignalBlocker(self._slider):
            if not self._slider.isSliderDown():
                self._slider.setValue(speed)
        self._entry.show_wish(speed)
        if self._asked.text() != text:
            self._asked.setText(text)

    def show_report(self, text: str) -> None:
        """Show what the board says of this motor."""
        self._reported.show_text(text)

    def let_go(self) -> None:
        """End a drag that is under way, so that the slider can be set."""
        self._slider.let_go()
        self._slider.setSliderDown(False)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() == QEvent.Type.Wheel:
            event.ignore()
            return True
        return super().eventFilter(watched, event)

    @Slot(int)
    def _on_slider_changed(self, position: int) -> None:
        """The entry box holds the ceiling, which the slider comes back to."""
        self._entry.put(position)
        speed = self._entry.value()
        with QSignalBlocker(self._slider):
            self._slider.setValue(speed)
        self.speed_wanted.emit(speed)

    @Slot(int)
    def _on_entry_chosen(self, speed: int) -> None:
        with QSignalBlocker(self._slider):
            self._slider.setValue(speed)
        self.speed_wanted.emit(speed)

    @Slot()
    def _on_zero_clicked(self) -> None:
        self.speed_wanted.emit(0)
