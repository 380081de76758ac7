"""The controls of one motor: slider, entry box, zero and brake, and what the board reports."""

from PySide6.QtCore import QEvent, QObject, QRect, QSignalBlocker, QSize, Qt, Signal, Slot
from PySide6.QtGui import QFocusEvent, QHideEvent, QKeyEvent, QMouseEvent, QPainter, QPen
from PySide6.QtWidgets import QSpinBox, QWidget

from trex_gui.devices.trex.views.bars import OutputBar
from trex_gui.devices.trex.views.driving.press_monitor import PressMonitor
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.labels import ElidedLabel
from trex_gui.ui.widgets.sliders import PressSlider

_MARKS = (-127, -64, 0, 64, 127)

_MOVING_KEYS = {
    *(Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down),
    *(Qt.Key.Key_PageUp, Qt.Key.Key_PageDown),
}


class SpeedSlider(PressSlider):
    """Horizontal, from `lowest` to 127; the groove is filled from zero to the handle.

    Qt's own slider fills from the left end and has no tick at zero for such a range. Home is
    zero, and End does nothing: one key must not mean full speed.

    Signals:
        grabbed: a mouse button or a key that moves it went down.
        released: that is over, or unknown: the focus is gone, or it is hidden,
            disabled, or covered by a menu or a dialog.
    """

    def __init__(self, lowest: int, parent: QWidget | None = None) -> None:
        super().__init__(lowest, 127, parent)
        self._ceiling = 127
        self._watch = PressMonitor(self)
        self.setPageStep(16)

        self._watch.lost.connect(self.let_go)
        self.grabbed.connect(self._watch.begin)
        self.released.connect(self._watch.end)

    def set_ceiling(self, ceiling: int) -> None:
        """Show up to which speed, 1-127, it is of use, either way."""
        if ceiling != self._ceiling:
            self._ceiling = ceiling
            self.update()

    # --- Hands --------------------------------------------------------------------------

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Let go where the button went up unseen."""
        if self.isSliderDown() and not event.buttons() & Qt.MouseButton.LeftButton:
            self.let_go()
        super().mouseMoveEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        match event.key():
            case Qt.Key.Key_Home | Qt.Key.Key_0:
                self.setValue(0)
            case Qt.Key.Key_End:
                pass
            case key if key in _MOVING_KEYS:
                if event.isAutoRepeat() and not self.held:
                    return  # it was let go meanwhile; the key has to go down anew
                self.grab_handle()
                super().keyPressEvent(event)
            case _:
                super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Let go with any key: what went down as an arrow may go up as a digit (Num Lock)."""
        super().keyReleaseEvent(event)
        if not event.isAutoRepeat() and not self.isSliderDown():
            self.let_go()

    # --- Looks --------------------------------------------------------------------------

    def sizeHint(self) -> QSize:
        hint = super().sizeHint()
        return QSize(max(hint.width(), 240), hint.height() + self.fontMetrics().height() + 10)

    def minimumSizeHint(self) -> QSize:
        return QSize(150, self.sizeHint().height())

    def room_below(self) -> int:
        """Leave room for the numbers."""
        return self.fontMetrics().height() + 6

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        """Paint the groove, its useful part, and the fill from zero."""
        middle = handle.center().y()
        left, right = self.x_of(self.minimum(), handle), self.x_of(self.maximum(), handle)
        groove = QRect(left, middle - 3, right - left, 7)
        painter.setPen(QPen(theme().color("track_edge")))
        painter.setBrush(theme().color("track_off"))
        painter.drawRoundedRect(groove, 3, 3)
        if self.isEnabled():  # as far as the ceiling lets it go
            start = self.x_of(max(-self._ceiling, self.minimum()), handle)
            end = self.x_of(self._ceiling, handle)
            painter.setBrush(theme().color("track"))
            painter.drawRoundedRect(QRect(start, middle - 3, end - start, 7), 3, 3)
        if not self.isEnabled():
            return
        zero, here = self.x_of(0, handle), handle.center().x()
        name = "bar_negative" if self.sliderPosition() < 0 else "bar"
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme().color(name))
        painter.drawRect(QRect(min(zero, here), middle - 2, abs(here - zero), 5))

    def paint_below(self, painter: QPainter, handle: QRect) -> None:
        """Paint ticks and numbers."""
        painter.setPen(self.palette().color(self.foregroundRole()))
        metrics = self.fontMetrics()
        top = handle.bottom() + 2
        for value in _MARKS:
            if value < self.minimum():
                continue
            x = self.x_of(value, handle)
            painter.drawLine(x, top, x, top + 4)
            text = f"+{value}" if value > 0 and self.minimum() < 0 else str(value)
            text = text.replace("-", "−")
            width = metrics.horizontalAdvance(text)
            place = min(max(x - width // 2, 0), self.width() - width)
            painter.drawText(place, top + 6 + metrics.ascent(), text)


class SpeedEntry(QSpinBox):
    """Asks for a speed on Enter and on steps.

    Qt's own box takes a half-typed number, too, when it loses the focus or is hidden: a motor
    would start because the user looked at another page. Here the number is discarded, and the
    speed in force comes back.

    Signals:
        chosen: the speed that the user entered or stepped to.
    """

    chosen = Signal(int)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._setpoint = 0
        self._is_typed = False
        self.setKeyboardTracking(False)
        self.setAlignment(Qt.AlignmentFlag.AlignRight)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

        self.lineEdit().textEdited.connect(self._on_edited)
        self.valueChanged.connect(self._on_value_changed)

    def set_limits(self, lowest: int, highest: int) -> None:
        """Offer these speeds; a half-typed number is given up when they are others."""
        if (lowest, highest) != (self.minimum(), self.maximum()):
            with QSignalBlocker(self):
                self.setRange(lowest, highest)
            self.put(self._setpoint)

    def show_setpoint(self, speed: int) -> None:
        """Show the speed in force, now or when no half-typed number is in the box any more."""
        self._setpoint = speed
        if not self._is_typed:
            self.put(speed)

    def put(self, speed: int) -> None:
        """Show a speed, whatever was typed, without asking for it."""
        self._setpoint = speed
        self._is_typed = False
        with QSignalBlocker(self):
            self.setValue(speed)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        is_entered = event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}
        is_meant = is_entered and self._is_typed and self.hasAcceptableInput()
        super().keyPressEvent(event)
        if is_meant and self._is_typed:  # the number that was there before: Qt is silent
            self._on_value_changed(self.value())
        elif is_entered:
            self.put(self._setpoint)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        self.put(self._setpoint)
        super().focusOutEvent(event)

    def hideEvent(self, event: QHideEvent) -> None:
        self.put(self._setpoint)
        super().hideEvent(event)

    def event(self, event: QEvent) -> bool:
        if event.type() in {QEvent.Type.WindowDeactivate, QEvent.Type.Close}:
            self.put(self._setpoint)
        return super().event(event)

    @Slot()
    def _on_edited(self) -> None:
        self._is_typed = True

    @Slot(int)
    def _on_value_changed(self, speed: int) -> None:
        self._setpoint = speed
        self._is_typed = False
        self.chosen.emit(speed)


FULL_SPEED = 127


class DriveControl(QWidget):
    """A slider and an entry box that always show the same speed.

    It shows a setpoint and requests another; it does not decide what is sent. Where channels
    drive, a bar of their command replaces it. The mouse wheel scrolls the page and never
    drives a motor.

    Signals:
        speed_wanted: a speed of `lowest` to 127 that the user chose.
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
        self._setpoint_label = ui.label(self, f"{name}Asked")
        self._reported = ui.named(
            ElidedLabel(self.tr("Board: serial in control, 10.00 A…"), self), f"{name}Reported"
        )
        self._reported.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        for button in (self._zero, self._brake):
            button.setMinimumWidth(button.fontMetrics().horizontalAdvance(button.text()) + 20)
        if not two_way:
            self._brake.hide()

        layout = ui.grid(self, margins=0, spacing=(8, 2))
        words = ui.row(self._title, self._setpoint_label, 1, self._reported, spacing=10)
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
        self._bar.setAccessibleName(self.tr("{0}, channel command").format(title))

    def set_ceiling(self, ceiling: int) -> None:
        """Offer no speed beyond this one, 1-127."""
        self._slider.set_ceiling(ceiling)
        self._entry.set_limits(-ceiling if self._two_way else 0, ceiling)

    def set_brake_text(self, tip: str) -> None:
        """Say what the brake button does now."""
        self._brake.setToolTip(tip)
        self._brake.setAccessibleDescription(tip)

    def set_channel_driven(self, driven: bool) -> None:
        """Show the bar of a channel in place of the controls that set a speed."""
        for widget in (self._slider, self._entry, self._zero):
            widget.setVisible(not driven)
        self._brake.setVisible(self._two_way and not driven)
        self._bar.setVisible(driven)

    def show_channel(self, value: int | None) -> None:
        """Show the command of a channel, -127 to 127; `None`: it has no signal."""
        self._bar.set_connected(True)
        self._bar.set_value(value if value is None or self._two_way else abs(value))

    def show_setpoint(self, speed: int, text: str) -> None:
        """Show the setpoint in force, without requesting it again."""
        with QSignalBlocker(self._slider):
            if not self._slider.isSliderDown():
                self._slider.setValue(speed)
        self._entry.show_setpoint(speed)
        if self._setpoint_label.text() != text:
            self._setpoint_label.setText(text)

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
