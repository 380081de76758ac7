"""Scan of ports for boards with unknown line settings."""

import threading
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import partial

from PySide6.QtCore import QObject, Qt, Signal, Slot

from trex_gui.core.discovery.prober import FoundDevice, ScanProgress
from trex_gui.core.discovery.scan import PortScan, scan_port
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.timing import Timeouts
from trex_gui.core.translation import tr
from trex_gui.core.transport.serial_port import Transport
from trex_gui.core.transport.settings import SHARED, PortSettings
from trex_gui.core.transport.traffic import TrafficLog, logged
from trex_gui.ui.devices.ports import Port, PortKind
from trex_gui.ui.devices.simulator import Simulator
from trex_gui.ui.runtime import now, open_transport
from trex_gui.ui.workers.threads import WorkerThread, adopt_orphan

ScanJob = Callable[..., PortScan]  # `scan_port` with the settings of one port


class ScanWorker(WorkerThread):
    """Thread of one scan. `cancel` and `close` may be called from any thread."""

    stepped = Signal(int, object)  # index of the port, `ScanProgress` of the next step
    port_scanned = Signal(int, object)  # index of the port, `PortScan`

    def __init__(self, jobs: Sequence[ScanJob], logs: Sequence[TrafficLog]) -> None:
        super().__init__()
        self.setObjectName("ScanWorker")
        self._open_port: Callable[[PortSettings], Transport] = open_transport
        for log in logs:
            self._open_port = logged(log.record, self._open_port, now)
        self._jobs = tuple(jobs)
        self._cancelled = threading.Event()

    def run(self) -> None:
        for index, job in enumerate(self._jobs):
            if self._cancelled.is_set():
                break
            result = job(
                progress=partial(self.stepped.emit, index),
                cancelled=self._cancelled.is_set,
                open_wire=self._open_port,
            )
            self.port_scanned.emit(index, result)

    def cancel(self) -> None:
        """End the scan after the current probe.

        A probe takes up to half a second, or longer over a network.
        """
        self._cancelled.set()

    def close(self, timeout_ms: int = 1000) -> bool:
        self.cancel()
        return self.wait(timeout_ms)


@dataclass(frozen=True, slots=True)
class ScanFinding:
    """Device found at a port, or the reason why no device was found."""

    port: Port
    text: str  # for the user; may have a paragraph for each kind of device
    found: FoundDevice | None = None
    device: str = ""  # key of the kind of device
    command: str = ""  # shell command that lets the user open the port


