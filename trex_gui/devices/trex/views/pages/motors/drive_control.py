"""Controls of one motor: slider, entry box, zero and brake, and what the board reports."""

from PySide6.QtCore import QEvent, QRect, QSignalBlocker, QSize, Qt, Signal, Slot
from PySide6.QtGui import QKeyEvent, QMouseEvent, QPainter, QPen, QWheelEvent
from PySide6.QtWidgets import QSpinBox, QWidget

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.descriptions import CURRENT_ACCURACY
from trex_gui.devices.trex.views.bars import CurrentBar, OutputBar
from trex_gui.ui.theme.theme import set_look, set_text_color, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import keep_room
from trex_gui.ui.widgets.labels import ElidedLabel
from trex_gui.ui.widgets.sliders import PressSlider

_MARKS = (-127, -64, 0, 64, 127)
_MOVING_KEYS = {
    *(Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down),
    *(Qt.Key.Key_PageUp, Qt.Key.Key_PageDown),
}
_DISCARDS = {  # events that discard a half-typed number
    *(QEvent.Type.FocusOut, QEvent.Type.Hide, QEvent.Type.WindowDeactivate, QEvent.Type.Close),
}


class SpeedSlider(PressSlider):
    """Horizontal, from `lowest` to 127; keys that move it hold it, too.

    End and the wheel do nothing: neither one key nor scrolling must drive a motor.
    """

    def __init__(self, lowest: int, parent: QWidget | None = None, color: str = "bar") -> None:
        """`color` is that of the motor in the theme."""
        super().__init__(lowest, FULL_SCALE, parent)
        self._color = color
        self._ceiling = FULL_SCALE
        self.setPageStep(16)

    def set_ceiling(self, ceiling: int) -> None:
        self._ceiling = ceiling
        self.update()

    def limited(self, speed: int) -> int:
        return max(-self._ceiling, min(speed, self._ceiling))

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """End the hold if the release of the button was not reported."""
        if self.isSliderDown() and not event.buttons() & Qt.MouseButton.LeftButton:
            self.release()
        super().mouseMoveEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        match event.key():
            case Qt.Key.Key_Home | Qt.Key.Key_0:
                self.setValue(0)
                return
            case Qt.Key.Key_End:
                return
            case key if key in _MOVING_KEYS:
                if event.isAutoRepeat() and not self.held:
                    return  # the hold has ended; the key has to be pressed again
                self.grab_handle()
        super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """End the hold with any key: a pressed arrow may be released as a digit (Num Lock)."""
        super().keyReleaseEvent(event)
        if not event.isAutoRepeat() and not self.isSliderDown():
            self.release()

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()

    def sizeHint(self) -> QSize:
        hint = super().sizeHint()
        return QSize(max(hint.width(), 240), hint.height() + self.fontMetrics().height() + 10)

    def minimumSizeHint(self) -> QSize:
        return QSize(150, self.sizeHint().height())

    def room_below(self) -> int:
        return self.fontMetrics().height() + 6

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        middle = handle.center().y()
        left, right = self.x_of(self.minimum(), handle), self.x_of(self.maximum(), handle)
        groove = QRect(left, middle - 3, right - left, 7)
        painter.setPen(QPen(theme().color("track_edge")))
        painter.setBrush(theme().color("track_off"))
        painter.drawRoundedRect(groove, 3, 3)
        if not self.isEnabled():
            return
        ends = max(-self._ceiling, self.minimum()), self._ceiling
        start, end = (self.x_of(value, handle) for value in ends)
        painter.setBrush(theme().color("track"))
        painter.drawRoundedRect(QRect(start, middle - 3, end - start, 7), 3, 3)
        if self._ceiling < self.maximum():
            for x in (start, end):
                painter.fillRect(x - 1, middle - 7, 2, 15, theme().color("mark"))
        zero, here = self.x_of(0, handle), handle.center().x()
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(theme().color(self._color))
        painter.drawRect(QRect(min(zero, here), middle - 2, abs(here - zero), 5))

    def paint_below(self, painter: QPainter, handle: QRect) -> None:
        painter.setPen(self.palette().color(self.foregroundRole()))
        metrics = self.fontMetrics()
        top = handle.bottom() + 2
        for value in _MARKS:
            if value < self.minimum():
                continue
            x = self.x_of(value, handle)
            painter.drawLine(x, top, x, top + 4)
            text = signed_text(value) if self.minimum() < 0 else str(value)
            width = metrics.horizontalAdvance(text)
            place = min(max(x - width // 2, 0), self.width() - width)
            painter.drawText(place, top + 6 + metrics.ascent(), text)


class SpeedEntry(QSpinBox):
    """Reports a speed on Enter and on steps.

    Qt's own box also accepts a half-typed number when it loses the focus or is hidden: a motor
    would start because the user opened another page. Here the setpoint comes back.
    """

    chosen = Signal(int)  # the speed that the user entered or stepped to

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
        if (lowest, highest) != (self.minimum(), self.maximum()):
            with QSignalBlocker(self):
                self.setRange(lowest, highest)
            self.put(self._setpoint)

    def show_setpoint(self, speed: int) -> None:
        """Show the setpoint, now or when a half-typed number is discarded."""
        self._setpoint = speed
        if not self._is_typed:
            self.put(speed)

    def put(self, speed: int) -> None:
        """Show a setpoint in place of anything typed."""
        self._setpoint = speed
        self._is_typed = False
        with QSignalBlocker(self):
            self.setValue(speed)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        is_entered = event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}
        is_accepted = is_entered and self._is_typed and self.hasAcceptableInput()
        super().keyPressEvent(event)
        if is_accepted and self._is_typed:  # Qt emits nothing for an unchanged number
            self._on_value_changed(self.value())
        elif is_entered:
            self.put(self._setpoint)

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()

    def event(self, event: QEvent) -> bool:
        if event.type() in _DISCARDS:
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


class DriveControl(QWidget):
    """Slider and entry of one speed, or a bar of the channel that drives; and the current."""

    speed_wanted = Signal(int)  # a speed of 0 or -127 to 127 that the user chose
    brake_wanted = Signal()

    def __init__(
        self, title: str, name: str, *, two_way: bool = True, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._two_way = two_way
        lowest = -FULL_SCALE if two_way else 0

        self._title = ui.label(self, f"{name}Title", bold=True)
        # Its signals report whether the user holds it
        color = "auxiliary" if name == "aux" else name
        set_text_color(self._title, color)
        self.slider = ui.named(SpeedSlider(lowest, self, color), f"{name}Slider")
        self._entry = ui.named(SpeedEntry(self), f"{name}Entry")
        self._entry.setRange(-FULL_SCALE, FULL_SCALE)
        self._entry.setMinimumWidth(self._entry.sizeHint().width() + 8)  # as wide with any range
        self._entry.setRange(lowest, FULL_SCALE)
        self._zero = ui.button(
            self,
            f"{name}Zero",
            tr("Zero"),
            tip=tr("Speed 0: the motor is not driven and coasts"),
            on_click=lambda: self.speed_wanted.emit(0),
        )
        self.brake = ui.button(self, f"{name}Brake", tr("Brake"), on_click=self.brake_wanted)
        self._bar = ui.named(OutputBar(self, bipolar=two_way), f"{name}Channel")
        self._bar.hide()
        self._setpoint_label = ui.label(self, f"{name}Setpoint")
        reported = ElidedLabel(tr("Board: serial in control…"), self)
        self.reported = ui.named(reported, f"{name}Reported")
        self.reported.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        for button in (self._zero, self.brake):
            set_look(button, "compact")
        self.current = ui.named(CurrentBar(self), f"{name}Current")
        tip = tr("Current of this motor; the red line is its limit, ⚠ means 80 % of it or more.")
        self.current.setToolTip(ui.plain(f"{tip} {tr(CURRENT_ACCURACY)}"))
        if not two_way:  # so that all sliders have the same length
            keep_room(self.brake)
        for widget in (self.brake, self.current):
            widget.setVisible(two_way)

        words = ui.row(self._title, self._setpoint_label, 1, self.reported, spacing=10)
        numbers = ui.row(self._entry, self._zero, self.brake, 1, spacing=4)
        beside = ui.column(numbers, self.current, 1, spacing=1)
        speed = ui.column(self.slider, self._bar, 1, spacing=0)
        halves = ui.row((speed, 3), (beside, 1), spacing=4)
        ui.column(words, halves, into=self, margins=0, spacing=2)

        self.slider.valueChanged.connect(self._on_slider_changed)
        self._entry.chosen.connect(self._on_entry_chosen)
        self.set_title(title)

    def set_title(self, title: str) -> None:
        self._title.setText(title)
        self.slider.setAccessibleName(tr("{0}, speed").format(title))
        self._entry.setAccessibleName(tr("{0}, speed as a number").format(title))
        self._zero.setAccessibleName(tr("{0}, speed zero").format(title))
        self.brake.setAccessibleName(tr("{0}, brake").format(title))
        self._bar.setAccessibleName(tr("{0}, channel command").format(title))
        self.current.setAccessibleName(tr("{0}, current").format(title))

    def set_ceiling(self, ceiling: int) -> None:
        """Offer no speed beyond this one, 1-127, either way."""
        self.slider.set_ceiling(ceiling)
        one_way = tr("From 0 to 127, full speed")
        two_way = tr("From −127, full speed back, to 127, full speed forward")
        tip = two_way if self._two_way else one_way
        if ceiling < FULL_SCALE:
            tip = tr("Up to {0}, the speed ceiling above").format(ceiling)
        for widget in (self.slider, self._entry):
            widget.setToolTip(ui.plain(tip))
        self._entry.set_limits(-ceiling if self._two_way else 0, ceiling)

    def set_channel_driven(self, driven: bool) -> None:
        for widget in (self.slider, self._entry, self._zero):
            widget.setVisible(not driven)
        self.brake.setVisible(self._two_way and not driven)
        self._bar.setVisible(driven)

    def show_channel(self, value: int | None) -> None:
        """Show the command of a channel, -127 to 127; `None`: no signal."""
        self._bar.set_connected(True)
        self._bar.set_value(value if value is None or self._two_way else abs(value))

    def show_setpoint(self, speed: int, text: str) -> None:
        if not self.slider.isSliderDown():
            self._move_slider(speed)
        self._entry.show_setpoint(speed)
        self._setpoint_label.setText(text)

    def release(self) -> None:
        """End a drag, so that the slider can be set."""
        self.slider.release()
        self.slider.setSliderDown(False)

    @Slot(int)
    def _on_slider_changed(self, position: int) -> None:
        speed = self.slider.limited(position)
        self._entry.put(speed)
        self._on_entry_chosen(speed)

    @Slot(int)
    def _on_entry_chosen(self, speed: int) -> None:
        self._move_slider(speed)
        self.speed_wanted.emit(speed)

    def _move_slider(self, speed: int) -> None:
        with QSignalBlocker(self.slider):
            self.slider.setValue(speed)
