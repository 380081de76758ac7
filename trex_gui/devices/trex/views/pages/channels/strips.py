"""Live strips of the channels, each with a value, a calibration bar and a plot."""

import math
from collections.abc import Iterable
from functools import partial

from PySide6.QtCore import QPointF, QRect, QRectF, QSize, Qt, Signal, Slot
from PySide6.QtGui import (
    QAccessible,
    QFont,
    QFontMetrics,
    QPainter,
    QPaintEvent,
    QPen,
    QPolygonF,
    QShowEvent,
    QTransform,
)
from PySide6.QtWidgets import QAbstractButton, QSizePolicy, QWidget

from trex_gui.core.texts import signed_text
from trex_gui.core.translation import tr
from trex_gui.devices.trex.calibration.channel_curve import ChannelCurve
from trex_gui.devices.trex.model.channel_text import CHANNEL_NAMES, live_text
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.views.bars import DEFAULT_AXIS, input_axis, paint_input, widened
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import scaled_font, theme
from trex_gui.ui.units import units
from trex_gui.ui.widgets.accessible import Spoken
from trex_gui.ui.widgets.bar import NO_VALUE
from trex_gui.ui.widgets.behaviour import only_when_visible, strokes
from trex_gui.ui.widgets.builders import column, named, plain
from trex_gui.ui.widgets.circuit import write
from trex_gui.ui.widgets.painted import Painter, never_mirror

STRIP_SECONDS = 10.0
_INTERVAL = 0.06  # minimum seconds between redraws: every second frame
_MAX_GAP = 0.5  # seconds; samples that are further apart are not connected by a line
_PADDING, _SPACING, _TRACK, _OVERHANG = 10, 7, 8, 3  # pixels
_RIGHT = Qt.AlignmentFlag.AlignRight


