"""Automatic connection to known boards and to adapters that are plugged in again."""

from collections import deque
from collections.abc import Sequence

from PySide6.QtCore import QObject, QTimer, Slot

from trex_gui.core.translation import tr
from trex_gui.core.transport.linux_ports import holder_of
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.device_manager import DeviceManager
from trex_gui.ui.devices.ports import Port, PortKind, Ports
from trex_gui.ui.devices.scanner import ScanFinding
from trex_gui.ui.files import in_background
from trex_gui.ui.notifier import Notifier, Remedies, Remedy
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.runtime import new_timer

_KEY = "connection/automatic"

_SETTLE_MS = 700
"""Delay before the program opens a port that has appeared. The system lists a port before it grants
access, and may still list the port of an unplugged adapter for a moment."""


def connects_automatically() -> bool:
    return Preferences().flag(_KEY, default=True)


def set_connects_automatically(enabled: bool) -> None:
    Preferences().set(_KEY, enabled)


class AutoConnect(QObject):
    """Connects automatically, unless the user has disabled this.

    - When the program starts or an adapter is plugged in: connects to a port at which a device was
      found before, if only one device replies. At the start, the last used port is probed alone,
      and the adapters are probed only if nothing replies there. Each port is probed once, only with
      the settings of the device found there. A visible problem prevents the connection.
      *Disconnect* also prevents it, until the user connects again.
    - When a missing adapter, or an adapter whose line was lost, is plugged in again: connects even
      if the name of its port has changed. Another adapter with the old name is not used.

    A port that another program has open is skipped. The motors remain disarmed.
    """

    def __init__(
        self,
        ports: Ports,
        manager: DeviceManager,
        notifier: Notifier,
        parent: QObject | None = None,
    ) -> None:
        super().__init__(parent)
        self._ports = ports
        self._manager = manager
        self._notifier = notifier
        self._scanner = manager.scanner
        self._present: Sequence[Port] = ()  # ports at the last check
        self._batches: deque[list[Port]] = deque()  # groups of ports to probe
        self._is_probing = False
        self._tried: Port | None = None  # port of the last connection attempt
        self._missing: Port | None = None  # connect to this port when it is plugged in
        self._may_be_stale = False  # the system may still list the missing port
        self._notice = ""  # message to show after the next connection
        self._timer = new_timer(self, _SETTLE_MS, self._on_settled, single_shot=True)

    def start(self, *, at_once: bool = True) -> None:
        """Start watching. `at_once`: treat present adapters as if they were just plugged in."""
        self._ports.changed.connect(self._on_ports_changed)
        self._manager.changed.connect(self._on_link_changed)
        self._scanner.finished.connect(self._on_scan_finished)
        self._notifier.remedies_offered.connect(self._on_remedies_offered)
        self._present = self._ports.entries
        if not at_once:
            return
        last = self._ports.last_used
        # A typed address may now belong to another target: a pseudo-terminal may run a shell.
        first = [last] if last is not None and last.kind is PortKind.SERIAL else []
        self._start_probing(first, [port for port in _adapters(self._present) if port != last])

    @Slot()
    def _on_link_changed(self) -> None:
        current = self._manager.current
        if current.port is not None and current.port != self._tried:
            self._tried, self._missing = current.port, None
        if current.link is ConnectionState.CONNECTED:
            self._missing, self._may_be_stale = None, False
            if self._notice:
                # Shown after the messages of the device, which take precedence.
                QTimer.singleShot(0, self._show_notice)

    @Slot()
    def _show_notice(self) -> None:
        text, self._notice = self._notice, ""
        if text and self._notifier.shown:
            self._notifier.logged.emit(text, False)
        elif text:
            self._notifier.info.emit(text)

    @Slot(object)
    def _on_remedies_offered(self, remedies: Remedies) -> None:
        if Remedy.PLUG_IN in remedies:
            self._missing = self._tried
            self._timer.start()

    def _find_missing(self) -> Port | None:
        missing = self._missing
        if missing is None:
            return None
        ports = self._ports
        found = ports.current_entry(missing) if missing.adapter else ports.find(missing.url)
        # A typed address is always listed, so it cannot return.
        return found if found is not None and found.kind is PortKind.SERIAL else None

    def _reconnect(self) -> bool:
        """Connect to the missing port if it has returned. Return True if a connection starts."""
        found, missing = self._find_missing(), self._missing
        if found is None or missing is None or self._may_be_stale:
            return False
        self._missing = None
        self._notifier.resolved.emit(Remedy.PLUG_IN)
        if not self._is_allowed or not found.is_same(missing):
            return False
        self._may_be_stale = True
        self._notice = tr("Reconnected to {0}. No motor was started.").format(found.url)
        self._notifier.cleared.emit()
        self._manager.connect_to(found)
        return True

    @property
    def _is_allowed(self) -> bool:
        is_prevented = self._manager.user_disconnected or self._notifier.shows_problem
        return connects_automatically() and self._manager.is_idle and not is_prevented

    @Slot()
    def _on_ports_changed(self) -> None:
        listed = self._ports.entries
        self._present = [port for port in self._present if port in listed]
        if self._missing is not None and self._find_missing() is None:
            self._may_be_stale = False
        self._timer.start()

    @Slot()
    def _on_settled(self) -> None:
        self._ports.refresh()
        if self._timer.isActive():
            return  # the ports have changed again
        before, self._present = self._present, self._ports.entries
        if not self._reconnect():
            new = [port for port in self._present if port not in before]
            self._start_probing(_adapters(new))

    def _start_probing(self, *batches: list[Port]) -> None:
        if not self._is_probing:
            self._batches = deque(filter(None, batches))
            self._probe_next()

    def _probe_next(self) -> None:
        if not self._batches:
            return
        ports = self._batches.popleft()
        in_background(
            self,
            lambda: [port for port in ports if holder_of(port.url) is None],
            self._probe,
            lambda _: None,
        )

    def _probe(self, free: list[Port]) -> None:
        if not self._is_allowed or self._scanner.running:
            return
        self._is_probing = bool(free)
        if free:
            self._scanner.start(free, only_recall=True)
        else:
            self._probe_next()

    @Slot()
    def _on_scan_finished(self) -> None:
        if not self._is_probing:
            return
        self._is_probing = False
        if self._scanner.was_cancelled or not self._is_allowed:
            return
        match self._scanner.findings:
            case [ScanFinding(port=port, found=found)] if found is not None:
                self._manager.connect_with(port, found.settings)
            case []:
                self._probe_next()


def _adapters(ports: Sequence[Port]) -> list[Port]:
    """Return the adapters at which a device was found before."""
    return [port for port in ports if port.settings and port.adapter is not None]
