"""File access outside the GUI thread, since a disk may be slow or hang."""

import io
from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Generic, TextIO, TypeVar, cast

from PySide6.QtCore import QBuffer, QObject, Qt, Slot
from PySide6.QtGui import QImage, QImageWriter
from shiboken6 import Shiboken

from trex_gui.core.errors import StudioError
from trex_gui.core.files import SettingsError, atomic_file, save
from trex_gui.core.recording.kinds import RecordingError
from trex_gui.core.translation import tr
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.file_worker import FileWorker, ProgressCallback

ResultT = TypeVar("ResultT")

_CANCEL_TIMEOUT_MS = 500

background: "set[_Job[Any]]" = set()  # running jobs; the process must not exit before they end


def end_background(timeout_ms: int) -> bool:
    """End all background jobs. Return whether they ended in time.

    A job with `saves` is cancelled after `timeout_ms`, any other job at once. A job that reports no
    progress runs to its end.
    """
    jobs, deadline = tuple(background), now() + timeout_ms / 1000
    for job in jobs:
        if not job.saves:
            job.cancel()
    if all(job.wait(max(0, round((deadline - now()) * 1000))) for job in jobs):
        return True
    for job in jobs:
        job.cancel()
    return all(job.wait(_CANCEL_TIMEOUT_MS) for job in jobs)


@dataclass(frozen=True, slots=True)
class Content:
    text: str
    record_saved: Callable[[Path], object]  # called with the path once the text is saved


class _Job(FileWorker, Generic[ResultT]):
    def __init__(
        self,
        owner: QObject,
        work: Callable[[ProgressCallback], ResultT],
        then: Callable[[ResultT], object],
        failed: Callable[[StudioError], object],
        *,
        saves: bool = False,
    ) -> None:
        super().__init__(work)
        self.saves = saves
        self._owner = owner
        self._then = then
        self._failed = failed
        self.finished.connect(self._on_finished, Qt.ConnectionType.QueuedConnection)
        background.add(self)
        self.start(FileWorker.Priority.LowPriority)

    @Slot()
    def _on_finished(self) -> None:
        self.wait()
        background.discard(self)
        self.deleteLater()
        if self.is_cancelled or not Shiboken.isValid(self._owner):
            return
        if self.outcome.error is not None:
            self._failed(self.outcome.error)
        else:
            self._then(cast("ResultT", self.outcome.result))


def in_background(
    owner: QObject,
    work: Callable[[], ResultT],
    then: Callable[[ResultT], object],
    failed: Callable[[StudioError], object],
) -> None:
    """Run `work` in a new thread.

    Afterwards call `then` or `failed` in the GUI thread, unless the owner has been destroyed.
    """
    start_in_background(owner, lambda _progress: work(), then, failed)


def save_in_background(
    owner: QObject, work: Callable[[], object], notifier: Notifier, saved: str
) -> None:
    in_background(owner, work, lambda _: notifier.info.emit(saved), notifier.report_error)


def start_in_background(
    owner: QObject,
    work: Callable[[ProgressCallback], ResultT],
    then: Callable[[ResultT], object],
    failed: Callable[[StudioError], object],
) -> Callable[[], None]:
    """Run `work` like `in_background`. Return a function that cancels it."""
    return _Job(owner, work, then, failed).cancel


def write_in_background(
    owner: QObject,
    path: Path,
    write: Callable[[TextIO, ProgressCallback], int],
    notifier: Notifier,
    saved: Callable[[int], str],
) -> None:
    """Write a text file atomically. Report `saved(number of rows)` or the error."""
    work = partial(write_text, path, write)
    report = notifier.info.emit
    _Job(owner, work, lambda rows: report(saved(rows)), notifier.report_error, saves=True)


def write_text(
    path: Path, write: Callable[[TextIO, ProgressCallback], int], progress: ProgressCallback
) -> int:
    try:
        with (
            atomic_file(path) as data,
            # Port names may contain undecodable bytes.
            io.TextIOWrapper(data, "utf-8", errors="backslashreplace", newline="") as file,
        ):
            return write(file, progress)
    except OSError as error:
        reason = error.strerror or str(error)
        raise RecordingError(
            path.name, tr("The file cannot be written: {0}.").format(reason.rstrip("."))
        ) from error


def save_picture(path: Path, image: QImage) -> None:
    """Save a picture in the format given by the file extension.

    Raises:
        SettingsError: the picture cannot be written. An existing file is unchanged.
    """
    kind, buffer = path.suffix.removeprefix("."), QBuffer()
    if not QImageWriter(buffer, kind.encode()).write(image):
        message = tr("the name of a picture needs a file extension such as .png")
        if kind:
            message = tr("pictures cannot be written as {0}").format(kind)
        raise SettingsError.of(path, message)
    save(path, bytes(buffer.data().data()))
