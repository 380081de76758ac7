"""Curves to files: a table of what is shown or of everything, a picture of what is shown."""

from functools import partial
from pathlib import Path

from PySide6.QtCore import QObject, QSettings, Slot
from PySide6.QtWidgets import QFileDialog, QMenu, QWidget

from trex_gui.ui.notifier import Notifier
from trex_gui.ui.plotting.data.table_saver import TableSaver
from trex_gui.ui.plotting.picture import Picture
from trex_gui.ui.plotting.plot import TracePlot
from trex_gui.ui.theme.theme import read_colours, theme
from trex_gui.ui.widgets import file_questions

_LIGHT = "export/light_background"


class TraceExport(QObject):
    """Asks for a file and writes what a plot has.

    Attributes:
        menu: the choices.
    """

    def __init__(
        self,
        plot: TracePlot,
        notifier: Notifier,
        window: QWidget,
        *,
        name: str = "currents",
        tables: bool = True,
    ) -> None:
        """Export what `plot` has; files are proposed as `name`, tables only with `tables`."""
        super().__init__(window)
        self._name = name
        self._plot = plot
        self._notifier = notifier
        self._window = window
        self._store = QSettings(self)
        self._tables = TableSaver(self)
        self._tables.saved.connect(self._on_saved)
        self._tables.failed.connect(self._notifier.error)
        self.menu = QMenu(window)
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
        suggested = file_questions.last_folder(self._store) / name
        chosen, _ = QFileDialog.getSaveFileName(
            self._window, self.tr("Export"), str(suggested), kinds
        )
        if not chosen:
            return None
        path = Path(chosen)
        path = path if path.suffix else path.with_suffix(Path(name).suffix)
        file_questions.remember_folder(self._store, path)
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
        """Write every curve from `start` to `end`."""
        source = self._plot.source
        if source is None or source.span is None:
            self._notifier.error.emit(self.tr("There is nothing to export yet."))
            return
        origin = self._plot.origin
        if origin is None:  # nothing was drawn yet
            origin = source.span[0]
        self._tables.save(path, source, (start, end), origin)

    @Slot(int, object)
    def _on_saved(self, count: int, path: Path) -> None:
        self._notifier.info.emit(
            self.tr("{0} samples were written to {1}.").format(f"{count:,}", path)
        )

    def save_picture(self, path: Path) -> None:
        """Write a picture of what is shown; the kind follows the name."""
        source = self._plot.source
        if source is None or source.span is None:
            self._notifier.error.emit(self.tr("There is nothing to export yet."))
            return
        scheme = "light" if self._light.isChecked() else theme().scheme
        span = self._plot.span.start, self._plot.span.end
        origin = self._plot.origin or 0.0
        picture = Picture(source, span, self._plot.shown, read_colours(scheme), origin)
        if picture.write(path):
            self._notifier.info.emit(self.tr("The picture was written to {0}.").format(path))
        else:
            self._notifier.error.emit(self.tr("{0} could not be written.").format(path))

    def finish(self) -> None:
        """Give up a table that is being written; a disk that hangs is not waited for."""
        self._tables.finish()
