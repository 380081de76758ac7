"""Looking for boards whose line settings nobody knows, as the window sees it."""

from collections.abc import Sequence
from dataclasses import dataclass

from PySide6.QtCore import QObject, Qt, Signal, Slot

from trex_gui.core.discovery.prober import FoundDevice, ProberInfo, ScanProgress
from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.settings import PortSettings
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.devices.simulator_process import Simulator
from trex_gui.ui.workers.scan_worker import ScanJob, ScanResult, ScanWorker
from trex_gui.ui.workers.threads import adopt_orphan


@dataclass(frozen=True, slots=True)
class ScanFinding:
    """What came of one port: a board, or in a sentence what was there instead.

    Attributes:
        text: for people: a paragraph, or one for each kind of device that was looked for.
        found: the device; `None` where there was none.
        device: the key of its kind.
    """

    port: Port
    text: str
    found: FoundDevice | None = None
    device: str = ""


class DeviceScanner(QObject):
    """Scans one port after the other; requests only, moves nothing.

    Signals:
        changed: `running`, `findings` or `summary`.
        progressed: `done`, `total` or `text`.
        finished: the ports are free again.
        simulators_changed: `can_search` of the port of a simulated device.
    """

    changed = Signal()
    progressed = Signal()
    finished = Signal()
    simulators_changed = Signal()

    def __init__(self, parent: QObject | None = None, *, timeouts: Timeouts | None = None) -> None:
        super().__init__(parent)
        self._timeouts = timeouts or Timeouts()
        self._probers: dict[str, ProberInfo] = {}
        self._simulators: dict[str, Simulator] = {}
        self._said: dict[str, str] = {}
        self._worker: ScanWorker | None = None
        self._ports: tuple[Port, ...] = ()
        self._findings: tuple[ScanFinding, ...] = ()
        self._searched = 0
        self._done = 0
        self._total = 1
        self._text = ""
        self._summary = ""
        self._cancelled = False
        self._faults = 0

    def add(self, plugin: DevicePlugin, simulator: Simulator) -> None:
        """Look for another kind of device, too; see `core.discovery.scan` for the order."""
        self._probers[plugin.key] = plugin.prober.load()
        self._simulators[plugin.key] = simulator
        simulator.ready.connect(self.simulators_changed)
        simulator.ended.connect(self.simulators_changed)

    def can_search(self, port: Port) -> bool:
        """Whether there is something to look on: a simulated device has to run."""
        return port.kind is not PortKind.DEMO or bool(self._simulators[port.device].url)

    @property
    def running(self) -> bool:
        """Whether a search is under way."""
        return self._worker is not None

    @property
    def findings(self) -> tuple[ScanFinding, ...]:
        """What came of the ports that were searched so far, in their order."""
        return self._findings

    @property
    def done(self) -> int:
        """How many of the `total` probes are done or no longer needed."""
        return self._done

    @property
    def total(self) -> int:
        """How many questions there are at most."""
        return self._total

    @property
    def text(self) -> str:
        """What is tried now; empty while nothing is."""
        return self._text

    @property
    def summary(self) -> str:
        """How the last search ended, in a sentence; empty before any did."""
        return self._summary

    def is_searching(self, port: Port) -> bool:
        """Whether a port is being searched, or will be."""
        return self.running and port in self._ports[self._searched :]

    def start(self, ports: Sequence[Port], *, full: bool = False) -> None:
        """Search these ports; nothing happens while a search is under way, or without ports."""
        if self._worker is not None or not ports:
            return
        self._ports = tuple(ports)
        self._findings = ()
        self._searched = self._done = self._faults = 0
        self._total = 1
        self._summary = ""
        self._cancelled = False
        self._text = self.tr("Opening {0} …").format(_name(self._ports[0]))
        self._worker = ScanWorker([self._job(port) for port in self._ports], full=full)
        self._worker.stepped.connect(self._on_stepped, Qt.ConnectionType.QueuedConnection)
        self._worker.searched.connect(self._on_searched, Qt.ConnectionType.QueuedConnection)
        self._worker.finished.connect(self._on_worker_finished, Qt.ConnectionType.QueuedConnection)
        self._worker.start()
        self.changed.emit()
        self.progressed.emit()

    @Slot()
    def cancel(self) -> None:
        """End the search after the question that is on its way; does not wait for it."""
        if self._worker is not None and not self._cancelled:
            self._cancelled = True
            self._text = self.tr("Ending the search …")
            self._worker.cancel()
            self.progressed.emit()

    def shut_down(self) -> bool:
        """End the search and wait for it, at most a second; return whether it ended in time.

        For the end of the program only; see `Device.shut_down`.
        """
        worker, self._worker = self._worker, None
        if worker is None:
            return True
        worker.stepped.disconnect(self._on_stepped)
        worker.searched.disconnect(self._on_searched)
        worker.finished.disconnect(self._on_worker_finished)
        in_time = worker.close()
        if not in_time:
            adopt_orphan(worker)
        return in_time

    def _job(self, port: Port) -> ScanJob:
        """Look for every kind of device, first for the one that the port is known to lead to."""
        if port.kind is not PortKind.DEMO:
            first = self._said.get(port.url, port.device)
            settings = PortSettings(port.url, timeouts=self._timeouts)
            return ScanJob(settings, dict(self._probers), first)
        simulator = self._simulators[port.device]
        settings = PortSettings(simulator.url, name=simulator.label, timeouts=self._timeouts)
        return ScanJob(settings, {port.device: self._probers[port.device]})

    @Slot(int, object)
    def _on_stepped(self, index: int, step: ScanProgress) -> None:
        self._total = len(self._ports) * step.total
        self._done = index * step.total + step.done
        if not self._cancelled:
            how = step.line.short
            what = step.kind
            if step.number is not None:
                what = self.tr("{0} with device number {1}").format(what, step.number)
            text = self.tr("Looking for {0} at {1} on {2} …")
            self._text = text.format(what, how, _name(self._ports[index]))
        self.progressed.emit()

    @Slot(object)
    def _on_searched(self, searched: ScanResult) -> None:
        port, search = self._ports[searched.index], searched.search
        self._searched = searched.index + 1
        self._faults += search.is_fault
        if search.found:
            self._said[port.url] = search.device
            self._findings += tuple(
                ScanFinding(port, self._sentence(found), found, search.device)
                for found in search.found
            )
        elif not search.cancelled:
            self._findings += (ScanFinding(port, "\n\n".join(search.lines)),)
        self.changed.emit()

    def _sentence(self, found: FoundDevice) -> str:
        settings = found.settings
        text = self.tr("{0} on {1} at {2}").format(found.name, settings.label, settings.short)
        if found.device_number is not None:
            text += self.tr(", device {0}").format(found.device_number)
        if found.echo:
            text += self.tr(" (RS-232 side)")
        return f"{text}. {found.note}".strip()

    @Slot()
    def _on_worker_finished(self) -> None:
        if self._worker is None:
            return
        self._worker.deleteLater()
        self._worker = None
        self._text = ""
        self._done = self._total
        self._summary = self._sum_up()
        self.changed.emit()
        self.progressed.emit()
        self.finished.emit()

    def _sum_up(self) -> str:
        if self._cancelled:
            return self.tr("Search cancelled.")
        boards = sum(finding.found is not None for finding in self._findings)
        if boards == 0:
            text = self.tr("No board was found.")
        elif boards == 1:
            text = self.tr("1 board found.")
        else:
            text = self.tr("{0} boards found.").format(boards)
        missed = self._faults + len(self._ports) - self._searched
        if missed == 1:
            text += self.tr(" 1 port could not be searched (internal error).")
        elif missed:
            text += self.tr(" {0} ports could not be searched (internal error).").format(missed)
        return text


def _name(port: Port) -> str:
    return port.url or port.label
