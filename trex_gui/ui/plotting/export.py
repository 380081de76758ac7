"""Export of a plot as CSV or as a picture.

Importing this module loads pyqtgraph, so import it lazily.
"""

import csv
import math
from collections.abc import Iterator, Sequence
from datetime import datetime
from functools import partial
from pathlib import Path
from typing import TextIO

import numpy as np
from PySide6.QtCore import QBuffer, QLocale, QPoint, QRectF, QSize, Qt
from PySide6.QtGui import QFont, QFontMetricsF, QImage, QPainter, QPalette, QPen, QRegion
from PySide6.QtSvg import QSvgGenerator
from PySide6.QtWidgets import QMenu, QToolButton, QWidget

from trex_gui.core.files import save
from trex_gui.core.recording.export import csv_cell
from trex_gui.core.translation import tr
from trex_gui.ui.files import save_in_background, save_picture, write_in_background
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.history import Floats
from trex_gui.ui.plotting.marks import charge_text, value_text
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.plotting.traces import TraceInfo, Traces
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import file_questions
from trex_gui.ui.widgets.builders import action
from trex_gui.ui.widgets.painted import Painter
from trex_gui.ui.workers.file_worker import ProgressCallback

_LIGHT = "export/light_background"

SIZE = QSize(1200, 700)
_SCALE = 2  # PNG pixels per unit of `SIZE`, for print and high-resolution screens
_CHUNK = 2000  # CSV rows between two progress reports
_LEFT = 70
_FONT_PIXELS = 15
_HEADING_HEIGHT = 26
_LINE_WIDTH = 1.3
_ALIGNMENT = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter


class ExportButton(QToolButton):
    def __init__(
        self,
        plot: TracePlot,
        notifier: Notifier,
        parent: QWidget,
        *,
        name: str = "currents",
        tables: bool = True,
    ) -> None:
        """`name`: proposed file name. `tables`: offer CSV, and add date and time to file names."""
        super().__init__(parent)
        self.setObjectName("exportButton" if tables else "pictureButton")
        self.setText(tr("E&xport") if tables else tr("Pictu&re"))
        self.setAccessibleName(self.text().replace("&", ""))
        self.setToolTip("" if tables else tr("Save what the plot shows as PNG or SVG"))
        self.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setMenu(QMenu(parent))
        set_icon(self, "save")
        self._name = name
        self.heading = ""
        self._is_live = tables
        self._plot = plot
        self._notifier = notifier
        self._store = Preferences()
        if tables:
            self._add("exportShownAction", tr("&Visible range as CSV…"), "csv", False)
            self._add("exportAllAction", tr("&Everything as CSV…"), "csv", True)
        self._add("exportPngAction", tr("Picture as &PNG…"), "png")
        self._add("exportSvgAction", tr("Picture as &SVG…"), "svg")
        self.menu().addSeparator()
        self._light = action(
            self, "exportLightAction", tr("Pictures on a &light background"), checkable=True
        )
        self._light.setChecked(self._store.flag(_LIGHT, default=True))
        self._light.toggled.connect(partial(self._store.set, _LIGHT))
        self.menu().addAction(self._light)

    def _add(self, name: str, text: str, kind: str, whole: bool = False) -> None:
        self.menu().addAction(
            action(self, name, text, on_trigger=partial(self._prompt, kind, whole))
        )

    def _prompt(self, kind: str, whole: bool) -> None:
        kinds = tr("Tables (*.csv)") if kind == "csv" else tr("Pictures (*.{0})")
        name = self._name
        if self._is_live:
            name += datetime.now().astimezone().strftime("_%Y-%m-%d_%H-%M-%S")
        proposal = file_questions.last_folder() / f"{name}.{kind}"
        path = file_questions.prompt_to_save(
            self.window(), self.accessibleName(), proposal, kinds.format(kind), f".{kind}"
        )
        if path is None:
            return
        file_questions.remember_folder(path)
        if kind != "csv":
            self.save_picture(path)
        elif whole:
            self.save_table(path, float("-inf"), float("inf"))
        else:
            self.save_table(path, self._plot.span.start, self._plot.span.end)

    def save_table(self, path: Path, start: float, end: float) -> None:
        source = self._plot.source
        if source is None or source.span is None:
            self._notifier.error.emit(tr("There is nothing to export yet."))
            return
        times, values = source.samples(start, end)
        write = partial(
            write_csv,
            headers=[(trace.name, trace.unit) for trace in source.traces],
            # Copied, since the history may change while the file is written. Copying a million
            # rows takes 0.1 to 0.3 s.
            columns=[column.copy() for column in (times, *values)],
            events=[(event.time, event.text) for event in source.events_between(start, end)],
            origin=self._plot.origin if self._plot.origin is not None else source.span[0],
        )

        def saved(count: int) -> str:
            text = tr("{0} sample(s) written to {1}.", "", count)
            return text.format(QLocale().toString(count), path)

        write_in_background(self, path, write, self._notifier, saved)

    def save_picture(self, path: Path) -> None:
        source = self._plot.source
        if source is None or source.span is None:
            self._notifier.error.emit(tr("There is nothing to export yet."))
            return
        scheme = "light" if self._light.isChecked() else theme().scheme
        heading = self.heading
        if self._is_live:
            heading += f", {datetime.now().astimezone():%Y-%m-%d %H:%M}"
        as_svg = path.suffix.lower() == ".svg"
        picture = draw_picture(self._plot, scheme, heading, as_svg=as_svg)
        if isinstance(picture, QImage):
            work = partial(save_picture, path, picture)
        else:
            work = partial(save, path, picture)
        text = tr("The picture was written to {0}.").format(path)
        save_in_background(self, work, self._notifier, text)


