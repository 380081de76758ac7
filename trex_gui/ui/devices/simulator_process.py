"""Process of a simulated device in the port list, started when it is first used."""

import sys
from collections import deque
from collections.abc import Callable

from PySide6.QtCore import QObject, QProcess, Signal, Slot

from trex_gui.core.plugin import DevicePlugin
from trex_gui.ui.runtime import runtime

SIMULATOR_ARGUMENT = "--simulator"
"""First argument with which the program itself runs the simulator instead of the window."""


def simulator_command() -> tuple[str, list[str]]:
    """Return program and first arguments that start the simulator, installed or frozen."""
    if getattr(sys, "frozen", False):
        return sys.executable, [SIMULATOR_ARGUMENT]
    return sys.executable, ["-m", "trex_gui.cli.simulator"]


class Simulator(QObject):
    """Starts the simulator once and keeps it running, with what was stored in the device.

    Attributes:
        label: name of the simulated device in messages.

    Signals:
        ready: the address to connect to.
        failed: why it did not start.
        ended: it has exited; pending replies never come.
    """

    ready = Signal(str)
    failed = Signal(str)
    ended = Signal()

    def __init__(self, plugin: DevicePlugin, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._arguments = plugin.simulator_arguments
        self.label = self.tr("the simulated {0}").format(plugin.name)
        self._url = ""
        self._plugged = True
        self._ending = False
        self._awaited: deque[Callable[[str], None] | None] = deque()
        self._process = runtime().process(self)
        self._process.setProcessChannelMode(QProcess.ProcessChannelMode.SeparateChannels)
        self._process.readyReadStandardOutput.connect(self._on_output)
        self._process.errorOccurred.connect(self._on_error)
        self._process.finished.connect(self._on_finished)

    @property
    def url(self) -> str:
        """The address of the running simulator; empty while none runs.

        It is another one when the cable was pulled and put in again.
        """
        return self._url

    @property
    def plugged(self) -> bool:
        """Whether the cable between this computer and the simulated board is in."""
        return self._plugged

    def start(self) -> None:
        """Start it, or announce it again when it runs."""
        if self._url:
            self.ready.emit(self._url)
        elif self._process.state() is QProcess.ProcessState.NotRunning:
            self._ending = False
            program, arguments = simulator_command()
            self._process.start(program, [*arguments, *self._arguments])

    def send(self, line: str, then: Callable[[str], None] | None = None) -> None:
        """Send one control line, such as `channel 1 1500us`.

        `then` gets its answer, `ok ...` or `error ...`; answers come in the order of the lines.
        """
        if self._url:
            self._awaited.append(then)
            self._process.write(f"{line}\n".encode())

    def stop(self) -> None:
        """End it, and wait until it has ended."""
        self._url = ""
        self._ending = True
        if self._process.state() is not QProcess.ProcessState.NotRunning:
            self._process.write(b"quit\n")
            self._process.closeWriteChannel()
            if not self._process.waitForFinished(1000):
                self._process.kill()
                self._process.waitForFinished(1000)

    @Slot()
    def _on_output(self) -> None:
        while self._process.canReadLine():
            line = bytes(self._process.readLine().data()).decode(errors="replace").strip()
            if self._url:
                self._take_answer(line)
            elif line.startswith("ready "):
                self._url = line.removeprefix("ready ")
                self._plugged = True
                self.ready.emit(self._url)

    def _take_answer(self, answer: str) -> None:
        match answer.split(maxsplit=2):
            case ["ok", "unplugged"]:
                self._plugged = False
            case ["ok", "plugged", url]:
                self._plugged, self._url = True, url
        if self._awaited and (then := self._awaited.popleft()):
            then(answer)

    @Slot(QProcess.ProcessError)
    def _on_error(self, error: QProcess.ProcessError) -> None:
        if error is QProcess.ProcessError.FailedToStart:
            self.failed.emit(self.tr("The simulator does not start. Install the program again."))

    @Slot()
    def _on_finished(self) -> None:
        was_running, self._url = bool(self._url), ""
        self._awaited.clear()
        self.ended.emit()
        if not was_running and not self._ending:
            said = bytes(self._process.readAllStandardError().data()).decode(errors="replace")
            reason = said.strip().splitlines()[-1] if said.strip() else ""
            self.failed.emit(self.tr("The simulator ended at once. {0}").format(reason).strip())
