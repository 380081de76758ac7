"""Page of the five live inputs: raw, over the last seconds, and what the board makes of them."""

import math
from collections.abc import Iterable
from typing import NamedTuple

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Slot
from PySide6.QtGui import QPainter, QPaintEvent, QPen, QPolygonF, QShowEvent, QTransform
from PySide6.QtWidgets import QLabel, QSizePolicy, QWidget

from trex_gui.core.translation import tr
from trex_gui.devices.trex.model.channel_text import function_text, input_text, switching_text
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.descriptions import MODE_TEXT
from trex_gui.devices.trex.protocol.flags import CHANNELS, InputSource
from trex_gui.devices.trex.views.bars import ChannelBar, OutputBar
from trex_gui.ui.theme.theme import follow_theme, theme
from trex_gui.ui.units import units
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.behaviour import only_when_visible, strokes
from trex_gui.ui.widgets.labels import LiveLabel
from trex_gui.ui.widgets.painted import Painted, Painter

_STRIP_INTERVAL = 0.06  # seconds: every second frame
STRIP_SECONDS = 10.0
_MAX_GAP = 0.5  # seconds without a sample that interrupt the line
_MARGIN = 0.03  # of the height, above and below: lines at the ends of the axis remain visible


class InputStrip(Painted):
    """Draws raw counts upwards and time to the right, where the newest sample is.

    Qt keeps the points: a frame adds the new samples and costs a twentieth of a millisecond.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._axis = 0, 1
        self._calibration: Calibration | None = None
        self._newest = -math.inf  # time at the right edge
        self._is_broken = True  # the next point begins a line
        self.lines: list[QPolygonF] = []  # of points (time, count); gaps are between them
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Expanding)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        theme().changed.connect(self.update)

    def set_scale(self, axis: tuple[int, int], calibration: Calibration | None) -> None:
        """Set the counts at bottom and top, and whose neutral, ends and deadband are marked."""
        if (axis, calibration) != (self._axis, self._calibration):
            self._axis, self._calibration = axis, calibration
            self.update()

    def add_samples(self, times: Iterable[float], counts: Iterable[float]) -> None:
        """Add samples that are newer than those before; NaN is a gap."""
        for time, count in zip(times, counts, strict=True):
            if math.isnan(count):
                self._is_broken = True
            else:
                if self._is_broken or time - self._newest > _MAX_GAP:
                    self.lines.append(QPolygonF())
                self.lines[-1].append(QPointF(time, count))
                self._is_broken = False
            self._newest = time
        self._drop_before(self._newest - STRIP_SECONDS)
        self.update()

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
        self._newest, self._is_broken = -math.inf, True
        self.update()

    def spoken_state(self) -> str:
        counts = [point.y() for line in self.lines for point in line.toList()]
        if not counts:
            return tr("no signal")
        return tr("{0:.0f} to {1:.0f} counts").format(min(counts), max(counts))

    def sizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 30, self.fontMetrics().height() * 3)

    def minimumSizeHint(self) -> QSize:
        return QSize(self.fontMetrics().averageCharWidth() * 10, self.fontMetrics().height() * 2)

    def paintEvent(self, event: QPaintEvent) -> None:
        del event
        color = theme().color
        box = QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5)
        with Painter(self, smooth=False) as painter:
            painter.fillRect(box, color("plot_background" if self.lines else "track_off"))
            if self.lines:
                painter.setClipRect(box)
                place = self._place(box)
                self._paint_marks(painter, place, box)
                painter.setWorldTransform(place)
                pen = QPen(color("pointer"), 1)
                pen.setCosmetic(True)
                painter.setPen(pen)
                for _ in strokes(painter):
                    for line in self.lines:
                        painter.drawPolyline(line)
                painter.resetTransform()
                painter.setClipping(False)
            painter.setPen(QPen(color("plot_frame"), 1))
            painter.drawRect(box)

    def _place(self, box: QRectF) -> QTransform:
        """Return the transformation from times and counts to pixels."""
        low, high = self._axis
        margin = (high - low) * _MARGIN
        place = QTransform.fromTranslate(box.right(), box.bottom())
        place.scale(box.width() / STRIP_SECONDS, -box.height() / (high - low + 2 * margin))
        return place.translate(-self._newest, margin - low)

    def _paint_marks(self, painter: QPainter, place: QTransform, box: QRectF) -> None:
        calibration = self._calibration
        if calibration is None:
            return

        def level(count: int, height: float = 1) -> QRectF:
            return QRectF(box.left(), round(place.map(QPointF(0, count)).y()), box.width(), height)

        middle, deadband = calibration.neutral, calibration.deadband
        band = level(middle + deadband)
        band.setBottom(level(middle - deadband).top())
        painter.fillRect(band, theme().color("deadband"))
        for count in (calibration.minimum, middle, calibration.maximum):
            painter.fillRect(level(count), theme().color("grid"))


class _Row(NamedTuple):
    function: QLabel
    value: QLabel
    bar: ChannelBar
    strip: InputStrip
    output: OutputBar


class ChannelsPage(QWidget):
    """For each channel what it does now, its input in µs or V and counts, and its output."""

    def __init__(self, device: Device, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("channelsPage")
        self._device = device
        self._source = InputSource.RC
        self._drawn_until = -math.inf  # time of the newest sample in the strips
        self._control: bool | None = None  # as the texts say

        self._summary = ui.label(self, "channelsSummary", wrap=True)
        self._grid = ui.grid(spacing=(16, 2), stretch=[(1, 5), (2, 4), (3, 3)])
        headings = (
            (tr("Input and count"), ""),
            (
                tr("Raw, with its calibration"),
                tr(
                    "The bar shows the raw input. Its marks are the channel's calibration: full "
                    "output at min and max, none within the shaded deadband around neutral."
                ),
            ),
            (
                tr("Last 10 seconds"),
                tr(
                    "The raw input on the scale of the bar, the newest at the right. Where there "
                    "was no valid signal the line has a gap."
                ),
            ),
            (
                tr("Remapped (−127 to 127)"),
                tr(
                    "What the board makes of the input. Those of channels 1 and 2 are the speeds "
                    "for motors 1 and 2, after mixing and flip. The vendor's document gives "
                    "channel 3 six bits, 0 to 63; the program reads seven (inferred)."
                ),
            ),
        )
        for column, (text, tip) in enumerate(headings):
            heading = ui.label(self, "", text, tip=tip, bold=True, wrap=column > 0)
            self._grid.addWidget(heading, 0, column)
        self._rows = {channel: self._add_row(channel) for channel in CHANNELS}
        follow_theme(self, "values", self._fit_values)
        ui.column(self._summary, (self._grid, 1), into=self)

        for changed in (device.link_changed, device.state_changed, device.calibrations.changed):
            changed.connect(self._on_device_changed)
        device.mix_jumper.changed.connect(self._show_functions)
        device.telemetry.frame_due.connect(self._on_frame_due)
        device.telemetry.text_due.connect(self._on_text_due)
        units().changed.connect(self._on_text_due)
        self._on_device_changed()

    def _add_row(self, channel: int) -> _Row:
        name = ui.label(self, "", tr("Channel {0}").format(channel), bold=True)
        raw_input = tr("Raw input of channel {0}").format(channel)
        value = LiveLabel(f"channel{channel}Input", raw_input, self)
        seconds = tr("Input of channel {0} in the last 10 seconds").format(channel)
        remapped = tr("Remapped channel {0}").format(channel)
        row = _Row(
            ui.label(self, f"channel{channel}Function", wrap=True),
            value,
            ui.named(ChannelBar(self), f"channel{channel}Bar", accessible=raw_input),
            ui.named(InputStrip(self), f"channel{channel}Strip", accessible=seconds),
            ui.named(OutputBar(self), f"channel{channel}Output", accessible=remapped),
        )
        row.bar.set_value_shown(False)
        head, bars = 3 * channel - 2, 3 * channel - 1  # and the rest of the strip below
        self._grid.addWidget(name, head, 0, Qt.AlignmentFlag.AlignTop)
        self._grid.addWidget(row.function, head, 1, 1, 3, Qt.AlignmentFlag.AlignTop)
        self._grid.addWidget(row.value, bars, 0)
        self._grid.addWidget(row.bar, bars, 1)
        self._grid.addWidget(row.strip, bars, 2, 2, 1)
        self._grid.addWidget(row.output, bars, 3)
        self._grid.setRowStretch(bars + 1, 1)
        return row

    def _fit_values(self) -> None:
        """Give the values a fixed size: otherwise each new one lays out the whole page."""
        metrics = self.fontMetrics()
        width = metrics.horizontalAdvance("1500 µs (3750)") + 8
        for row in self._rows.values():
            row.value.setFixedSize(width, metrics.height() + 2)

    @Slot()
    def _on_device_changed(self) -> None:
        state = self._device.state
        is_connected = state is not None and self._device.is_connected
        if state is not None:
            self._source = state.source
        for channel, row in self._rows.items():
            row.value.setEnabled(is_connected)
            for bar in (row.bar, row.output):
                bar.set_connected(is_connected)
            if state is not None:
                row.bar.set_source(state.source)
                row.bar.set_calibration(self._device.calibrations.stored(channel))
        self._show_functions()
        self._renew()

    @Slot()
    def _show_functions(self) -> None:
        """Say what the board and its channels do with the inputs."""
        device, state = self._device, self._device.state
        by_serial = self._control = device.telemetry.serial_controls
        self._summary.setText(self._board_text())
        for channel, row in self._rows.items():
            curve = device.draft.stored_curve(channel)
            if state is None or curve is None:
                row.function.clear()
                continue
            text = function_text(
                channel,
                state.mode,
                joint=device.board.is_joint,
                ignored=curve.ignored,
                is_reversed=curve.reversed_,
                overridden=bool(by_serial) and not state.mode.is_serial,
                switches_at=switching_text(channel, curve, state.source),
                mixed=device.mix_jumper.is_on,
            )
            row.function.setText(text)

    def _board_text(self) -> str:
        state, is_mixed = self._device.state, self._device.mix_jumper.is_on
        if state is None:
            return tr("Connect to a board to see its inputs.")
        mixing = {
            True: tr("The mix jumper is on."),
            False: tr("The mix jumper is off."),
            None: tr("Moving channel 1 or 2 shows whether the mix jumper is on."),
        }[is_mixed]
        if self._device.board.is_joint:
            mixing = tr("Joint mode: both drivers power motor 1, nothing is mixed.")
        rc, analog = tr("A count is 0.4 µs."), tr("A count is 4.89 mV.")
        count = rc if state.source is InputSource.RC else analog
        return f"{tr(MODE_TEXT[state.mode])} {mixing} {count}"

    @Slot()
    @only_when_visible
    def _on_frame_due(self) -> None:
        telemetry = self._device.telemetry
        if telemetry.raw is None:
            return
        for channel, row in self._rows.items():
            raw = telemetry.raw_of(channel)
            row.bar.set_raw(raw)
            # Without a signal the board reports 0, which is no measurement.
            row.output.set_value(None if raw is None else telemetry.remapped_of(channel))
        if telemetry.latest - self._drawn_until >= _STRIP_INTERVAL:
            self._draw_strips()

    def _draw_strips(self) -> None:
        inputs = self._device.telemetry.inputs
        newest = inputs.span[1] if inputs.span is not None else -math.inf
        first = max(math.nextafter(self._drawn_until, math.inf), newest - STRIP_SECONDS)
        rows = inputs.rows(first, newest)
        times = inputs.times[rows].tolist()
        for channel, row in self._rows.items():
            row.strip.set_scale(row.bar.axis, self._device.calibrations.stored(channel))
            row.strip.add_samples(times, inputs.values(channel - 1)[rows].tolist())
        self._drawn_until = newest

    def _clear_strips(self) -> None:
        self._drawn_until = -math.inf
        for row in self._rows.values():
            row.strip.clear()

    @Slot()
    @only_when_visible
    def _on_text_due(self) -> None:
        telemetry = self._device.telemetry
        if telemetry.serial_controls is not self._control:
            self._show_functions()
        if telemetry.raw is None:
            self._clear_strips()
        for channel, row in self._rows.items():
            raw = telemetry.raw_of(channel)
            text = tr("N/A") if telemetry.raw is None else tr("no signal")
            row.value.setText(text if raw is None else input_text(self._source, raw))

    def _renew(self) -> None:
        self._clear_strips()
        self._on_frame_due()
        self._on_text_due()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._renew()
