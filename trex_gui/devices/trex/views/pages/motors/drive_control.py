"""Controls of one motor: slider, entry box, buttons, current and report."""

from PySide6.QtCore import QEvent, QRect, QRectF, QSignalBlocker, QSize, Qt, Signal, Slot
from PySide6.QtGui import QKeyEvent, QPainter, QPen, QWheelEvent
from PySide6.QtWidgets import QSpinBox, QStyle, QStyleOptionSlider, QWidget

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.protocol.calibration import FULL_SCALE
from trex_gui.devices.trex.protocol.descriptions import CURRENT_ACCURACY
from trex_gui.ui.theme.theme import scaled_font, set_look, set_style_property, set_text_color, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.bar import WARNING_SIGN, LimitState, limit_state
from trex_gui.ui.widgets.labels import ElidedLabel, LiveLabel
from trex_gui.ui.widgets.sliders import PressSlider

_GROOVE, _HANDLE = 14, 36  # widths in pixels; the style sheet also contains the width of the handle
_MOVING_KEYS = {
    *(Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down),
    *(Qt.Key.Key_PageUp, Qt.Key.Key_PageDown),
}
_DISCARDING_EVENTS = {  # these events discard a half-typed number
    *(QEvent.Type.FocusOut, QEvent.Type.Hide, QEvent.Type.WindowDeactivate, QEvent.Type.Close)
}


