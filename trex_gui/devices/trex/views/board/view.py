"""Drawing of the board and its live state."""

from collections.abc import Callable, Mapping
from functools import partial

from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Signal
from PySide6.QtGui import QPaintEvent, QPen, QResizeEvent, QShowEvent
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import Number, tr, tr_noop
from trex_gui.devices.trex.board.drive_status import AUXILIARY, DriveInputs, SetpointSource
from trex_gui.devices.trex.board.errors import error_names
from trex_gui.devices.trex.board.quality import quality_text
from trex_gui.devices.trex.driving.board_reasons import LED_TEXTS, PACKETS, led_patterns
from trex_gui.devices.trex.model.channel_text import CHANNEL_NAMES
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.drive_status import drive_inputs, setpoint_of
from trex_gui.devices.trex.model.drive_texts import direction_text, limit_text, setpoint_text
from trex_gui.devices.trex.protocol.flags import CHANNELS, Mode, Status, UartError
from trex_gui.devices.trex.views.bars import input_axis
from trex_gui.devices.trex.views.board.parts import (
    WHEEL,
    BoardPart,
    ChannelPart,
    JumperPart,
    LedPart,
    MotorPart,
    SerialPart,
)
from trex_gui.ui.runtime import now
from trex_gui.ui.theme.theme import follow_theme, scaled_font, theme
from trex_gui.ui.widgets.circuit import paint_block, paint_body, text_width
from trex_gui.ui.widgets.painted import Animation, Painter, never_mirror

# Texts for setpoints without a speed.
_SOURCES = {
    SetpointSource.UNKNOWN: tr_noop("not known"),
    SetpointSource.JOINT: tr_noop("works with motor 1"),
    SetpointSource.SAFE_START: tr_noop("held by safe-start"),
    SetpointSource.NOT_ARMED: tr_noop("not armed"),
}

_WIRE = 1.4  # lines of text between the board and the parts beside it
_MIN_HEIGHT, _HEIGHT = 20, 26  # lines of text
_SERIAL = 3.4  # lines of text: height of the serial part, including 0.8 lines over the board
_MAX_SCALE = 1.5  # maximum font scale, unless `_MANY_LINES` lines fit at a larger scale
_MANY_LINES = 30


