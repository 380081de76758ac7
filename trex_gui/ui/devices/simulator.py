"""Simulated devices in the port list: the simulator's process, and its control lines."""

import sys
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass
from typing import Generic, Protocol, TypeVar

from PySide6.QtCore import QObject, QProcess, Signal, Slot

from trex_gui.core.plugin import DevicePlugin
from trex_gui.core.translation import tr
from trex_gui.ui.runtime import new_timer, runtime

SIMULATOR_ARGUMENT = "--simulator"
"""First argument that makes the program run the simulator instead of the window."""

_POLL_INTERVAL_MS = 125
_STOP_TIMEOUT_MS = 1000


def simulator_command() -> tuple[str, list[str]]:
    """Return the program and its first arguments, installed or frozen."""
    if getattr(sys, "frozen", False):
        return sys.executable, [SIMULATOR_ARGUMENT]
    return sys.executable, ["-m", "trex_gui.cli.simulator"]


class Simulator(QObject):
    """Starts the simulator once. While it runs, the device retains its stored values."""

    ready = Signal(str)  # the address to connect to
    failed = Signal(str)  # why it did not start
    ended = Signal()  # it has exited; pending replies never come

    def __init__(self, plugin: DevicePlugin, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._arguments = plugin.simulator_arguments
        self.label = tr("the Demo {0}").format(plugin.name)
        # Address of the running simulator, empty while none runs. It changes each time the cable is
        # plugged in.
        self.url = ""
        self.plugged = True  # whether the cable of the simulated device is plugged in
        self._ending = False
        self._awaited: deque[Callable[[str], None] | None] = deque()
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
        """Send one control line, such as `channel 1 1500us`.

        `then` receives the reply, `ok ...` or `error ...`. Replies come in the order of the lines.
        """
        if self.url:
            self._awaited.append(then)
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
                self._handle_answer(line)
            elif line.startswith("ready "):
                self.url = line.removeprefix("ready ")
                self.plugged = True
                self.ready.emit(self.url)

    def _handle_answer(self, answer: str) -> None:
        match answer.split(maxsplit=2):
            case ["ok", "unplugged"]:
                self.plugged = False
            case ["ok", "plugged", url]:
                self.plugged, self.url = True, url
        if self._awaited and (then := self._awaited.popleft()):
            then(answer)

    @Slot(QProcess.ProcessError)
    def _on_error(self, error: QProcess.ProcessError) -> None:
        if error is QProcess.ProcessError.FailedToStart:
            self.failed.emit(tr("The simulator does not start. Install the program again."))

    @Slot()
    def _on_finished(self) -> None:
        was_running, self.url = bool(self.url), ""
        self._awaited.clear()
        self.ended.emit()
        if not was_running and not self._ending:
            said = bytes(self._process.readAllStandardError().data()).decode(errors="replace")
            reason = said.strip().splitlines()[-1] if said.strip() else ""
            self.failed.emit(tr("The simulator ended at once. {0}").format(reason).strip())


@dataclass(frozen=True, slots=True)
class DemoLine:
    """The wire to this computer. `noise` is the probability that a byte is corrupted."""

    plugged: bool
    mute: bool
    noise: float


class DeviceSnapshot(Protocol):
    """State that every simulated device reports."""

    @property
    def power(self) -> bool: ...
    @property
    def line(self) -> DemoLine: ...


SnapshotT = TypeVar("SnapshotT", bound=DeviceSnapshot)


class DemoDevice(QObject, Generic[SnapshotT]):
    """Operates a simulated device by control lines, and polls its state.

    The device is polled only while watched and while the simulator runs. A slider may move faster
    than the simulator replies. Therefore only one control line of each key is pending, and of the
    lines that follow only the newest is kept.
    """

    changed = Signal()
    rejected = Signal(str)  # why the simulator rejected a control line, for the user

    def __init__(
        self, simulator: Simulator, read: Callable[[str], SnapshotT], parent: QObject | None = None
    ) -> None:
        """Operate the device in `simulator`. `read` parses the JSON that `show` reports."""
        super().__init__(parent)
        self._simulator = simulator
        self._read = read
        # The last state. `None` before the first state, and after the simulator has ended.
        self.snapshot: SnapshotT | None = None
        self._unsent: dict[str, str] = {}
        self._under_way: set[str] = set()
        self._sent = 0
        self._polling = False
        self._timer = new_timer(self, _POLL_INTERVAL_MS, self._poll)
        simulator.ready.connect(self._poll)  # the state is needed while no panel watches, too
        simulator.ended.connect(self._on_simulator_ended)

    def watch(self, watched: bool) -> None:
        if watched and not self._timer.isActive():
            self._timer.start()
            self._poll()
        elif not watched:
            self._timer.stop()

    def set_power(self, on: bool) -> None:
        self._send(f"power {switch(on)}")

    def set_plugged(self, plugged: bool) -> None:
        self._send("line plug" if plugged else "line unplug")

    def set_mute(self, mute: bool) -> None:
        self._send(f"line mute {switch(mute)}")

    def set_noise(self, probability: float) -> None:
        """Corrupt this share of the bytes on the wire."""
        self._send_newest("noise", f"line noise {probability:.4f}")

    def _send(self, line: str, then: Callable[[], None] | None = None) -> None:
        def answered(answer: str) -> None:
            if answer.startswith("error"):
                self.rejected.emit(_sentence(answer.removeprefix("error ")))
                self.changed.emit()  # the panel shows the previous state again
            if then is not None:
                then()
            if self._timer.isActive():
                self._poll()

        self._sent += 1
        self._simulator.send(line, answered)

    def _send_newest(self, key: str, line: str) -> None:
        """Send a control line as soon as the previous line with this key is executed."""

        def done() -> None:
            self._under_way.discard(key)
            if following := self._unsent.pop(key, ""):
                self._send_newest(key, following)

        if key in self._under_way:
            self._unsent[key] = line
        elif self._simulator.url:
            self._under_way.add(key)
            self._send(line, done)

    @Slot()
    def _poll(self) -> None:
        if self._simulator.url and not self._polling:
            sent, self._polling = self._sent, True
            self._simulator.send("show", lambda answer: self._handle_reply(answer, sent))

    def _handle_reply(self, answer: str, sent: int) -> None:
        self._polling = False
        if sent != self._sent:
            if self._timer.isActive():
                self._poll()  # the state is older than a control line sent since
        elif answer.startswith("ok "):
            self._show(self._read(answer.removeprefix("ok ")))

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
        self._under_way.clear()


def switch(on: bool) -> str:
    return "on" if on else "off"


def _sentence(text: str) -> str:
    return f"{text[:1].upper()}{text[1:].rstrip('. ')}."
