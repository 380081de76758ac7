"""Reading and writing files beside the window's thread: a disk may be slow or hang."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Generic, TypeVar, cast

from PySide6.QtCore import QBuffer, QObject, Qt, Slot
from PySide6.QtGui import QImage, QImageWriter
from shiboken6 import Shiboken

from trex_gui.core.errors import StudioError
from trex_gui.core.files import SettingsError, save
from trex_gui.core.translation import tr
from trex_gui.ui.notifier import Notifier
from trex_gui.ui.runtime import now
from trex_gui.ui.workers.file_worker import FileWorker, ProgressCallback

ResultT = TypeVar("ResultT")

background: set[FileWorker] = set()
"""What `in_background` runs; the process must not exit normally before it has ended."""


def end_background(timeout_ms: int) -> bool:
    """End all work in the background; return whether it ended in time.

    What reports progress is cancelled, and files that are being saved are finished.
    """
    for job in background:
        job.cancel()
    end = now() + timeout_ms / 1000
    ended = [job.wait(max(0, round((end - now()) * 1000))) for job in tuple(background)]
    return all(ended)


@dataclass(frozen=True, slots=True)
class Content:
    """What a document is to be saved as; `note_saved` takes the path, once it is there."""

    text: str
    note_saved: Callable[[Path], object]


class _Job(FileWorker, Generic[ResultT]):
    """Work whose result goes to its owner, unless that is destroyed before."""

    def __init__(
        self,
        owner: QObject,
        work: Callable[[ProgressCallback], ResultT],
        then: Callable[[ResultT], object],
        failed: Callable[[StudioError], object],
    ) -> None:
        super().__init__(work)
        self._owner = owner
        self._then = then
        self._failed = failed
        self.finished.connect(self._on_finished, Qt.ConnectionType.QueuedConnection)

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
    """Run work on files in a thread of its own, then `then` or `failed` in the GUI thread.

    Neither is called once the owner is destroyed. A disk that hangs blocks nothing else.
    """
    start_in_background(owner, lambda _progress: work(), then, failed)


def save_in_background(
    owner: QObject, work: Callable[[], object], notifier: Notifier, saved: str
) -> None:
    """Run work that writes a file, then report `saved` or why it was not written."""
    in_background(owner, work, lambda _: notifier.info.emit(saved), notifier.report_error)


def start_in_background(
    owner: QObject,
    work: Callable[[ProgressCallback], ResultT],
    then: Callable[[ResultT], object],
    failed: Callable[[StudioError], object],
    progressed: Callable[[float], object] | None = None,
) -> Callable[[], None]:
    """Do the same with work that reports its progress; return what cancels it.

    Work that is cancelled calls back no more.
    """
    job = _Job(owner, work, then, failed)
    if progressed is not None:
        job.progressed.connect(progressed, Qt.ConnectionType.QueuedConnection)
    background.add(job)
    job.start(FileWorker.Priority.LowPriority)
    return job.cancel


def save_picture(path: Path, image: QImage) -> None:
    """Write a picture in the format that its name ends in.

    Raises:
        SettingsError: it cannot be written; then the old file is still there.
    """
    kind, buffer = path.suffix.removeprefix("."), QBuffer()
    if not QImageWriter(buffer, kind.encode()).write(image):
        message = tr("pictures cannot be written without a file extension such as .png")
        if kind:
            message = tr("pictures cannot be written as {0}").format(kind)
        raise SettingsError.of(path, message)
    save(path, bytes(buffer.data().data()))