class ChannelStrip(QAbstractButton, Spoken):
    """Selectable strip of a channel. Time increases to the right, counts increase upwards."""

    spoken_role = QAccessible.Role.RadioButton

    def __init__(self, channel: int, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        never_mirror(self)
        self._number, self._name = str(channel), tr(CHANNEL_NAMES[channel])
        self.setObjectName(f"channel{channel}Strip")
        self.setAccessibleName(tr("Channel {0}: {1}").format(channel, self._name))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setCheckable(True)
        self.setAutoExclusive(True)  # arrow keys select the next strip
        self._axis = DEFAULT_AXIS[InputSource.RC]
        self._curve: ChannelCurve | None = None
        self._calibration: Calibration | None = None
        self._count: int | None = None
        self._value = self._output = self._spoken = self._mark = ""
        self._newest = -math.inf  # time at the right edge
        self._is_broken = True  # True if the next point starts a new line
        self.lines: list[QPolygonF] = []  # points (time, count); a new line starts after each gap
        theme().changed.connect(self.update)

    def set_curve(self, source: InputSource, curve: ChannelCurve | None) -> None:
        self._curve = curve
        self.set_scale(source, curve.calibration if curve else None)

    def set_scale(self, source: InputSource, calibration: Calibration | None) -> None:
        self._calibration = calibration
        self._axis = input_axis(source, calibration)
        self.update()

    def show_value(self, source: InputSource, raw: int | None) -> None:
        output = "" if raw is None or self._curve is None else signed_text(self._curve.output(raw))
        value = "" if raw is None else units().ordered(source.text(raw), str(raw))[0]
        self.show_texts(value or tr("no signal"), output, live_text(source, raw, self._curve))

    def show_unknown(self) -> None:
        self.show_texts(NO_VALUE, "", tr("not known"))

    def show_texts(self, value: str, output: str, spoken: str) -> None:
        if (value, output, spoken) != (self._value, self._output, self._spoken):
            self._value, self._output, self._spoken = value, output, spoken
            self.update(0, 0, self.width(), self._bar_top())

    def show_mark(self, mark: str, problem: str) -> None:
        """Mark the channel with an icon, and show `problem` as its tool tip."""
        self.setToolTip(plain(problem or self._name))
        if mark != self._mark:
            self._mark = mark
            self.update()

    def add_samples(self, times: Iterable[float], counts: Iterable[float]) -> None:
        """Add samples in chronological order. NaN is a gap."""
        for time, count in zip(times, counts, strict=True):
            if math.isnan(count):
                self._is_broken = True
            else:
                if self._is_broken or time - self._newest > _MAX_GAP:
                    self.lines.append(QPolygonF())
                self.lines[-1].append(QPointF(time, count))
                self._is_broken = False
            self._newest = time
        self._count = None if self._is_broken else round(self.lines[-1].last().y())
        self._axis = widened(self._axis, () if self._count is None else (self._count,))
        self._drop_before(self._newest - STRIP_SECONDS)
        top = self._bar_top()
        self.update(0, top, self.width(), self.height() - top)

    def _drop_before(self, oldest: float) -> None:
        while self.lines:
            line = self.lines[0]
            while not line.isEmpty() and line.first().x() < oldest:
                line.removeFirst()
            if not line.isEmpty():
                return
            del self.lines[0]

    def clear(self) -> None:
        self.lines.clear()
        self._count, self._newest, self._is_broken = None, -math.inf, True
        self.update()

    def spoken_state(self) -> str:
        mark = {"warning": tr("problem"), "edited": tr("edited")}.get(self._mark, "")
        counts = [point.y() for line in self.lines for point in line.toList()]
        range_text = ""
        if counts:
            range_text = tr("{0:.0f} to {1:.0f} counts").format(min(counts), max(counts))
        return ", ".join(filter(None, (self._spoken, mark, range_text)))

    def _width(self, font: QFont, role: str = "") -> int:
        return QFontMetrics(font).horizontalAdvance(f"0  {role}  0000 µs  −000") + 2 * _PADDING

    def _large_font(self) -> QFont:
        """Return a larger font, or the normal font if the strip is too narrow."""
        larger = scaled_font(self.font(), 1.15)
        return larger if self._width(larger, f"{self._name} MM") <= self.width() else self.font()

    def _bar_top(self) -> int:
        height = QFontMetrics(scaled_font(self.font(), 1.15)).height()
        return _PADDING + height + _SPACING - _OVERHANG

    def sizeHint(self) -> QSize:
        return QSize(2 * self._width(self.font(), self._name), self._bar_top() * 3)

    def minimumSizeHint(self) -> QSize:
        return QSize(self._width(self.font(), "MMM"), self._bar_top() + _TRACK + 4 * _SPACING)

    def paintEvent(self, event: QPaintEvent) -> None:
        area = self.rect().adjusted(_PADDING, _PADDING, -_PADDING, -_PADDING)
        color = theme().color
        with Painter(self) as painter:
            selected = self.isChecked()
            width = 2 if selected else 1
            inset = width / 2
            painter.setPen(QPen(color("accent" if selected else "hairline"), width))
            painter.setBrush(color("selected" if selected else "base"))
            box = QRectF(self.rect()).adjusted(inset, inset, -inset, -inset)
            painter.drawRoundedRect(box, 10, 10)
            if event.rect().top() < self._bar_top():
                self._paint_texts(painter, area)
            track = QRectF(area.left(), self._bar_top() + _OVERHANG, area.width(), _TRACK)
            paint_input(painter, track, self._axis, self._count, self._calibration)
            top = track.bottom() + _SPACING
            self._paint_line(painter, QRectF(area.left(), top, area.width(), area.bottom() - top))

    def _paint_texts(self, painter: QPainter, area: QRect) -> None:
        painter.setFont(self._large_font())
        line = QRectF(area.left(), area.top(), area.width(), painter.fontMetrics().height())
        write(painter, line, self._number, "window_text", bold=True)
        write(painter, line, self._output, "accent", bold=True, align=_RIGHT)
        advance = painter.fontMetrics().horizontalAdvance
        values = line.adjusted(0, 0, -advance("  −000"), 0)
        color, value = "window_text" if self._output else "muted", self._value
        widest = max(advance(f"0 {tr(name)} {value}") for name in CHANNEL_NAMES.values())
        if self._output and widest * 1.1 > values.width():
            value = value.split()[0]  # the unit is beside the curve
        write(painter, values, value, color, bold=True, align=_RIGHT)
        value_width = advance(value) * 11 // 10 + 6  # bold text is wider
        role = values.adjusted(advance("0 ") + 4, 0, -value_width, 0)
        painter.setFont(self.font())
        if self._mark:
            side = self.fontMetrics().height()
            width = min(self.fontMetrics().horizontalAdvance(self._name) + 6, role.width() - side)
            box = QRectF(role.left() + width, line.top(), side, line.height())
            icon(self._mark).paint(painter, box.toRect())
            role.setWidth(width)
        write(painter, role, self._name, "window_text")

    def _paint_line(self, painter: QPainter, area: QRectF) -> None:
        if not self.lines:
            return
        painter.setClipRect(area.adjusted(0, -1, 0, 1))
        low, high = self._axis
        painter.translate(area.right(), area.bottom())
        painter.scale(area.width() / STRIP_SECONDS, -area.height() / (high - low))
        painter.translate(-self._newest, -low)
        pen = QPen(theme().color("muted"), 1)
        pen.setCosmetic(True)
        painter.setPen(pen)
        base = painter.worldTransform()
        for shift in (0, 1):  # two strokes of one pixel are faster than one stroke of two pixels
            painter.setWorldTransform(base * QTransform.fromTranslate(0, shift))
            for _ in strokes(painter):
                for line in self.lines:
                    painter.drawPolyline(line)


class ChannelStrips(QWidget):
    chosen = Signal()  # the user selected another channel

    def __init__(self, device: Device | None, parent: QWidget) -> None:
        """Create the strips. `device` is the source of live values, `None` for a settings file."""
        super().__init__(parent)
        named(self, "channelStrips", accessible=tr("Channels"))
        self._device = device
        self._drawn_until = -math.inf  # time of the newest drawn sample
        self.channel = 1
        self.by_channel = {channel: ChannelStrip(channel, self) for channel in CHANNELS}
        self.by_channel[self.channel].setChecked(True)
        for channel, strip in self.by_channel.items():
            strip.toggled.connect(partial(self._on_toggled, channel))
        column(*((strip, 1) for strip in self.by_channel.values()), into=self, margins=0, spacing=8)
        if device is not None:
            device.telemetry.frame_due.connect(self._on_frame_due)
            device.telemetry.text_due.connect(self._on_text_due)
            units().changed.connect(self._on_text_due)

    def _on_toggled(self, channel: int, selected: bool) -> None:
        if selected:
            self.channel = channel
            self.chosen.emit()

    def redraw(self) -> None:
        self._clear()
        self._on_frame_due()
        self._on_text_due()

    def _clear(self) -> None:
        self._drawn_until = -math.inf
        for strip in self.by_channel.values():
            strip.clear()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.redraw()

    @Slot()
    @only_when_visible
    def _on_frame_due(self) -> None:
        if self._device is None:
            return
        telemetry, inputs = self._device.telemetry, self._device.telemetry.inputs
        if telemetry.raw is None or telemetry.latest - self._drawn_until < _INTERVAL:
            return
        newest = inputs.span[1] if inputs.span is not None else -math.inf
        first = max(math.nextafter(self._drawn_until, math.inf), newest - STRIP_SECONDS)
        rows = inputs.rows(first, newest)
        times = inputs.times[rows].tolist()
        for channel, strip in self.by_channel.items():
            strip.add_samples(times, inputs.values(channel - 1)[rows].tolist())
        self._drawn_until = newest

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        if self._device is None:
            return
        telemetry, source = self._device.telemetry, self._device.calibrations.source
        if telemetry.raw is None and self._drawn_until > -math.inf:
            self._clear()
        for channel, strip in self.by_channel.items():
            if telemetry.raw is None:
                strip.show_unknown()
            else:
                strip.show_value(source, telemetry.raw_of(channel))
