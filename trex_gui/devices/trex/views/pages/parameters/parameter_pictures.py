"""Small drawings of the effects of parameters."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from itertools import pairwise

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.parameters.values import ParameterValues
from trex_gui.devices.trex.protocol.parameters import (
    FULL_SPEED_S,
    MotorParameter,
    ParameterKey,
    ParameterSpec,
    motor_name,
)
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.widgets.painted import Painted, Painter

Points = tuple[tuple[float, float], ...]  # x and y from 0 to 1; y increases upwards

_LINES = 7  # height in lines of text
_MARGIN = 10  # pixels
_SOLID, _DASHED = Qt.PenStyle.SolidLine, Qt.PenStyle.DashLine
_DOTTED = Qt.PenStyle.DotLine
_RC_LOSS_S = 0.5  # seconds until a required channel counts as lost
_COLORS = {"motor1": "motor1", "motor2": "motor2", "aux": "auxiliary"}


@dataclass(frozen=True, slots=True)
class Stroke:
    points: Points
    color: str = ""  # theme colour; if empty, the colour of the parameter
    style: Qt.PenStyle = _SOLID


@dataclass(frozen=True, slots=True)
class Picture:
    text: str  # description for screen readers
    caption: str
    lines: tuple[Stroke, ...]
    area: tuple[float, float, float] | None = None  # left, right and height of a filled area
    caption_position: tuple[float, float] = (0.5, 0.85)  # bottom centre of the caption


def picture_of(key: str, values: ParameterValues) -> Picture | None:
    """Return the drawing of a parameter, or `None` if it has no drawing or no value."""
    kind = key.partition("_")[2] if motor_name(key) else key
    wire, draw = values.value_of(key), _PICTURES.get(kind)
    return None if draw is None or wire is None else draw(values.specs[key], wire, values)


def _window(seconds: float, *steps: float) -> float:
    """Return the first step that is at least 20 % above `seconds`, or else the last step."""
    return next((step for step in steps if step >= 1.2 * seconds), steps[-1])


def _ramp(spec: ParameterSpec, wire: int, _values: ParameterValues) -> Picture:
    seconds, value = FULL_SPEED_S / wire if wire else 0, spec.text(wire)
    top = 0.1 + 0.7 * seconds / _window(seconds, 0.6, 3, 16)
    end: Points = (0.9, 0.8), (0.9, 0), (1, 0)
    command = Stroke(((0.1, 0), (0.1, 0.8), *end), "muted", _DASHED)
    speed = Stroke(((0, 0), (0.1, 0), (top, 0.8), *end))
    text = tr("Speed after an accelerate command: {0}. The motor slows down at once.").format(value)
    return Picture(text, value, (command, speed) if wire else (speed,))


def _reversal(spec: ParameterSpec, wire: int, values: ParameterValues) -> Picture:
    seconds, value = wire * spec.scale / 1000, spec.text(wire)
    window = _window(2 * seconds, 0.2, 0.6, 3)
    start, end = 0.2, 0.2 + 0.8 * seconds / window
    output: Points = (0, 0.8), (start, 0.8), (start, 0.4), (end, 0.4)
    rate = values.value_of(spec.key.replace(MotorParameter.BRAKE_DURATION, "acceleration"))
    if rate is not None:
        ramp = 0.8 * FULL_SPEED_S / rate / window if rate else 0
        fraction = min(1, (1 - end) / ramp) if ramp else 1  # fraction of the ramp that fits
        output += (end + ramp * fraction, 0.4 - 0.4 * fraction), (1, 0.4 - 0.4 * fraction)
    text = tr("Reversal by an accelerate command: {0}, then the ramp.").format(value)
    lines = Stroke(((0, 0.4), (1, 0.4)), "outline", _DOTTED), Stroke(output)
    return Picture(text, value, lines, (start, end, 0.8))


def _limit(spec: ParameterSpec, wire: int, _values: ParameterValues) -> Picture:
    limit, value = 0.8 * wire / spec.maximum if wire else 1, spec.text(wire)
    demand: Points = (0, 0.02), (0.2, 0.04), (0.3, 0.8), (0.5, 0.42), (0.65, 0.34), (1, 0.34)
    limited: list[tuple[float, float]] = []
    for (x1, y1), (x2, y2) in pairwise(demand):
        limited.append((x1, min(y1, limit)))
        if (y1 - limit) * (y2 - limit) < 0:
            limited.append((x1 + (x2 - x1) * (limit - y1) / (y2 - y1), limit))
    lines = Stroke(demand, "muted", _DASHED), Stroke((*limited, (1, min(0.34, limit))))
    text = tr("Current of a starting motor, limit: {0}").format(value)
    if not wire:
        return Picture(text, value, lines[1:])
    edge = Stroke(((0, limit), (1, limit)), "limit")
    return Picture(text, value, (edge, *lines), caption_position=(0.08, limit + 0.03))


def _stop(
    spec: ParameterSpec, wire: int, values: ParameterValues, after: float | None = None
) -> Picture:
    """Draw a loss of signal. Motors stop `after` seconds, by default the parameter's value."""
    value, start = spec.text(wire), 0.3
    seconds = wire * spec.scale if after is None else after
    end = start + 0.55 * seconds / _window(seconds, 0.5, 1.5, 5, 15)
    is_known = after is not None or bool(values.value_of(ParameterKey.UART_ERROR_SHUTDOWN))
    motors = Stroke(((end, 0.8), (end, 0.2), (1, 0.2)), "", _SOLID if is_known else _DASHED)
    text = tr("{0}: the motors stop.") if is_known else tr("{0}: the motors may not stop.")
    if not wire:
        text, motors = tr("{0}: the motors keep running."), Stroke(((end, 0.8), (1, 0.8)))
    signals = (Stroke(((x / 20, 0), (x / 20, 0.12)), "muted") for x in range(1, 6))
    edge = Stroke(((start, 0), (start, 0.8)), "danger", _DOTTED)
    lines = *signals, edge, Stroke(((0, 0.8), (end, 0.8))), motors
    return Picture(text.format(value), value, lines)


