"""Stops, samples and processor time of boards over the network.

Simulated board, server and relays are separate processes. A relay before the board records when a
stop reaches the wire. All processes of a computer share the clock of `time.monotonic`.
"""

import os
import socket
import statistics
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import Any

import pytest

from tests.benchmarks.conftest import ReportFigure, fast_board
from trex_gui.core.session import Close, Outcome, RequestQueue
from trex_gui.core.transport.urls import Address
from trex_gui.devices.trex.driving.requests import Arm, Stop
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.serve.remote_session import RemoteSession
from trex_gui.devices.trex.serve.robots import Robots
from trex_gui.devices.trex.session.messages import Batch, Connected
from trex_gui.devices.trex.session.session import TrexSession

_STOPS = 300
_SAMPLING_S = 10.0


def free_ports(count: int) -> list[int]:
    with ExitStack() as held:
        sockets = [held.enter_context(socket.socket()) for _ in range(count)]
        for found in sockets:
            found.bind(("127.0.0.1", 0))
        return [found.getsockname()[1] for found in sockets]


def free_port() -> int:
    return free_ports(1)[0]


class Robot:
    """Simulated board, relay on its wire, and server."""

    def __init__(self, stack: ExitStack, folder: Path, baud: int) -> None:
        self._stack, wire, board = stack, free_port(), free_port()
        options = fast_board(folder, baud)
        self.start("trex_gui.cli.simulator", "--tcp", f"127.0.0.1:{board}", *options)
        self.stops: list[float] = []
        tap = self.start("tests.benchmarks.relay", str(wire), str(board), "0", "0")
        threading.Thread(target=self._read_stops, args=(tap,), daemon=True).start()
        self.line = f"socket://127.0.0.1:{wire}"
        self.port = free_port()
        words = ["--port", self.line, "--baud", str(baud), "--name", "arm"]
        self.server = self.start(
            "trex_gui.cli", "serve", *words, "--listen", f"127.0.0.1:{self.port}"
        )
        time.sleep(2.0)

    def start(self, module: str, *words: str) -> "subprocess.Popen[str]":
        process = subprocess.Popen(
            [sys.executable, "-m", module, *words],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            text=True,
        )

        def end() -> None:
            process.kill()
            process.communicate()

        self._stack.callback(end)
        if module != "trex_gui.cli":
            assert process.stdout is not None
            process.stdout.readline()  # ready
        return process

    def _read_stops(self, tap: "subprocess.Popen[str]") -> None:
        assert tap.stdout is not None
        for line in tap.stdout:
            self.stops.append(float(line.split()[1]))

    def processor_seconds(self) -> float:
        fields = Path(f"/proc/{self.server.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Client:
    """Session and its reports."""

    def __init__(self, create: Callable[..., Any]) -> None:
        self.inbox, self.samples, self.outcomes = RequestQueue(), 0, set[int]()
        self._is_connected = threading.Event()
        self._thread = threading.Thread(target=create(self.inbox, self._on_report).run)
        self._thread.start()
        assert self._is_connected.wait(20)

    def _on_report(self, report: object) -> None:
        match report:
            case Batch(samples=samples):
                self.samples += len(samples)
            case Outcome(id=number):
                self.outcomes.add(number)
            case Connected():
                self._is_connected.set()

    def wait_for(self, number: int) -> None:
        end = time.monotonic() + 10
        while number not in self.outcomes and time.monotonic() < end:
            time.sleep(0.001)

    def close(self) -> None:
        self.inbox.put(Close())
        self._thread.join()


@contextmanager
def client(create: Callable[..., Any]) -> Iterator[Client]:
    opened = Client(create)
    try:
        yield opened
    finally:
        opened.close()


def remote(port: int) -> Callable[..., RemoteSession]:
    settings = ConnectionSettings(Address("127.0.0.1", "arm", port=port).url)
    return lambda inbox, emit: RemoteSession(settings, inbox, emit, time.monotonic)


def measure_stops(robot: Robot, one: Client) -> list[float]:
    """Return the time of each stop from its request to the wire, in ms."""
    took = []
    for number in range(1, _STOPS + 1):
        one.inbox.put(Arm())
        time.sleep(0.03 + number % 17 / 1000)  # anywhere between two polls
        robot.stops.clear()
        pressed = time.monotonic()
        one.inbox.put(Stop(number))
        one.wait_for(number)
        first = next((at for at in robot.stops if at >= pressed), None)
        assert first is not None
        took.append(1000 * (first - pressed))
    return sorted(took)


@pytest.fixture
def stack() -> Iterator[ExitStack]:
    with ExitStack() as made:
        yield made


@pytest.mark.timeout(600)
@pytest.mark.parametrize("network", ["loopback", "20 ms, 1 % loss"])
def test_stop_over_the_network(
    network: str, stack: ExitStack, tmp_path: Path, figure: ReportFigure
) -> None:
    robot, delay = Robot(stack, tmp_path, 19200), 0.0
    port = robot.port
    if network != "loopback":
        port, delay = free_port(), 0.02
        robot.start("tests.benchmarks.relay", str(port), str(robot.port), str(delay), "0.01")
    with client(remote(port)) as one:
        took = measure_stops(robot, one)
    transaction = 1000 * LineSettings(19200).seconds(1 + 11) + 5  # the longest poll, and its board
    figure(f"stop over the {network}: median", statistics.median(took), "ms")
    bound = 1000 * 2 * delay + 2 * transaction + 10
    figure(f"stop over the {network}: 99 %", took[round(0.99 * _STOPS) - 1], "ms", at_most=bound)


@pytest.mark.timeout(600)
def test_stop_beside_busy_processes(stack: ExitStack, tmp_path: Path, figure: ReportFigure) -> None:
    robot = Robot(stack, tmp_path, 19200)
    for _ in range(4):
        busy = subprocess.Popen([sys.executable, "-c", "while True: pass"])
        stack.callback(busy.wait)
        stack.callback(busy.kill)
    with client(remote(robot.port)) as one:
        took = measure_stops(robot, one)
    figure(
        "stop through a server beside four busy processes: median", statistics.median(took), "ms"
    )
    figure(
        "stop through a server beside four busy processes: 99 %",
        took[round(0.99 * _STOPS) - 1],
        "ms",
    )


@pytest.mark.timeout(600)
def test_samples_of_four_clients(stack: ExitStack, tmp_path: Path, figure: ReportFigure) -> None:
    robot = Robot(stack, tmp_path, 115200)
    with ExitStack() as clients:
        some = [clients.enter_context(client(remote(robot.port))) for _ in range(4)]
        some[0].inbox.put(Arm())
        time.sleep(1.0)
        before, used = [one.samples for one in some], robot.processor_seconds()
        time.sleep(_SAMPLING_S)
        seen = [one.samples - start for one, start in zip(some, before, strict=True)]
        share = (robot.processor_seconds() - used) / _SAMPLING_S
    robot.server.terminate()
    robot.server.wait()
    settings = ConnectionSettings(robot.line, LineSettings(115200))
    with client(lambda inbox, emit: TrexSession(settings, inbox, emit)) as cable:
        time.sleep(1.0)
        start = cable.samples
        time.sleep(_SAMPLING_S)
        at_cable = cable.samples - start
    figure("samples of the slowest of four clients", 100 * min(seen) / at_cable, "%", at_least=99)
    figure("processor of the server with four clients", 100 * share, "%", at_most=15)


_MANY = 100


@pytest.mark.timeout(600)
def test_many_robots(stack: ExitStack, figure: ReportFigure) -> None:
    """Each board has a simulator and a server."""
    ports = free_ports(2 * _MANY)
    hosts = []
    for wire, port in zip(ports[:_MANY], ports[_MANY:], strict=True):
        _start(stack, "trex_gui.cli.simulator", "--tcp", f"127.0.0.1:{wire}", "--unpaced")
        words = ["--port", f"socket://127.0.0.1:{wire}", "--name", f"robot{port}"]
        _start(stack, "trex_gui.cli", "serve", *words, "--listen", f"127.0.0.1:{port}")
        hosts.append(f"127.0.0.1:{port}")
    robots = stack.enter_context(Robots())  # as the window with the list has them
    end = time.monotonic() + 300
    rows: list[dict[str, Any]] = []
    while time.monotonic() < end:
        begun = time.monotonic()
        rows = robots.find(hosts)
        took = time.monotonic() - begun
        print(len(rows), "robots,", sum(row["responds"] for row in rows), "respond", flush=True)
        if len(rows) == _MANY and all(row["responds"] for row in rows):
            break
        time.sleep(1.0)
    assert len(rows) == _MANY
    figure(f"list of {_MANY} served boards", took, "s", at_most=3.0)
    urls = [row["url"] for row in rows]
    begun = time.monotonic()
    results = robots.stop(urls)
    took = time.monotonic() - begun
    assert not any(results.values()), results
    figure(f"stop of {_MANY} served boards, all confirmed", 1000 * took, "ms")


def _start(stack: ExitStack, module: str, *words: str) -> None:
    process = subprocess.Popen(
        [sys.executable, "-m", module, *words],
        stdin=subprocess.PIPE,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )

    def end() -> None:
        process.kill()
        process.communicate()

    stack.callback(end)