class BoardView(QWidget):
    page_requested = Signal(str)  # page key

    def __init__(self, device: Device, parent: QWidget) -> None:
        super().__init__(parent)
        never_mirror(self)
        self.setObjectName("boardView")
        self.setAccessibleName(tr("The board"))
        self._device = device
        self._body = QRect()
        self._shown_name = self._name()
        self._started = now()
        self._motion = Animation(self, self._on_frame)

        def opener(page: str) -> Callable[[], object]:
            return partial(self.page_requested.emit, page)

        errors, settings, traffic = opener("errors"), opener("parameters"), opener("transcript")
        channels, motors = opener("channels"), opener("motors")
        self._channels = {
            number: ChannelPart(
                f"Channel{number}",
                tr("Channel {0}: {1}").format(number, tr(CHANNEL_NAMES[number])),
                channels,
                self,
            )
            for number in CHANNELS
        }
        self._leds = (
            LedPart("RedLed", tr("{0} LED").format(tr("Red")), errors, self, "led_red"),
            LedPart("GreenLed", tr("{0} LED").format(tr("Green")), errors, self, "led_green"),
        )
        self._mode = JumperPart("ModeJumper", tr("Mode jumper"), settings, self)
        self._mix = JumperPart("MixJumper", tr("Mix jumper"), channels, self)
        self._so_ground = JumperPart("SoGroundJumper", tr("SO–G jumper"), traffic, self)
        self._motors = {
            1: MotorPart("Motor1", tr("Motor 1"), motors, self, "motor1"),
            2: MotorPart("Motor2", tr("Motor 2"), motors, self, "motor2"),
            AUXILIARY: MotorPart("Motor3", tr("Auxiliary"), motors, self, "auxiliary"),
        }
        self._serial = SerialPart("Serial", tr("Serial line"), errors, self)
        follow_theme(self, "space", self._place)

    # --- Layout -------------------------------------------------------------------------

    def _columns(self) -> tuple[tuple[float, float], ...]:
        """Return the least and greatest widths of channels, board and motors, in lines of text."""
        font, line = self.font(), self.fontMetrics().height()
        roles = text_width(font, *(f"CH5  {tr(role)}  2000 µs " for role in CHANNEL_NAMES.values()))
        words = f"{tr('not armed')} {tr('reverse')} {tr('limit {0:.1f} A').format(88.8)}".split()
        names = [part.accessibleName() for part in self._motors.values()]
        motors = text_width(font, *names, *words) / line + WHEEL + 2
        return (roles / line + 1, roles / line + 8), (14, 28), (motors, 17)

    def minimumSizeHint(self) -> QSize:
        width, line = sum(minimum for minimum, _ in self._columns()), self.fontMetrics().height()
        return QSize(round((width + 2 * _WIRE) * line) + 1, _MIN_HEIGHT * line)

    def sizeHint(self) -> QSize:
        width, line = sum(maximum for _, maximum in self._columns()), self.fontMetrics().height()
        return QSize(round((width + 2 * _WIRE) * line) + 1, _HEIGHT * line)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._place()

    def _place(self) -> None:
        self.updateGeometry()
        min_size, base, width = self.minimumSizeHint(), self.fontMetrics().height(), self.width()
        max_scale = max(_MAX_SCALE, self.height() / base / _MANY_LINES)
        scale = min(width / min_size.width(), self.height() / min_size.height(), max_scale)
        line = round(base * max(1.0, scale))
        for part in self.findChildren(BoardPart):
            part.setFont(scaled_font(self.font(), line / base))
        extra = max(0.0, width / line - min_size.width() / base)  # spare width, in lines of text
        columns = [
            round(line * min(maximum, minimum + extra / 4)) for minimum, maximum in self._columns()
        ]
        wire = round(min(5.0, _WIRE + extra / 8) * line)
        left = max(0, (width - sum(columns) - 2 * wire) // 2)
        channels, body, motors = columns
        body_height = self.height() - round((_SERIAL - 0.8) * line)
        self._body = QRect(left + channels + wire, 1, body, body_height)
        beside = QRect(left, 1, channels, body_height - 8)  # keeps all blocks between the holes
        self._place_column(self._channels, beside, round(2.8 * line))
        right = self._body.right() + wire
        self._place_column(
            self._motors, QRect(right, 1, motors, body_height), round(body_height / 3) - 4
        )
        inside = self._body.adjusted(line + 4, 0, -line - 4, 0)  # area without blocks and holes
        top = round(3.2 * line)
        half = inside.width() // 2
        for number, led in enumerate(self._leds):
            led.setGeometry(inside.left() + number * half, top, half, round(2.4 * line))
        step = (self._body.bottom() - line - top - 2 * line) // 3
        for number, jumper in enumerate((self._mode, self._mix, self._so_ground)):
            area = QRect(inside.left(), top + round(2.4 * line) + number * step, inside.width(), 0)
            area.setHeight(min(step, round(4.5 * line)))
            jumper.setGeometry(area)
        bottom = self._body.bottom() - round(0.8 * line)
        self._serial.body_width = self._body.width()
        width = left + sum(columns) + 2 * wire - self._body.left()
        self._serial.setGeometry(self._body.left(), bottom, width, self.height() - bottom)

    def _place_column(self, parts: Mapping[int, BoardPart], area: QRect, height: int) -> None:
        step = area.height() / len(parts)
        for number, part in enumerate(parts.values()):
            top = round(area.top() + (number + 0.5) * step - height / 2)
            part.setGeometry(area.left(), top, area.width(), height)

    def paintEvent(self, event: QPaintEvent) -> None:
        body, line = QRectF(self._body), self._serial.fontMetrics().height()
        with Painter(self) as painter:
            painter.setPen(QPen(theme().color("board_edge"), 5))
            for part in self._channels.values():
                y = part.y() + part.bar_y
                painter.drawLine(QPointF(part.geometry().right() + 8, y), QPointF(body.left(), y))
            for motor in self._motors.values():
                y = motor.geometry().center().y()
                painter.drawLine(QPointF(body.right(), y), QPointF(motor.x() + 4, y))
            if not event.region().intersects(self._body.adjusted(-6, 0, line, 0)):
                return
            painter.setFont(self._serial.font())
            paint_body(painter, body, self._shown_name)
            for part in self._channels.values():
                y = part.y() + part.bar_y
                paint_block(painter, QRectF(body.left() - 6, y - line / 2, 12, line))
            for motor in self._motors.values():
                y = motor.geometry().center().y()
                paint_block(painter, QRectF(body.right() - line, y - line, 1.7 * line, 2 * line))

    def _name(self) -> str:
        state, settings = self._device.state, self._device.settings
        name = "TReX" if state is None else state.signature.model.name
        if settings is None or not settings.group:
            return name
        return f"{name} · {settings.device_number}"

    # --- State --------------------------------------------------------------------------

    def show_board(self, inputs: DriveInputs) -> None:
        device = self._device
        board = inputs.board if inputs.link is None else None
        self._show_channels()
        self._show_jumpers()
        self._show_motors(inputs)
        patterns = ("", "") if board is None else led_patterns(board)
        for led, name, pattern in zip(self._leds, (tr("Red"), tr("Green")), patterns, strict=True):
            led.pattern = pattern
            words = tr(LED_TEXTS[pattern], "LED") if pattern else tr("unknown")
            led.show_lines(name, tr("flickers") if pattern == PACKETS else words)
        quality, is_connected = device.board.quality, device.is_connected
        text = quality_text(quality) if is_connected else tr("not responding")
        if quality.is_noisy is False:
            answered = Number(100 * (1 - quality.lost))
            text = tr("{0:.0f} reads/s, {1:.1f} % answered").format(Number(quality.rate), answered)
        alarm = "warning" if quality.is_noisy or not is_connected else ""
        recent = device.board.errors.recent(1, now()) if is_connected else []
        if errors := [tr(entry.name) for entry in recent if isinstance(entry.bit, UartError)]:
            text, alarm = ", ".join(errors), "danger"
        self._serial.color = alarm or "led_green"
        self._serial.show_lines(text, alarm=alarm)
        self._show_leds()
        motors = self._motors.values()
        is_blinking = any(led.is_blinking for led in self._leds)
        self._motion.run(is_blinking or any(motor.speed for motor in motors))
        if self._name() != self._shown_name:
            self._shown_name = self._name()
            self.update()

    def _show_channels(self) -> None:
        device, state = self._device, self._device.state
        for number, part in self._channels.items():
            name = tr(CHANNEL_NAMES[number])
            title = tr("CH{0}").format(number)
            if state is None or device.telemetry.raw is None:
                part.show_lines(title, name, "–")
                part.show_input((0, 1), None, None)
                continue
            count, curve = device.telemetry.raw_of(number), device.draft.stored_curve(number)
            value = tr("no signal") if count is None else state.source.text(count)
            calibration = None if curve is None else curve.calibration
            part.show_lines(title, name, value)
            part.show_input(input_axis(state.source, calibration, count), count, calibration)

    def _show_jumpers(self) -> None:
        device = self._device
        state = device.state if device.is_connected else None
        if state is None:
            self._mode.show_jumper(None, tr("Mode jumper"), tr("not known"))
        elif state.mode.is_serial:
            self._mode.show_jumper(False, tr("Mode: off"), tr("serial mode"))
        else:
            name = tr("RC") if state.mode is Mode.RC else tr("Analog")
            words = tr("channels drive")
            if device.board.serial_controls:
                words = tr("channel 5 selects serial")
            self._mode.show_jumper(True, tr("Mode: {0}").format(name), words)
        mix = device.mix_jumper.is_on if state is not None else None
        if mix is None:
            hint = tr("not known") if state is None else tr("unknown: move a stick to find out")
            self._mix.show_jumper(None, tr("Mix jumper"), hint)
        else:
            words = (
                tr("one stick drives both motors") if mix else tr("each channel drives one motor")
            )
            if state is not None and state.mode.is_serial:
                words = tr("for RC and analog mode")
            self._mix.show_jumper(mix, tr("Mix: on") if mix else tr("Mix: off"), words)
        so_ground = device.board.so_ground
        if so_ground is None:
            self._so_ground.show_jumper(None, tr("SO–G jumper"), tr("not known"))
        else:
            words = tr("replies arrive")
            self._so_ground.show_jumper(so_ground, tr("SO–G: off"), words)

    def _show_motors(self, inputs: DriveInputs) -> None:
        device = self._device
        for number, part in self._motors.items():
            drive = device.drive_of(number)
            setpoint = setpoint_of(device, number, inputs)
            is_off = inputs.board is not None and number in inputs.board.shut_down
            speed = 0 if is_off else setpoint.speed
            lines, alarm = [part.accessibleName()], ""
            if text := _SOURCES.get(setpoint.source):
                lines.append(tr(text))
            elif number == AUXILIARY:
                lines.append(str(setpoint.speed))
            elif setpoint.source is SetpointSource.SERIAL and (drive is None or drive.is_brake):
                lines.append(setpoint_text(drive))
            else:
                lines.append(direction_text(speed))
            faults = []
            if number != AUXILIARY and inputs.link is None:
                recent = device.board.errors.recent(number, now())
                faults = [entry for entry in recent if isinstance(entry.bit, Status)]
            is_alarming = bool(faults or setpoint.may_turn)
            if number != AUXILIARY and not device.board.is_joint:
                currents = device.telemetry.motor_currents
                if currents is not None:
                    lines.append(f"{Number(currents[number - 1]):.2f} A")
                if not is_alarming:  # there is space for only one more line
                    lines.append(limit_text(device, number))
            if faults:
                lines.append(error_names(faults))
                alarm = "warning" if all(entry.is_doubtful for entry in faults) else "danger"
            elif setpoint.may_turn:
                lines.append(tr("may still turn"))
                alarm = "danger"
            part.show_speed(0 if setpoint.may_turn else speed)
            part.show_lines(*lines, alarm=alarm)

    # --- Animation ----------------------------------------------------------------------

    def _show_leds(self) -> None:
        moment = now() - self._started if self._motion.is_enabled else 0.0
        for led in self._leds:
            led.show_moment(moment)

    def _on_frame(self, seconds: float) -> None:
        self._show_leds()
        for motor in self._motors.values():
            motor.turn(seconds)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.show_board(drive_inputs(self._device))