def _brake(spec: ParameterSpec, wire: int, _values: ParameterValues) -> Picture:
    value, speed = spec.text(wire), Stroke(((0, 0.8), (0.35, 0), (0.65, 0), (1, 0.8)))
    text = tr("Speed against the stick position, brake in the deadband: {0}").format(value)
    return Picture(text, value, (speed,), (0.35, 0.65, 0.8 * wire / spec.maximum))


_PICTURES: dict[str, Callable[[ParameterSpec, int, ParameterValues], Picture]] = {
    MotorParameter.ACCELERATION: _ramp,
    ParameterKey.AUX_ACCELERATION: _ramp,
    MotorParameter.BRAKE_DURATION: _reversal,
    MotorParameter.CURRENT_LIMIT: _limit,
    MotorParameter.DEADBAND_BRAKE_PWM: _brake,
    ParameterKey.SERIAL_TIMEOUT: _stop,
    ParameterKey.UART_ERROR_SHUTDOWN: partial(_stop, after=0),
    ParameterKey.REQUIRED_CHANNELS: partial(_stop, after=_RC_LOSS_S),
}


class ParameterPicture(Painted):
    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("parameterPicture")
        self.picture: Picture | None = None
        self._color = "bar"
        follow_theme(self, "height", self._fit)

    def _fit(self) -> None:
        self.setFixedHeight(_LINES * self.fontMetrics().lineSpacing())

    def spoken_name(self) -> str:
        return self.picture.text if self.picture else ""

    def show_parameter(self, key: str, values: ParameterValues) -> None:
        self.picture = picture_of(key, values) if key else None
        self._color = _COLORS.get(key.partition("_")[0], "bar")
        self.setVisible(self.picture is not None)
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        if (picture := self.picture) is None:
            return
        inside = QRectF(self.rect()).adjusted(_MARGIN, _MARGIN, -_MARGIN, -_MARGIN)

        def point(x: float, y: float) -> QPointF:
            return inside.bottomLeft() + QPointF(x * inside.width(), -y * inside.height())

        with Painter(self) as painter:
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(theme().color("track"))
            painter.drawRoundedRect(self.rect(), 8, 8)
            if picture.area:
                left, right, height = picture.area
                painter.setBrush(theme().color("deadband"))
                painter.drawRect(QRectF(point(left, height), point(right, 0)))
            for line in picture.lines:
                painter.setPen(QPen(theme().color(line.color or self._color), 2, line.style))
                painter.drawPolyline([point(x, y) for x, y in line.points])
            painter.setPen(theme().color("muted"))
            metrics, anchor = painter.fontMetrics(), point(*picture.caption_position)
            width, height = metrics.horizontalAdvance(picture.caption), metrics.height()
            left = max(anchor.x() - width / 2, inside.left())
            box = QRectF(left, anchor.y() - height, width + 2, height)
            painter.drawText(box, Qt.AlignmentFlag.AlignCenter, picture.caption)
