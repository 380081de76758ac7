"""Curves to files: a table of what is shown or of everything, a picture of what is shown."""

import io
from collections.abc import Iterator
from functools import partial
from pathlib import Path

import numpy as np
from PySide6.QtCore import QCoreApplication, QObject, QSettings, QThread, Signal, Slot
from PySide6.QtWidgets import QFileDialog, QMenu, QWidget

from trex_gui.export.trace_csv import write_trace_csv
from trex_gui.model.trace.source import TraceSource
from trex_gui.recording.on_disk import whole_file
from trex_gui.views.settings_editor import questions
from trex_gui.views.theme import read_colours, theme
from trex_gui.views.traces.picture import Picture
from trex_gui.views.traces.plot import TracePlot

_AT_ONCE = 2000
_LIGHT = "export/light_background"


class _GivenUpError(Exception):
    """Nobody waits for the table any more; nothing is left of it."""


class _Writing(QThread):
    """Writes one table: a million rows take seconds, in which the window goes on.

    Signals:
        written: how many rows; below 0 when it failed, and why.
    """

    written = Signal(int, str)

    def __init__(
        self,
        path: Path,
        source: TraceSource,
        span: tuple[float, float],
        origin: float,
        parent: QObject,
    ) -> None:
        super().__init__(parent)
        self.path = path
        self._columns = [(trace.name, trace.unit) for trace in source.traces]
        times, values = source.samples(*span)
        # Copies: the history goes on. A million take 0.1 to 0.3 s, as rows they would take longer.
        self._copies = [column.copy() for column in (times, *values)]
        self._events = [(one.time, one.text) for one in source.events_between(*span)]
        self._origin = origin

    def run(self) -> None:
        """Write, in the new thread."""
        try:
            with (
                whole_file(self.path) as data,
                io.TextIOWrapper(data, encoding="utf-8", newline="") as file,
            ):
                count = write_trace_csv(
                    file, self._columns, self._lists(), self._events, self._origin
                )
        except _GivenUpError:
            return
        except OSError as error:
            self.written.emit(-1, error.strerror or str(error))
        else:
            self.written.emit(count, "")

    def _lists(self) -> Iterator[list[float]]:
        for first in range(0, len(self._copies[0]), _AT_ONCE):
            if self.isInterruptionRequested():
                raise _GivenUpError
            rows = [column[first : first + _AT_ONCE] for column in self._copies]
            yield from np.column_stack(rows).tolist()


class TraceExport(QObject):
    """Asks for a file and writes what a plot has.

    Signals:
        told: what was done, for people.
        refused: why nothing was done, for people.

    Attributes:
        menu: the choices.
    """

    told = Signal(str)
    refused = Signal(str)

    def __init__(
        self, plot: TracePlot, window: QWidget, *, name: str = "currents", tables: bool = True
    ) -> None:
        """Export what `plot` has; files are proposed as `name`, tables only with `tables`."""
        super().__init__(window)
        self._name = name
        self._plot = plot
        self._window = window
        self._store = QSettings(self)
        self._writing: _Writing | None = None
        self.menu = QMenu(window)
        app = QCoreApplication.instance()
        if app is not None:
            app.aboutToQuit.connect(self.finish)
        as_tables = (
            ("exportShownAction", self.tr("&Visible range as CSV…"), self._ask_shown),
            ("exportAllAction", self.tr("&Everything as CSV…"), self._ask_all),
        )
        as_pictures = (
            ("exportPngAction", self.tr("Picture as &PNG…"), partial(self._ask_picture, "png")),
            ("exportSvgAction", self.tr("Picture as &SVG…"), partial(self._ask_picture, "svg")),
        )
        for key, text, slot in (*(as_tables if tables else ()), *as_pictures):
            action = self.menu.addAction(text)
            action.setObjectName(key)
            action.triggered.connect(lambda _checked=False, slot=slot: slot())
        self.menu.addSeparator()
        self._light = self.menu.addAction(self.tr("Pictures on a &light background"))
        self._light.setObjectName("exportLightAction")
        self._light.setCheckable(True)
        self._light.setChecked(self._store.value(_LIGHT, "true") == "true")
        self._light.toggled.connect(self._on_light_toggled)

    @Slot(bool)
    def _on_light_toggled(self, light: bool) -> None:
        self._store.setValue(_LIGHT, "true" if light else "false")

    def _ask(self, name: str, kinds: str) -> Path | None:
        suggested = questions.last_folder(self._store) / name
        chosen, _ = QFileDialog.getSaveFileName(
            self._window, self.tr("Export"), str(suggested), kinds
        )
        if not chosen:
            return None
        path = Path(chosen)
        path = path if path.suffix else path.with_suffix(Path(name).suffix)
        questions.remember_folder(self._store, path)
        return path

    def _ask_shown(self) -> None:
        path = self._ask(f"{self._name}.csv", self.tr("Tables (*.csv)"))
        if path is not None:
            self.save_table(path, self._plot.span.start, self._plot.span.end)

    def _ask_all(self) -> None:
        path = self._ask(f"{self._name}.csv", self.tr("Tables (*.csv)"))
        if path is not None:
            self.save_table(path, float("-inf"), float("inf"))

    def _ask_picture(self, kind: str) -> None:
        path = self._ask(f"{self._name}.{kind}", self.tr("Pictures (*.{0})").format(kind))
        if path is not None:
            self.save_picture(path)

    def save_table(self, path: Path, start: float, end: float) -> None:
        """Write every curve from `start` to `end`; `told` or `refused` says how it went."""
        source = self._plot.source
        if source is None or source.span is None:
            self.refused.emit(self.tr("There is nothing to export yet."))
            return
        if self._writing is not None:
            self.refused.emit(self.tr("Another export is still being written."))
            return
        origin = self._plot.origin or 0.0
        self._writing = _Writing(path, source, (start, end), origin, self)
        self._writing.written.connect(self._on_written)
        self._writing.start()

    @Slot(int, str)
    def _on_written(self, count: int, reason: str) -> None:
        writing, self._writing = self._writing, None
        if writing is None:
            return
        writing.wait()
        writing.deleteLater()
        if count < 0:
            self.refused.emit(
                self.tr("{0} was not written: {1}.").format(writing.path.name, reason.rstrip("."))
            )
        else:
            self.told.emit(
                self.tr("{0} samples were written to {1}.").format(f"{count:,}", writing.path)
            )

    def save_picture(self, path: Path) -> None:
        """Write a picture of what is shown; the kind follows the name."""
        source = self._plot.source
        if source is None or source.span is None:
            self.refused.emit(self.tr("There is nothing to export yet."))
            return
        scheme = "light" if self._light.isChecked() else theme().scheme
        span = self._plot.span.start, self._plot.span.end
        origin = self._plot.origin or 0.0
        picture = Picture(source, span, self._plot.shown, read_colours(scheme), origin)
        if picture.write(path):
            self.told.emit(self.tr("The picture was written to {0}.").format(path))
        else:
            self.refused.emit(self.tr("{0} could not be written.").format(path))

    @Slot()
    def finish(self) -> None:
        """Give up a table that is being written, and wait for that; for the end."""
        if self._writing is not None:
            self._writing.requestInterruption()
            self._writing.wait()
