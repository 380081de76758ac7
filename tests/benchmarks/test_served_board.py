"""Stops, samples and processor time of boards over the network.

Simulated board, server and relays are separate processes. A relay in front of the board records
when a stop reaches the wire. All processes of a computer share the clock of `time.monotonic`.
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
    with ExitStack() as stack:
        sockets = [stack.enter_context(socket.socket()) for _ in range(count)]
        for each in sockets:
            each.bind(("127.0.0.1", 0))
        return [each.getsockname()[1] for each in sockets]


def free_port() -> int:
    return free_ports(1)[0]


def start(stack: ExitStack, module: str, *arguments: str) -> "subprocess.Popen[str]":
    """Start a program. The stack ends it."""
    process = subprocess.Popen(
        [sys.executable, "-m", module, *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.DEVNULL,
        text=True,
    )

    def end() -> None:
        process.kill()
        process.communicate()

    stack.callback(end)
    return process


class Robot:
    """Simulated board, relay on its wire, and server."""

    def __init__(self, stack: ExitStack, folder: Path, baud: int) -> None:
        self._stack, wire, board = stack, free_port(), free_port()
        options = fast_board(folder, baud)
        self.start_ready("trex_gui.cli.simulator", "--tcp", f"127.0.0.1:{board}", *options)
        self.stops: list[float] = []
        relay = self.start_ready("tests.benchmarks.relay", str(wire), str(board), "0", "0")
        threading.Thread(target=self._read_stops, args=(relay,), daemon=True).start()
        self.line = f"socket://127.0.0.1:{wire}"
        self.port = free_port()
        serving = ("--port", self.line, "--baud", str(baud), "--name", "arm")
        address = f"127.0.0.1:{self.port}"
        self.server = start(stack, "trex_gui.cli", "serve", *serving, "--listen", address)
        time.sleep(2.0)  # prints nothing on stdout when it is ready

    def start_ready(self, module: str, *arguments: str) -> "subprocess.Popen[str]":
        """Start a program and wait until it prints that it is ready."""
        process = start(self._stack, module, *arguments)
        assert process.stdout is not None
        process.stdout.readline()
        return process

    def _read_stops(self, relay: "subprocess.Popen[str]") -> None:
        assert relay.stdout is not None
        for line in relay.stdout:
            self.stops.append(float(line.split()[1]))

    def processor_seconds(self) -> float:
        fields = Path(f"/proc/{self.server.pid}/stat").read_text().rpartition(")")[2].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Client:
    """Session in a thread. Counts its samples and records its outcomes."""

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
        assert number in self.outcomes

    def close(self) -> None:
        self.inbox.put(Close())
        self._thread.join()


@contextmanager
def connect(create: Callable[..., Any]) -> Iterator[Client]:
    client = Client(create)
    try:
        yield client
    finally:
        client.close()


def remote(port: int) -> Callable[..., RemoteSession]:
    settings = ConnectionSettings(Address("127.0.0.1", "arm", port=port).url)
    return lambda inbox, emit: RemoteSession(settings, inbox, emit, time.monotonic)


def measure_stops(robot: Robot, client: Client) -> list[float]:
    """Return the sorted times from the request of a stop to the wire, in ms."""
    delays = []
    for number in range(1, _STOPS + 1):
        client.inbox.put(Arm())
        time.sleep(0.03 + number % 17 / 1000)  # at any time between two polls
        robot.stops.clear()
        requested = time.monotonic()
        client.inbox.put(Stop(number))
        client.wait_for(number)
        first = next((at for at in robot.stops if at >= requested), None)
        assert first is not None
        delays.append(1000 * (first - requested))
    return sorted(delays)


@pytest.fixture
def stack() -> Iterator[ExitStack]:
    with ExitStack() as stack:
        yield stack


@pytest.mark.timeout(600)
@pytest.mark.parametrize("network", ["loopback", "20 ms, 1 % loss"])
def test_stop_over_the_network_reaches_the_wire_in_time(
    network: str, stack: ExitStack, tmp_path: Path, figure: ReportFigure
) -> None:
    robot, delay = Robot(stack, tmp_path, 19200), 0.0
    port = robot.port
    if network != "loopback":
        port, delay = free_port(), 0.02
        robot.start_ready("tests.benchmarks.relay", str(port), str(robot.port), str(delay), "0.01")
    with connect(remote(port)) as client:
        delays = measure_stops(robot, client)
    longest_poll, board_ms = 1 + 11, 5  # bytes of request and reply, time of the board
    transaction = 1000 * LineSettings(19200).seconds(longest_poll) + board_ms
    figure(f"stop over the {network}: median", statistics.median(delays), "ms")
    bound = 1000 * 2 * delay + 2 * transaction + 10
    figure(f"stop over the {network}: 99 %", delays[round(0.99 * _STOPS) - 1], "ms", at_most=bound)


@pytest.mark.timeout(600)
def test_delay_of_stop_beside_busy_processes_is_measured(
    stack: ExitStack, tmp_path: Path, figure: ReportFigure
) -> None:
    robot = Robot(stack, tmp_path, 19200)
    for _ in range(4):
        busy = subprocess.Popen([sys.executable, "-c", "while True: pass"])
        stack.callback(busy.wait)
        stack.callback(busy.kill)
    with connect(remote(robot.port)) as client:
        delays = measure_stops(robot, client)
    name = "stop through a server beside four busy processes"
    figure(f"{name}: median", statistics.median(delays), "ms")
    figure(f"{name}: 99 %", delays[round(0.99 * _STOPS) - 1], "ms")


@pytest.mark.timeout(600)
def test_four_clients_receive_almost_all_samples(
    stack: ExitStack, tmp_path: Path, figure: ReportFigure
) -> None:
    robot = Robot(stack, tmp_path, 115200)
    with ExitStack() as connections:
        clients = [connections.enter_context(connect(remote(robot.port))) for _ in range(4)]
        clients[0].inbox.put(Arm())
        time.sleep(1.0)
        before, used = [client.samples for client in clients], robot.processor_seconds()
        time.sleep(_SAMPLING_S)
        received = [client.samples - first for client, first in zip(clients, before, strict=True)]
        share = (robot.processor_seconds() - used) / _SAMPLING_S
    robot.server.terminate()
    robot.server.wait()
    settings = ConnectionSettings(robot.line, LineSettings(115200))
    with connect(lambda inbox, emit: TrexSession(settings, inbox, emit)) as cable:
        time.sleep(1.0)
        first = cable.samples
        time.sleep(_SAMPLING_S)
        at_cable = cable.samples - first
    figure(
        "samples of the slowest of four clients", 100 * min(received) / at_cable, "%", at_least=99
    )
    figure("processor load of the server with four clients", 100 * share, "%", at_most=15)


_ROBOTS = 100


@pytest.mark.timeout(600)
def test_100_robots_are_listed_in_time_and_stopped(stack: ExitStack, figure: ReportFigure) -> None:
    """Each robot has its own simulator and server."""
    ports = free_ports(2 * _ROBOTS)
    hosts = []
    for wire, port in zip(ports[:_ROBOTS], ports[_ROBOTS:], strict=True):
        start(stack, "trex_gui.cli.simulator", "--tcp", f"127.0.0.1:{wire}", "--unpaced")
        options = ["--port", f"socket://127.0.0.1:{wire}", "--name", f"robot{port}"]
        start(stack, "trex_gui.cli", "serve", *options, "--listen", f"127.0.0.1:{port}")
        hosts.append(f"127.0.0.1:{port}")
    robots = stack.enter_context(Robots())  # as in the window with the list of robots
    end = time.monotonic() + 300
    rows: list[dict[str, Any]] = []
    while time.monotonic() < end:
        start_time = time.monotonic()
        rows = robots.find(hosts)
        duration = time.monotonic() - start_time
        print(len(rows), "robots,", sum(row["responds"] for row in rows), "respond", flush=True)
        if len(rows) == _ROBOTS and all(row["responds"] for row in rows):
            break
        time.sleep(1.0)
    assert len(rows) == _ROBOTS
    assert all(row["responds"] for row in rows)
    figure(f"list of {_ROBOTS} served boards", duration, "s", at_most=3.0)
    urls = [row["url"] for row in rows]
    start_time = time.monotonic()
    results = robots.stop(urls)
    duration = time.monotonic() - start_time
    assert not any(results.values()), results
    figure(f"stop of {_ROBOTS} served boards, all confirmed", 1000 * duration, "ms")
