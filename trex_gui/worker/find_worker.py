"""One thread that looks for boards on one port after the other."""

import threading
from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QObject, QThread, Signal

from trex_gui.link.discovery import Search, Step, find
from trex_gui.link.settings import LinkSettings
from trex_gui.protocol.errors import TrexError


@dataclass(frozen=True, slots=True)
class Searched:
    """How the search of one port ended: with what it saw, or with why it could not look."""

    index: int
    search: Search | None = None
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
        self, ports: Sequence[LinkSettings], parent: QObject | None = None, *, full: bool = False
    ) -> None:
        super().__init__(parent)
        self.setObjectName("FindWorker")
        self._ports = tuple(ports)
        self._full = full
        self._cancelled = threading.Event()

    def run(self) -> None:
        """Search; called by Qt in the new thread."""
        for index, settings in enumerate(self._ports):
            if self._cancelled.is_set():
                break
            self.searched.emit(self._search(index, settings))

    def _search(self, index: int, settings: LinkSettings) -> Searched:
        def tell(step: Step) -> None:
            self.stepped.emit(index, step)

        try:
            search = find(
                settings, progress=tell, cancelled=self._cancelled.is_set, full=self._full
            )
        except TrexError as error:
            return Searched(index, error=error)
        return Searched(index, search)

    def cancel(self) -> None:
        """End after the question that is on its way: half a second, more behind a network."""
        self._cancelled.set()

    def close(self, timeout_ms: int = 1000) -> bool:
        """Cancel and wait; return whether the thread ended in time."""
        self.cancel()
        return self.wait(timeout_ms)
