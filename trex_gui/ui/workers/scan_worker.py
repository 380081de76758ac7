"""Thread that scans one port after the other for devices."""

import threading
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from PySide6.QtCore import QObject, Signal

from trex_gui.core.discovery.prober import ProberInfo, ScanProgress
from trex_gui.core.discovery.scan import PortScan, scan_port
from trex_gui.core.transport.settings import PortSettings
from trex_gui.ui.runtime import open_transport
from trex_gui.ui.workers.threads import WorkerThread


@dataclass(frozen=True, slots=True)
class ScanJob:
    """Scan of one port.

    Attributes:
        probers: the prober of each device kind by its key, the most common kind first.
        first: key of the kind to probe first.
    """

    settings: PortSettings
    probers: Mapping[str, ProberInfo]
    first: str | None = None


@dataclass(frozen=True, slots=True)
class ScanResult:
    """Result of the scan of one port."""

    index: int
    search: PortScan


class ScanWorker(WorkerThread):
    """Runs one scan.

    The object lives in the GUI thread; only `run` executes in the new one. `cancel` and `close`
    may be called from any thread. Its owner keeps it until it has ended.

    Signals:
        stepped: index of the port and the `ScanProgress` of its next step.
        searched: a `ScanResult`, once for each port until the scan is cancelled.
    """

    stepped = Signal(int, object)
    searched = Signal(object)

    def __init__(
        self, jobs: Sequence[ScanJob], parent: QObject | None = None, *, full: bool = False
    ) -> None:
        super().__init__(parent)
        self.setObjectName("ScanWorker")
        self._jobs = tuple(jobs)
        self._full = full
        self._cancelled = threading.Event()

    def run(self) -> None:
        """Scan; called by Qt in the new thread."""
        for index, job in enumerate(self._jobs):
            if self._cancelled.is_set():
                break
            self.searched.emit(self._search(index, job))

    def _search(self, index: int, job: ScanJob) -> ScanResult:
        def report(step: ScanProgress) -> None:
            self.stepped.emit(index, step)

        search = scan_port(
            job.settings,
            job.probers,
            first=job.first,
            full=self._full,
            progress=report,
            cancelled=self._cancelled.is_set,
            open_wire=open_transport,
        )
        return ScanResult(index, search)

    def cancel(self) -> None:
        """End after the current probe: within half a second, later over a network."""
        self._cancelled.set()

    def close(self, timeout_ms: int = 1000) -> bool:
        """Cancel and wait; return whether the thread ended in time."""
        self.cancel()
        return self.wait(timeout_ms)