def write_csv(
    file: TextIO,
    progress: ProgressCallback,
    *,
    headers: Sequence[tuple[str, str]],
    columns: Sequence[Floats],
    events: Sequence[tuple[float, str]] = (),
    origin: float = 0.0,
) -> int:
    """Write curves as CSV (RFC 4180). Return the number of samples.

    A row contains the time in seconds since `origin`, the values, and the events since the
    previous row. The cell of an unknown value is empty. `headers`: name and unit of each curve.
    `columns`: times, then the values of each curve. `events`: times and texts. All times must be
    sorted.
    """
    writer = csv.writer(file)
    names = [f"{name} ({unit})" if unit else name for name, unit in headers]
    writer.writerow(["time (s)", *names, "event"])
    pending = list(reversed(events))
    for time, *values in _rows(columns, progress):
        texts = []
        while pending and pending[-1][0] <= time:
            texts.append(pending.pop()[1])
        numbers = (f"{value:.10g}" if math.isfinite(value) else "" for value in values)
        writer.writerow([f"{time - origin:.4f}", *numbers, csv_cell("; ".join(texts))])
    for time, text in reversed(pending):
        writer.writerow([f"{time - origin:.4f}", *([""] * len(headers)), csv_cell(text)])
    return len(columns[0])


def _rows(columns: Sequence[Floats], progress: ProgressCallback) -> Iterator[list[float]]:
    count = len(columns[0])
    for first in range(0, count, _CHUNK):
        progress(first / count)
        yield from np.column_stack([column[first : first + _CHUNK] for column in columns]).tolist()


def draw_picture(
    plot: TracePlot, scheme: str, heading: str, *, as_svg: bool = False
) -> QImage | bytes:
    """Draw a plot with a heading and statistics. Return an image, or the data of an SVG file."""
    with theme().painted_as(scheme):
        if not as_svg:
            image = QImage(SIZE * _SCALE, QImage.Format.Format_RGB32)
            image.setDevicePixelRatio(_SCALE)
            with Painter(image, smooth=False) as painter:
                _paint(painter, plot, heading, _LINE_WIDTH * _SCALE)
            return image
        buffer = QBuffer()
        generator = QSvgGenerator()
        generator.setOutputDevice(buffer)
        generator.setSize(SIZE)
        generator.setViewBox(QRectF(0, 0, SIZE.width(), SIZE.height()))
        generator.setTitle(heading)
        with Painter(generator, smooth=False) as painter:
            _paint(painter, plot, heading, _LINE_WIDTH)
        return bytes(buffer.data().data())


def _paint(painter: QPainter, plot: TracePlot, heading: str, line_width: float) -> None:
    source = plot.source
    if source is None:
        return
    font = QFont(painter.font())
    font.setPixelSize(_FONT_PIXELS)
    painter.fillRect(QRectF(0, 0, SIZE.width(), SIZE.height()), theme().color("base"))
    bold = QFont(font)
    bold.setBold(True)
    painter.setFont(bold)
    painter.setPen(theme().color("text"))
    painter.drawText(QRectF(_LEFT, 0, SIZE.width() - _LEFT, _HEADING_HEIGHT), _ALIGNMENT, heading)
    painter.setFont(font)
    traces = [trace for trace in source.traces if trace.name in plot.shown]
    line = QFontMetricsF(font).height()
    top = SIZE.height() - (len(traces) + 0.5) * line
    copy = TracePlot(line_width=line_width)
    copy.setFont(font)
    palette = copy.palette()
    palette.setColor(QPalette.ColorRole.Window, theme().color("base"))
    copy.setPalette(palette)
    copy.resize(SIZE.width() - 20, int(top - 0.5 * line) - _HEADING_HEIGHT)
    copy.set_source(source)
    copy.set_top(plot.top)
    copy.shown = set(plot.shown)
    copy.origin = plot.origin
    copy.peaks_since = plot.peaks_since
    copy.grab()  # computes the layout
    copy.show_span(plot.span.start, plot.span.end)
    copy.render(painter, QPoint(10, _HEADING_HEIGHT), QRegion(), QWidget.RenderFlag.DrawChildren)
    copy.deleteLater()
    for row, trace in enumerate(traces):
        y = top + row * line
        style = Qt.PenStyle.SolidLine if trace.unit == source.left_unit else Qt.PenStyle.DotLine
        painter.setPen(QPen(theme().color(trace.color), 2, style))
        painter.drawLine(_LEFT, int(y + line / 2), _LEFT + 30, int(y + line / 2))
        painter.setPen(theme().color("text"))
        painter.drawText(QRectF(_LEFT + 40, y, 180, line), _ALIGNMENT, trace.label)
        figures = _figures(source, trace, plot.span.start, plot.span.end)
        painter.drawText(QRectF(_LEFT + 220, y, 900, line), _ALIGNMENT, figures)


def _figures(source: Traces, trace: TraceInfo, start: float, end: float) -> str:
    statistics, unit = source.statistics(trace.name, start, end), trace.unit
    if not statistics.seconds:
        return ""
    figures = {
        tr("Low"): value_text(statistics.low, unit),
        tr("Peak"): value_text(statistics.high, unit),
        tr("Mean"): value_text(statistics.mean, unit),
        tr("RMS"): value_text(statistics.rms, unit),
    }
    if unit == "A":
        figures[tr("Charge")] = charge_text(statistics)
        if (limit := source.limits.get(trace.name)) is not None:
            figures[tr("Limit")] = value_text(limit, unit)
    return ", ".join(tr("{0}: {1}").format(*figure) for figure in figures.items())
