"""Simulated devices in virtual time, at ports that the program opens."""

import errno
import math
import shutil
from collections import deque
from collections.abc import Callable, Collection, Sequence

import click
from PySide6.QtCore import QByteArray, QObject, QProcess

from tests.support.guardian import VirtualGuardian
from tests.support.simulator import PortFault, SimulatedDevice
from tests.support.virtual_time import VirtualRuntime
from trex_gui.cli import simulator
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.simulator.control_lines import GOODBYE
from trex_gui.core.simulator.plugin import Simulation
from trex_gui.core.transport.serial_port import Transport, open_error
from trex_gui.core.transport.settings import PortSettings, SerialFormat

_EPSILON = 1e-9  # seconds; more than the rounding errors of summed times
_CHECK_S = 0.02  # time between two checks of the cable
_SLOW_S = 0.1  # time of a write to a slow port
_JAMMED_S = 1.0  # time until a write to a jammed port fails
_HANDOVER_S = 1.5  # time that the program waits for a port that it still has open


class VirtualSimulator(SimulatedDevice):
    """Simulation in this process, with the options and control lines of `trex-sim`.

    Attributes:
        on_write: called with the bytes of each write, before they are sent, in the host's thread.
        on_close: called when the host closes the port, before another host can open it.
        rates: baud rates of the port, or `None` if it does not report them.
    """

    def __init__(self, runtime: VirtualRuntime, url: str, *arguments: str) -> None:
        self.runtime = runtime
        self.url = url
        self.simulation = _simulation(arguments)
        self.line = self.simulation.line
        self.host: VirtualTransport | None = None
        self.on_write: Callable[[bytes], object] = _do_nothing
        self.on_close: Callable[[], object] = _do_nothing
        self.rates: frozenset[int] | None = None
        self.port_fault = PortFault.NONE
        self._start = runtime.now() - self.line.now
        runtime.ports[url] = self

    def set_port_fault(self, fault: PortFault) -> None:
        self.port_fault = fault

    def end(self) -> None:
        self.line.unplug()
        self.runtime.ports.pop(self.url, None)

    def control(self, line: str) -> str:
        self.catch_up()
        was_plugged = self.line.faults.plugged
        reply = self.simulation.control(line)
        if was_plugged and not self.line.faults.plugged:
            self.line.drop_unsent()
        elif self.line.faults.plugged and not was_plugged:
            reply = f"{reply} {self.url}"
        return reply

    def move_cable_to(self, other: "VirtualSimulator") -> None:
        """Connect the open port to another device instead of this device."""
        host, self.host = self.host, None
        assert host is not None
        assert other.host is None
        other.host = host
        host.use(other)

    # --- Transport ----------------------------------------------------------------------

    def catch_up(self) -> None:
        """Process all events on the line up to the current time."""
        self.line.advance_to(self.runtime.now() - self._start + _EPSILON)

    def run_until_received(self, size: int, end: float) -> float:
        """Process events on the line until the host has received bytes, but not after `end`.

        Return the runtime's time of the last byte, or else of the next event.
        """
        if self.line.run_until_received(size, end - self._start):
            return self._start + self.line.now
        event = self.line.next_event
        return math.inf if event is None else self._start + event

    def open(self, settings: PortSettings) -> Transport:
        """Open the port. See `SerialTransport`."""
        deadline = self.runtime.now() + _HANDOVER_S
        while self.host is not None and self.runtime.now() < deadline:
            self.runtime.sleep(_CHECK_S)
        if self.host is not None or not self.line.faults.plugged:
            number = errno.EBUSY if self.host is not None else errno.ENOENT
            raise open_error(settings.url, settings.line, OSError(number, ""))
        self.host = VirtualTransport(self, settings)
        return self.host


def _do_nothing(*_: object) -> None:
    pass


def _simulation(arguments: Sequence[str]) -> Simulation:
    command = simulator.main
    assert isinstance(command, click.Command)
    context = command.make_context("trex-sim", list(arguments))
    for name in ("link", "tcp", "rfc2217"):
        assert context.params[name] is None, f"{name} has no meaning in virtual time"
    return simulator.simulate(context)


