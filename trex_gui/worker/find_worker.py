"""One thread that looks for devices on one port after the other."""

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Protocol

from PySide6.QtCore import QObject, QThread, Signal

from trex_gui.link.discovery import Step
from trex_gui.link.settings import LinkSettings
from trex_gui.protocol.errors import TrexError


class Sighting(Protocol):
    """A device that was found, and how to reach it."""

    @property
    def settings(self) -> LinkSettings:
        """What to connect with."""
        ...

    @property
    def name(self) -> str:
        """Which device it is."""
        ...

    @property
    def device_number(self) -> int | None:
        """The number that it answers to, where it has one."""
        ...

    @property
    def echo(self) -> bool:
        """Whether everything sent comes back."""
        ...

    @property
    def note(self) -> str:
        """What else to know of it, for people; may be empty."""
        ...


class Seen(Protocol):
    """What a search of one port has seen."""

    @property
    def found(self) -> Sequence[Sighting]:
        """The devices; more than one only where several share the line."""
        ...

    @property
    def cancelled(self) -> bool:
        """Whether it ended early because it was asked to."""
        ...

    def verdict(self) -> str:
        """Say what was seen where no device was found, and what to look at."""
        ...


class Seek(Protocol):
    """Looks for devices of one kind on a port, and moves nothing."""

    def __call__(
        self,
        settings: LinkSettings,
        *,
        progress: Callable[[Step], None],
        cancelled: Callable[[], bool],
        full: bool,
    ) -> Seen:
        """Return what was seen.

        Raises:
            PortUnavailable: the port cannot be opened, or is gone.
        """
        ...


@dataclass(frozen=True, slots=True)
class Errand:
    """One port, and what to look for there: seekers by the key of the kind of device, in order."""

    settings: LinkSettings
    seekers: tuple[tuple[str, Seek], ...]


@dataclass(frozen=True, slots=True)
class Searched:
    """How the search of one port ended: with what it saw, or with why it could not look.

    `device` is the key of the kind of device that was looked for last: that was found, if any was.
    """

    index: int
    device: str
    search: Seen | None = None
    error: TrexError | None = None


class FindWorker(QThread):
    """Runs one search.

    The object lives in the GUI thread; only `run` executes in the new one. `cancel` and `close`
    may be called from any thread. Its owner keeps it until it is finished.

    Signals:
        stepped: index of the port, and the `Step` that comes next.
        searched: a `Searched`, once for each port until it is cancelled.
    """

    stepped = Signal(int, object)
    searched = Signal(object)

    def __init__(
        self, errands: Sequence[Errand], parent: QObject | None = None, *, full: bool = False
    ) -> None:
        super().__init__(parent)
        self.setObjectName("FindWorker")
        self._errands = tuple(errands)
        self._full = full
        self._cancelled = threading.Event()

    def run(self) -> None:
        """Search; called by Qt in the new thread."""
        for index, errand in enumerate(self._errands):
            if self._cancelled.is_set():
                break
            self.searched.emit(self._search(index, errand))

    def _search(self, index: int, errand: Errand) -> Searched:
        """Look for one kind after the other, until one is found."""

        def tell(step: Step) -> None:
            self.stepped.emit(index, step)

        search: Seen | None = None
        device = ""
        for device, seek in errand.seekers:
            try:
                search = seek(
                    errand.settings,
                    progress=tell,
                    cancelled=self._cancelled.is_set,
                    full=self._full,
                )
            except TrexError as error:
                return Searched(index, device, error=error)
            if search.found or self._cancelled.is_set():
                break
        return Searched(index, device, search)

    def cancel(self) -> None:
        """End after the question that is on its way: half a second, more behind a network."""
        self._cancelled.set()

    def close(self, timeout_ms: int = 1000) -> bool:
        """Cancel and wait; return whether the thread ended in time."""
        self.cancel()
        return self.wait(timeout_ms)
