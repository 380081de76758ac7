"""Process of a simulated device, and its control lines."""

import sys
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from PySide6.QtCore import QObject, QProcess, Signal, Slot

from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.translation import tr
from trex_gui.ui.runtime import new_timer, runtime

SIMULATOR_ARGUMENT = "--simulator"  # runs the simulator instead of the window

_POLL_INTERVAL_MS = 125
_STOP_TIMEOUT_MS = 1000


def simulator_command() -> tuple[str, list[str]]:
    if getattr(sys, "frozen", False):
        return sys.executable, [SIMULATOR_ARGUMENT]
    return sys.executable, ["-m", "trex_gui.cli.simulator"]


class Simulator(QObject):
    """Process of a simulated device. The process keeps running between connections."""

    ready = Signal(str)  # address for the connection
    failed = Signal(str)  # reason for a failed start
    ended = Signal()  # the process has exited; pending replies will not arrive

    def __init__(self, plugin: DevicePlugin, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._arguments = plugin.simulator_arguments
        self.label = tr("the Demo {0}").format(plugin.name)
        self.url = ""  # empty without a process; new whenever the cable is plugged in
        self.plugged = True  # state of the simulated cable
        self._ending = False
        self._reply_handlers: deque[Callable[[str], None] | None] = deque()
        self._process = runtime().process(self)
        self._process.setProcessChannelMode(QProcess.ProcessChannelMode.SeparateChannels)
        self._process.readyReadStandardOutput.connect(self._on_output)
        self._process.errorOccurred.connect(self._on_error)
        self._process.finished.connect(self._on_finished)

    def start(self) -> None:
        if self.url:
            self.ready.emit(self.url)
        elif self._process.state() is QProcess.ProcessState.NotRunning:
            self._ending = False
            program, arguments = simulator_command()
            self._process.start(program, [*arguments, *self._arguments])

    def send(self, line: str, then: Callable[[str], None] | None = None) -> None:
        """Send a control line, such as `channel 1 1500us`.

        `then` receives the reply: `ok ...` or `error ...`. Replies arrive in the order of the
        lines.
        """
        if self.url:
            self._reply_handlers.append(then)
            self._process.write(f"{line}\n".encode())

    def stop(self) -> None:
        self.url = ""
        self._ending = True
        if self._process.state() is not QProcess.ProcessState.NotRunning:
            self._process.write(b"quit\n")
            self._process.closeWriteChannel()
            if not self._process.waitForFinished(_STOP_TIMEOUT_MS):
                self._process.kill()
                self._process.waitForFinished(_STOP_TIMEOUT_MS)

    @Slot()
    def _on_output(self) -> None:
        while self._process.canReadLine():
            line = bytes(self._process.readLine().data()).decode(errors="replace").strip()
            if self.url:
                self._on_reply(line)
            elif line.startswith("ready "):
                self.url = line.removeprefix("ready ")
                self.plugged = True
                self.ready.emit(self.url)

    def _on_reply(self, reply: str) -> None:
        match reply.split(maxsplit=2):
            case ["ok", "unplugged"]:
                self.plugged = False
            case ["ok", "plugged", url]:
                self.plugged, self.url = True, url
        if self._reply_handlers and (then := self._reply_handlers.popleft()):
            then(reply)

    @Slot(QProcess.ProcessError)
    def _on_error(self, error: QProcess.ProcessError) -> None:
        if error is QProcess.ProcessError.FailedToStart:
            self.failed.emit(tr("The simulator could not be started. Reinstall the program."))

    @Slot()
    def _on_finished(self) -> None:
        was_running, self.url = bool(self.url), ""
        self._reply_handlers.clear()
        self.ended.emit()
        if not was_running and not self._ending:
            output = bytes(self._process.readAllStandardError().data()).decode(errors="replace")
            reason = output.strip().splitlines()[-1] if output.strip() else ""
            self.failed.emit(tr("The simulator exited immediately. {0}").format(reason).strip())


@dataclass(frozen=True, slots=True)
class DemoLine:
    """State of the simulated cable between the device and this computer."""

    plugged: bool
    mute: bool
    noise: float  # probability that a byte is corrupted


class DeviceSnapshot(Protocol):
    @property
    def power(self) -> bool: ...
    @property
    def line(self) -> DemoLine: ...


SnapshotT = TypeVar("SnapshotT", bound=DeviceSnapshot)


class DemoDevice(QObject, Generic[SnapshotT]):
    """Controls a simulated device and polls its state.

    Polls only while a panel watches and the simulator runs. A slider may move faster than the
    simulator replies. Therefore only one control line per key is in flight, and a newer waiting
    line replaces an older one.
    """

    changed = Signal()  # `snapshot` has changed
    rejected = Signal(str)  # the simulator's reason, as a sentence

    def __init__(
        self, simulator: Simulator, read: Callable[[str], SnapshotT], parent: QObject | None = None
    ) -> None:
        """`read`: parser of the JSON in the reply to `show`."""
        super().__init__(parent)
        self._simulator = simulator
        self._read = read
        self.snapshot: SnapshotT | None = None  # `None` until the simulator replies
        self._unsent: dict[str, str] = {}  # key → waiting control line
        self._in_flight: set[str] = set()  # keys of control lines without a reply
        self._sent = 0  # number of control lines
        self._polling = False
        self._timer = new_timer(self, _POLL_INTERVAL_MS, self._poll)
        simulator.ready.connect(self._poll)  # polls once even if no panel watches
        simulator.ended.connect(self._on_simulator_ended)

    def watch(self, enabled: bool) -> None:
        if enabled and not self._timer.isActive():
            self._timer.start()
            self._poll()
        elif not enabled:
            self._timer.stop()

    def set_power(self, on: bool) -> None:
        self._send(f"power {on_or_off(on)}")

    def set_plugged(self, plugged: bool) -> None:
        self._send("line plug" if plugged else "line unplug")

    def set_mute(self, mute: bool) -> None:
        self._send(f"line mute {on_or_off(mute)}")

    def set_noise(self, probability: float) -> None:
        """Set the probability that a byte on the line is corrupted."""
        self._send_newest("noise", f"line noise {probability:.4f}")

    def _send(self, line: str, then: Callable[[], None] | None = None) -> None:
        def on_reply(reply: str) -> None:
            if reply.startswith("error"):
                self.rejected.emit(_sentence(reply.removeprefix("error ")))
                self.changed.emit()  # the panel shows the previous state again
            if then is not None:
                then()
            if self._timer.isActive():
                self._poll()

        self._sent += 1
        self._simulator.send(line, on_reply)

    def _send_newest(self, key: str, line: str) -> None:
        """Send a control line once the previous line with this key has been answered."""

        def send_waiting() -> None:
            self._in_flight.discard(key)
            if waiting := self._unsent.pop(key, ""):
                self._send_newest(key, waiting)

        if key in self._in_flight:
            self._unsent[key] = line
        elif self._simulator.url:
            self._in_flight.add(key)
            self._send(line, send_waiting)

    @Slot()
    def _poll(self) -> None:
        if self._simulator.url and not self._polling:
            sent, self._polling = self._sent, True
            self._simulator.send("show", lambda reply: self._on_state(reply, sent))

    def _on_state(self, reply: str, sent: int) -> None:
        self._polling = False
        if sent != self._sent:
            if self._timer.isActive():
                self._poll()  # the state is older than the last control line
        elif reply.startswith("ok "):
            self._show(self._read(reply.removeprefix("ok ")))

    def _show(self, snapshot: SnapshotT) -> None:
        before, self.snapshot = self.snapshot, snapshot
        if snapshot != before:
            self.changed.emit()

    @Slot()
    def _on_simulator_ended(self) -> None:
        self._discard()
        self.changed.emit()

    def _discard(self) -> None:
        self.snapshot = None
        self._polling = False
        self._unsent.clear()
        self._in_flight.clear()


def on_or_off(on: bool) -> str:
    return "on" if on else "off"


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:].rstrip('. ')}."