class DeviceScanner(QObject):
    """Scans ports one after another. No probe moves a motor of a supported device."""

    changed = Signal()  # `running`, `findings` or `summary` has changed
    progressed = Signal()  # `done`, `total` or `text` has changed
    finished = Signal()  # the scan has ended and its ports are free
    simulators_changed = Signal()  # a simulated device has started or ended

    def __init__(
        self, plugins: Sequence[DevicePlugin] = (), *, timeouts: Timeouts | None = None
    ) -> None:
        """`plugins`: kinds of devices to search for. `core.discovery.scan` describes the order."""
        super().__init__()
        self._plugins = tuple(plugins)
        self._timeouts = timeouts or Timeouts()
        self._simulators: dict[str, Simulator] = {}
        self.logs: list[TrafficLog] = []  # each log records every byte of the scans
        self.next_connection = ("", "")  # kind of device and packed settings of the next connection
        self._worker: ScanWorker | None = None
        self._ports: tuple[Port, ...] = ()
        self.findings: tuple[ScanFinding, ...] = ()  # in the order of the ports
        self._scanned_count = 0
        self._only_recall = False
        self.done = 0  # probes that are done or no longer needed
        self.total = 1  # upper limit of the number of probes
        self.text = ""  # description of the current probe; empty while idle
        self.summary = ""  # sentence about the finished scan
        self.was_cancelled = False

    def add_simulator(self, device: str, simulator: Simulator) -> None:
        """Include a simulated device in scans while it runs."""
        self._simulators[device] = simulator
        simulator.ready.connect(self.simulators_changed)
        simulator.ended.connect(self.simulators_changed)

    def can_scan(self, port: Port) -> bool:
        """Return whether a port can be scanned. A simulated device must be running."""
        if port.kind is not PortKind.DEMO:
            return True
        simulator = self._simulators.get(port.device)
        return simulator is not None and bool(simulator.url)

    @property
    def running(self) -> bool:
        return self._worker is not None

    def is_scanning(self, port: Port) -> bool:
        return self.running and any(map(port.is_same, self._ports[self._scanned_count :]))

    def start(
        self, ports: Sequence[Port], *, full: bool = False, only_recall: bool = False
    ) -> None:
        """Scan ports.

        `full`: also try every CRC polynomial and every device number. `only_recall`: try only the
        settings with which a device was found before.
        """
        if self._worker is not None or not ports:
            return
        self._ports = tuple(ports)
        self.findings = ()
        self._scanned_count = self.done = 0
        self._only_recall = only_recall
        self.total = 1
        self.summary = ""
        self.was_cancelled = False
        self.text = tr("Opening {0} …").format(_name(self._ports[0]))
        jobs = [self._job(port, full=full) for port in self._ports]
        self._worker = ScanWorker(jobs, self.logs)
        self._worker.stepped.connect(self._on_stepped, Qt.ConnectionType.QueuedConnection)
        self._worker.port_scanned.connect(self._on_port_scanned, Qt.ConnectionType.QueuedConnection)
        self._worker.finished.connect(self._on_worker_finished, Qt.ConnectionType.QueuedConnection)
        self._worker.start()
        self.changed.emit()
        self.progressed.emit()

    @Slot()
    def cancel(self) -> None:
        """End the scan after the current probe. Does not wait."""
        if self._worker is not None and not self.was_cancelled:
            self.was_cancelled = True
            self.text = tr("Ending the search …")
            self._worker.cancel()
            self.progressed.emit()

    def shut_down(self) -> bool:
        """End the scan. Return whether it ended within a second."""
        worker, self._worker = self._worker, None
        if worker is None:
            return True
        worker.stepped.disconnect(self._on_stepped)
        worker.port_scanned.disconnect(self._on_port_scanned)
        worker.finished.disconnect(self._on_worker_finished)
        in_time = worker.close()
        if not in_time:
            adopt_orphan(worker)
        return in_time

    def _job(self, port: Port, *, full: bool) -> ScanJob:
        is_demo = port.kind is PortKind.DEMO
        probers = {
            plugin.key: plugin.prober.load()
            for plugin in self._plugins
            if not is_demo or plugin.key == port.device
        }
        scan = partial(scan_port, only_recall=self._only_recall, full=full)
        if is_demo:
            simulator = self._simulators[port.device]
            settings = PortSettings(simulator.url, name=simulator.label, timeouts=self._timeouts)
            return partial(scan, settings, probers)
        settings = PortSettings(port.url, timeouts=self._timeouts)
        first, packed = self._known_settings(port)
        return partial(scan, settings, probers, first=first, packed=packed)

    def _known_settings(self, port: Port) -> tuple[str, str]:
        """Return the kind of device and the packed settings that a scan tries first.

        The settings of the next connection replace those of the port if they are for a shared line.
        Exception: a recall of another kind of device, or of another shared line.
        """
        recalled, (next_kind, next_packed) = (port.device, port.settings), self.next_connection
        is_other = self._only_recall and (port.device != next_kind or SHARED in port.settings)
        return recalled if is_other or SHARED not in next_packed else self.next_connection

    @Slot(int, object)
    def _on_stepped(self, index: int, step: ScanProgress) -> None:
        self.total = len(self._ports) * step.total
        self.done = index * step.total + step.done
        if not self.was_cancelled:
            target = step.kind
            if step.number is not None:
                target = tr("{0} with device number {1}").format(target, step.number)
            text = tr("Looking for {0} at {1} on {2} …")
            self.text = text.format(target, step.line.short, _name(self._ports[index]))
        self.progressed.emit()

    @Slot(int, object)
    def _on_port_scanned(self, index: int, result: PortScan) -> None:
        port = self._ports[index]
        self._scanned_count = index + 1
        if result.found:
            self.findings += tuple(
                ScanFinding(port, self._found_text(found), found, result.device)
                for found in result.found
            )
        elif not result.cancelled and not self._only_recall:
            command = result.error.command if isinstance(result.error, PortUnavailable) else ""
            text = tr(
                "No reply on {0}. No other settings were tried, because other devices "
                "share the line."
            )
            lines = result.lines or [text.format(_name(port))]
            self.findings += (ScanFinding(port, "\n\n".join(lines), command=command),)
        self.changed.emit()

    def _found_text(self, found: FoundDevice) -> str:
        settings, name = found.settings, found.name
        if found.device_number is not None:
            name = tr("{0}, device {1}").format(name, found.device_number)
        text = tr("{0} on {1} at {2} (RS-232 side).") if found.echo else tr("{0} on {1} at {2}.")
        return f"{text.format(name, settings.label, settings.short)} {found.note}".strip()

    @Slot()
    def _on_worker_finished(self) -> None:
        if self._worker is None:
            return
        self._worker.deleteLater()
        self._worker = None
        self.text = ""
        self.done = self.total
        self.summary = self._summary_text()
        self.changed.emit()
        self.progressed.emit()
        self.finished.emit()

    def _summary_text(self) -> str:
        if self._only_recall:
            return ""
        if self.was_cancelled:
            return tr("Search cancelled.")
        boards = sum(finding.found is not None for finding in self.findings)
        return tr("%n board(s) found.", "", boards) if boards else tr("No board was found.")


def _name(port: Port) -> str:
    return port.url or port.label