class VirtualTransport:
    """Transport of the program to a simulated device."""

    latency = 0.06
    is_configurable = True

    def __init__(self, simulator: VirtualSimulator, settings: PortSettings) -> None:
        self._runtime = simulator.runtime
        self.clock = self._runtime.now
        self._name = settings.name or settings.url
        self._received = bytearray()
        self._is_open = True
        self._format = settings.line
        self.use(simulator)

    def use(self, simulator: VirtualSimulator) -> None:
        """Connect this host to a device."""
        self._simulator = simulator
        self._line = simulator.line
        simulator.catch_up()
        self._line.receive()  # discards earlier bytes
        self._line.host = self._format

    def rates(self, wanted: Collection[int]) -> frozenset[int] | None:
        return self._simulator.rates

    def reconfigure(self, line: SerialFormat) -> None:
        self._catch_up()
        self._line.host = self._format = line

    def write(self, data: bytes) -> None:
        self._simulator.on_write(data)
        fault = self._simulator.port_fault
        if fault is PortFault.JAMMED:
            self._runtime.sleep(_JAMMED_S)
            raise self._gone()
        if fault is PortFault.SLOW:
            self._runtime.sleep(_SLOW_S)
        self._catch_up()
        self._line.send(data)
        self._catch_up()

    def read(self, size: int, seconds: float) -> bytes:
        deadline = self.clock() + seconds
        while True:
            self._catch_up()
            if len(self._received) >= size or self.clock() >= deadline:
                data = bytes(self._received[:size])
                del self._received[:size]
                return data
            end, missing = min(deadline, self.clock() + _CHECK_S), size - len(self._received)
            # Another task may change the line at the next event of the runtime.
            alone_until = min(end, self._runtime.next_event)
            moment = self._simulator.run_until_received(missing, alone_until)
            self._runtime.sleep_until(max(min(moment, end), self.clock() + _EPSILON))

    def discard(self) -> bytes:
        self._catch_up()
        stale = bytes(self._received)
        self._received.clear()
        return stale

    def wait(self, seconds: float) -> None:
        self._runtime.sleep(seconds)

    def start_guardian(self, silence: float) -> VirtualGuardian:
        self.guardian = VirtualGuardian()
        return self.guardian

    def close(self) -> None:
        if self._is_open:
            self._simulator.on_close()
            self._is_open = False
            self._simulator.host = None

    def _catch_up(self) -> None:
        self._simulator.catch_up()
        if not self._line.faults.plugged or not self._is_open:
            raise self._gone()
        received = self._line.receive()
        fault = self._simulator.port_fault
        if fault is PortFault.NONE or fault is PortFault.SLOW:
            self._received += received

    def _gone(self) -> PortUnavailable:
        text = f"The connection to {self._name} is gone. Plug the adapter in, then connect again."
        return PortUnavailable(text, is_missing=True)


class VirtualProcess(QProcess):
    """Process of a simulator, simulated in virtual time. It needs some time to start."""

    _START_S = 0.3

    def __init__(self, runtime: VirtualRuntime, parent: QObject) -> None:
        super().__init__(parent)
        self._runtime = runtime
        self._simulator: VirtualSimulator | None = None
        self._state = QProcess.ProcessState.NotRunning
        self._output: deque[str] = deque()

    def start(self, program: str, arguments: Sequence[str]) -> None:  # type: ignore[override]
        if shutil.which(program) is None:
            self._runtime.at(self._runtime.now(), self._fail_to_start, of_gui=True)
            return
        self._state = QProcess.ProcessState.Running
        options = [word for word in arguments if word not in {"-m", "trex_gui.cli.simulator"}]

        def on_started() -> None:
            if self._state is QProcess.ProcessState.Running:
                url = f"/virtual/demo{len(self._runtime.ports)}"
                self._simulator = VirtualSimulator(self._runtime, url, *options)
                self._print(f"ready {url}")

        self._runtime.at(self._runtime.now() + self._START_S, on_started, of_gui=True)

    def _fail_to_start(self) -> None:
        self.errorOccurred.emit(QProcess.ProcessError.FailedToStart)

    def state(self) -> QProcess.ProcessState:
        return self._state

    def write(self, data: bytes) -> int:  # type: ignore[override]
        for line in data.decode().splitlines():
            if self._simulator is not None:
                self._obey(self._simulator, line)
        return len(data)

    def closeWriteChannel(self) -> None:
        pass

    def canReadLine(self) -> bool:
        return bool(self._output)

    def readLine(self) -> QByteArray:  # type: ignore[override]
        return QByteArray(self._output.popleft().encode() + b"\n")

    def readAllStandardError(self) -> QByteArray:
        return QByteArray()

    def waitForFinished(self, milliseconds: int = 30_000) -> bool:
        del milliseconds
        return self._state is QProcess.ProcessState.NotRunning

    def kill(self) -> None:
        self._end()

    def _obey(self, simulator: VirtualSimulator, line: str) -> None:
        reply = simulator.control(line)
        self._runtime.at(self._runtime.now(), lambda: self._print(reply), of_gui=True)
        if reply == GOODBYE:
            self._end()

    def _print(self, text: str) -> None:
        self._output.append(text)
        self.readyReadStandardOutput.emit()

    def _end(self) -> None:
        if self._simulator is not None:
            self._simulator.end()
            self._simulator = None
        self._state = QProcess.ProcessState.NotRunning
        self._output.clear()
        code, status = 0, QProcess.ExitStatus.NormalExit
        self._runtime.at(self._runtime.now(), lambda: self.finished.emit(code, status), of_gui=True)