class SpeedSlider(PressSlider):
    """Vertical slider from `lowest` to 127. A pressed key that moves the slider also holds it.

    The End key and the wheel have no effect: a motor must not jump to full speed or follow
    scrolling.
    """

    def __init__(self, lowest: int, parent: QWidget | None = None, color: str = "bar") -> None:
        super().__init__(lowest, FULL_SCALE, parent)
        self.setOrientation(Qt.Orientation.Vertical)
        set_look(self, color)
        self._color = color
        self.ceiling = 0  # maximum speed in both directions, 1 to 127
        self.setPageStep(16)

    def limited(self, speed: int) -> int:
        return max(-self.ceiling, min(speed, self.ceiling))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        match event.key():
            case Qt.Key.Key_Home | Qt.Key.Key_0:
                self.setValue(0)
                return
            case Qt.Key.Key_End:
                return
            case key if key in _MOVING_KEYS:
                if event.isAutoRepeat() and not self.held:
                    return  # the hold has ended, so the key must be pressed again
                self.grab_handle()
        super().keyPressEvent(event)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """End the hold when any key is released. Num Lock may turn an arrow key into a digit."""
        super().keyReleaseEvent(event)
        if not event.isAutoRepeat() and not self.isSliderDown():
            self.release()

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()

    def _side_space(self) -> int:
        """Return the space on each side of the handle in pixels. The scale is on the left side."""
        return self.fontMetrics().horizontalAdvance(f"{signed_text(FULL_SCALE)} ")

    def sizeHint(self) -> QSize:
        return QSize(_HANDLE + 2 * self._side_space(), 200)

    def minimumSizeHint(self) -> QSize:
        return QSize(self.sizeHint().width(), 6 * self.fontMetrics().height())

    def initStyleOption(self, option: QStyleOptionSlider) -> None:
        super().initStyleOption(option)
        option.rect = self.rect().adjusted(self._side_space(), 0, -self._side_space(), 0)

    def _y_of(self, value: int, handle: QRect) -> int:
        travel = self.height() - handle.height()
        return handle.height() // 2 + QStyle.sliderPositionFromValue(
            self.minimum(), self.maximum(), value, travel, upsideDown=True
        )

    def paint_groove(self, painter: QPainter, handle: QRect) -> None:
        color, left = theme().color, handle.center().x() + 0.5 - _GROOVE / 2
        ceiling = self.ceiling if self.isEnabled() else 0

        def between(first: int, second: int) -> QRectF:
            top, bottom = sorted(self._y_of(value, handle) for value in (first, second))
            return QRectF(left, top, _GROOVE, bottom - top)

        painter.setPen(QPen(color("track_edge")))
        for surface, low, high in (
            ("track_off", self.minimum(), self.maximum()),
            ("track", max(-ceiling, self.minimum()), ceiling),
        ):
            if high:
                painter.setBrush(color(surface))
                box = between(low, high).adjusted(0, -_GROOVE / 2, 0, _GROOVE / 2)
                painter.drawRoundedRect(box, _GROOVE / 2, _GROOVE / 2)
        painter.fillRect(between(0, self.value()).adjusted(2, 0, -2, 0), color(self._color))
        painter.setFont(scaled_font(self.font(), 0.85))
        height = painter.fontMetrics().height()
        for value in {self.minimum(), 0, self.maximum()}:
            y = self._y_of(value, handle)
            top = min(max(y - height // 2, 0), self.height() - height)
            text = signed_text(value) if self.minimum() else str(value)
            painter.setPen(color("muted"))
            painter.drawText(
                QRect(0, top, handle.left() - 4, height), Qt.AlignmentFlag.AlignRight, text
            )
            painter.fillRect(QRectF(left - 4, y, _GROOVE + 8, 1), color("mark"))


class SpeedEntry(QSpinBox):
    """Entry box that applies a typed number only on Enter.

    Qt's own box also accepts a half-typed number when it loses the focus or is hidden: a motor
    would start because the user opened another page. This box shows the setpoint again instead.
    """

    chosen = Signal(int)  # speed that the user has entered or stepped to

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
            self.set_speed(self._setpoint)

    def show_setpoint(self, speed: int) -> None:
        """Show the setpoint. A half-typed number remains until it is discarded."""
        self._setpoint = speed
        if not self._is_typed:
            self.set_speed(speed)

    def set_speed(self, speed: int) -> None:
        self._setpoint = speed
        if speed != self.value() or self._is_typed:  # Qt would repaint even an unchanged value
            self._is_typed = False
            with QSignalBlocker(self):
                self.setValue(speed)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        is_entered = event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter}
        is_accepted = is_entered and self._is_typed and self.hasAcceptableInput()
        super().keyPressEvent(event)
        if is_accepted and self._is_typed:  # Qt emits no signal for an unchanged number
            self._on_value_changed(self.value())
        elif is_entered:
            self.set_speed(self._setpoint)

    def wheelEvent(self, event: QWheelEvent) -> None:
        event.ignore()

    def event(self, event: QEvent) -> bool:
        if event.type() in _DISCARDING_EVENTS:
            self.set_speed(self._setpoint)
        return super().event(event)

    @Slot()
    def _on_edited(self) -> None:
        self._is_typed = True

    @Slot(int)
    def _on_value_changed(self, speed: int) -> None:
        self._setpoint = speed
        self._is_typed = False
        self.chosen.emit(speed)


class DriveControl(ui.Card):
    speed_requested = Signal(int)  # speed from 0 or -127 to 127
    brake_requested = Signal()

    def __init__(self, title: str, name: str, parent: QWidget, *, two_way: bool = True) -> None:
        super().__init__("", parent)
        set_look(self, "compact")
        self._two_way = two_way
        lowest = -FULL_SCALE if two_way else 0
        color = "auxiliary" if name == "aux" else name

        self._title = ui.label(self, f"{name}Title", size="heading")
        set_text_color(self._title, color)
        self.slider = ui.named(SpeedSlider(lowest, self, color), f"{name}Slider")
        self._entry = ui.named(SpeedEntry(self), f"{name}Entry")
        self._entry.setRange(lowest, FULL_SCALE)
        set_style_property(self._entry, "textSize", "title")
        ui.strip_style(self._entry, str(-FULL_SCALE))
        self._setpoint = ui.named(ElidedLabel("", self), f"{name}Setpoint")
        self._current = LiveLabel(f"{name}Current", "", self)
        ui.set_bold(self._current)
        tip = tr("⚠ means 80 % of the limit or more.")
        self._current.setToolTip(ui.plain(f"{tip} {tr(CURRENT_ACCURACY)}"))
        self._report = ui.named(ElidedLabel("", self), f"{name}Reported")
        texts = self._title, self._setpoint, self._current, self._report
        for label in (*texts, self._entry):
            label.setAlignment(Qt.AlignmentFlag.AlignCenter)
        for label in (self._setpoint, self._report):
            set_style_property(label, "textSize", "caption")
        tip = tr("Speed 0: the motor is not driven and coasts")
        self._zero = ui.button(self, f"{name}Zero", "0", tip=tip)
        self.brake = ui.button(self, f"{name}Brake", tr("Brake"), on_click=self.brake_requested)
        self.brake.setVisible(two_way)
        for button in (self._zero, self.brake):
            set_look(button, "compact")

        center = Qt.AlignmentFlag.AlignHCenter
        buttons = ui.row((self._zero, 1), (self.brake, 2), spacing=4)
        setpoint = (self.slider, 1, center), self._entry, self._setpoint
        parts = self._title, *setpoint, self._current, self._report, buttons
        ui.column(*parts, into=self, margins=0, spacing=2)

        self.slider.valueChanged.connect(self._on_slider_changed)
        self._zero.clicked.connect(lambda: self.speed_requested.emit(0))
        self._entry.chosen.connect(self._on_entry_chosen)
        self.set_title(title)

    def set_title(self, title: str) -> None:
        self._title.setText(title)
        self.setAccessibleName(title)
        self.slider.setAccessibleName(tr("{0}, speed").format(title))
        self._entry.setAccessibleName(tr("{0}, speed as a number").format(title))
        self._zero.setAccessibleName(tr("{0}, speed zero").format(title))
        self.brake.setAccessibleName(tr("{0}, brake").format(title))
        self._current.setAccessibleName(tr("{0}, current").format(title))

    def set_usable(self, usable: bool) -> None:
        for widget in (self.slider, self._entry, self._zero, self.brake):
            widget.setEnabled(usable)

    def set_ceiling(self, ceiling: int) -> None:
        if ceiling == self.slider.ceiling:
            return
        self.slider.ceiling = ceiling
        self.slider.update()
        for widget in (self.slider, self._entry):
            widget.setToolTip(ui.plain(tr("Up to {0}, the speed ceiling").format(ceiling)))
        self._entry.set_limits(-ceiling if self._two_way else 0, ceiling)

    def show_current(
        self, amps: float | None, limit: float | None, report: str, *, alarming: bool
    ) -> None:
        state = limit_state(amps, limit)
        sign = "" if state is LimitState.BELOW else f"{WARNING_SIGN} "
        self._current.setText("–" if amps is None else f"{sign}{Number(amps):.2f} A")
        set_text_color(self._current, state.value or "window_text")
        self._report.show_text(report)
        set_style_property(self._report, "danger", alarming)

    def show_setpoint(self, speed: int, text: str) -> None:
        if not self.slider.isSliderDown():
            self._move_slider(speed)
        self._entry.show_setpoint(speed)
        self._setpoint.show_text(text)

    def release(self) -> None:
        """End a drag, so that the program can move the slider."""
        self.slider.release()
        self.slider.setSliderDown(False)

    @Slot(int)
    def _on_slider_changed(self, position: int) -> None:
        speed = self.slider.limited(position)
        self._entry.set_speed(speed)
        self._on_entry_chosen(speed)

    @Slot(int)
    def _on_entry_chosen(self, speed: int) -> None:
        self._move_slider(speed)
        self.speed_requested.emit(speed)

    def _move_slider(self, speed: int) -> None:
        with QSignalBlocker(self.slider):
            self.slider.setValue(speed)
