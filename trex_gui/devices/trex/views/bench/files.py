"""Saving bench tests as files or pictures, and opening files again to compare with."""

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QObject, QSettings
from PySide6.QtGui import QPixmap
from PySide6.QtWidgets import QFileDialog, QWidget

from trex_gui.devices.trex.bench.files import BenchFileError, from_csv, to_csv
from trex_gui.devices.trex.bench.run import Run
from trex_gui.devices.trex.model.bench import Bench
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.widgets.file_questions import last_folder, remember_folder

_MAX_LENGTH = 10_000_000
"""Characters; two minutes of readings are half a megabyte."""


class BenchFiles(QObject):
    """Saves and opens files, and reports the result; `picture` returns the plot as it is shown."""

    def __init__(
        self, bench: Bench, notifier: Notifier, window: QWidget, picture: Callable[[], QPixmap]
    ) -> None:
        super().__init__(window)
        self._picture = picture
        self._bench = bench
        self._notifier = notifier
        self._window = window
        self._store = QSettings(self)

    def ask_and_save(self, run: Run) -> None:
        """Let the user choose where to save a test."""
        name = f"bench_motor{run.motor}_{run.profile.shape.value}_{run.started:%Y%m%d_%H%M%S}.csv"
        kinds = self.tr("Bench tests (*.csv);;Pictures (*.png)")
        chosen, _ = QFileDialog.getSaveFileName(
            self._window, self.tr("Save bench test"), str(last_folder(self._store) / name), kinds
        )
        if chosen:
            self.save(run, Path(chosen))

    def ask_and_open(self) -> None:
        """Let the user choose a saved test."""
        kinds = self.tr("Bench tests (*.csv);;All files (*)")
        chosen, _ = QFileDialog.getOpenFileName(
            self._window, self.tr("Open bench test"), str(last_folder(self._store)), kinds
        )
        if chosen:
            self.open(Path(chosen))

    def save(self, run: Run, path: Path) -> None:
        """Write a test, or a picture where the name ends in .png; replaces an older file."""
        try:
            if path.suffix.lower() == ".png":
                self._save_picture(path)
            else:
                path.write_text(to_csv(run), encoding="utf-8", newline="")
        except OSError as error:
            self._notifier.error.emit(
                self.tr("{0} was not saved. {1}").format(path.name, error.strerror or error)
            )
            return
        remember_folder(self._store, path)
        self._notifier.info.emit(self.tr("Saved as {0}.").format(path.name))

    def _save_picture(self, path: Path) -> None:
        path.touch()  # for the reason of a failure, which Qt does not give
        if not self._picture().save(str(path), "PNG"):
            raise OSError(self.tr("The picture could not be written"))

    def open(self, path: Path) -> None:
        """Read a test and keep it beside those that were run."""
        try:
            run = from_csv(_read(path))
        except OSError as error:
            self._reject(path, error.strerror or str(error))
        except UnicodeDecodeError:
            self._reject(path, self.tr("it is not a text file"))
        except BenchFileError as error:
            self._reject(path, str(error))
        else:
            remember_folder(self._store, path)
            self._bench.add_run(run)
            self._notifier.info.emit(self.tr("{0}: {1}.").format(path.name, run.title))

    def _reject(self, path: Path, why: str) -> None:
        self._notifier.error.emit(self.tr("{0} was not opened: {1}.").format(path.name, why))


def _read(path: Path) -> str:
    """Return the text of a file.

    Raises:
        OSError, UnicodeDecodeError: it cannot be read, or is no text.
        BenchFileError: it is far too long.
    """
    with path.open(encoding="utf-8") as file:
        text = file.read(_MAX_LENGTH + 1)
    if len(text) > _MAX_LENGTH:
        raise BenchFileError("it is too long")
    return text
