"""Simulated boards that are served over Zenoh on the loopback, in real time."""

import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from dataclasses import replace
from itertools import count
from pathlib import Path
from typing import Any, Self

import pytest
import zenoh

from tests.devices.trex.conftest import STOPPED, motor, running_script, target_speeds
from tests.devices.trex.simulator.waiting import comes_true
from tests.support.patient import PATIENT
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui import Trex, TrexLine
from trex_gui.core.errors import BadRequest, NoReply, PortUnavailable, StudioError
from trex_gui.core.resource_files import resource
from trex_gui.core.transport.urls import LOCAL_USER, Address
from trex_gui.devices.trex.cli.serve import add_user
from trex_gui.devices.trex.driving.requests import Arm, SetMotor
from trex_gui.devices.trex.open_board import MotorsStoppedError
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.serve.codec import VERSION, Hello, encode_request
from trex_gui.devices.trex.serve.network import key, open_client
from trex_gui.devices.trex.serve.robots import Robots
from trex_gui.devices.trex.serve.served_board import _CLIENT_LIMIT
from trex_gui.devices.trex.session.messages import AskLease

pytestmark = pytest.mark.realtime

_TIMEOUT = 10.0  # seconds


def find_robots(hosts: list[str]) -> list[dict[str, Any]]:
    with Robots() as robots:
        return robots.find(hosts)


def stop_robots(names: list[str]) -> dict[str, str]:
    with Robots() as robots:
        return robots.stop(names)


class ServerProcess:
    """`trexcmd serve` in a separate process."""

    def __init__(self, simulator: SimulatedDevice, *options: str) -> None:
        self.simulator = simulator
        self.address = Address("127.0.0.1", "arm", port=_free_port())
        command = [sys.executable, "-m", "trex_gui.cli", "serve", "--port", simulator.url]
        command += ["--name", "arm", "--listen", f"127.0.0.1:{self.address.port}", *options]
        command += ["--timeout", str(PATIENT.extra)]  # for late replies
        self.process = subprocess.Popen(command, stderr=subprocess.PIPE, text=True)

    def url(self, user: str = "") -> str:
        return Address("127.0.0.1", "arm", user, self.address.port).url

    def wait_for_board(self, user: str = "") -> None:
        def responds() -> bool:
            rows = find_robots([Address.of(self.url(user)).url])
            return bool(rows) and rows[0]["responds"]

        assert comes_true(responds)

    def end(self) -> int:
        """Terminate the process. Return its exit code."""
        self.process.send_signal(signal.SIGTERM)
        return self.process.wait(_TIMEOUT)


def _free_port() -> int:
    with socket.socket() as listener:
        listener.bind(("127.0.0.1", 0))
        port: int = listener.getsockname()[1]
        return port


@contextmanager
def served(simulator: SimulatedDevice, *options: str) -> Iterator[ServerProcess]:
    server = ServerProcess(simulator, *options)
    with server.process as process:
        assert process.stderr is not None
        try:
            assert "Serving" in process.stderr.readline()
            yield server
        finally:
            process.kill()


class Cable:
    """Network cable to a port of this computer. It works again after it was cut."""

    def __init__(self, port: int) -> None:
        self._target = "127.0.0.1", port
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.port: int = self._listener.getsockname()[1]
        self._sockets: list[socket.socket] = []
        threading.Thread(target=self._accept).start()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self._listener.shutdown(socket.SHUT_RDWR)
        self._listener.close()
        self.cut()

    def cut(self) -> None:
        sockets, self._sockets = self._sockets, []
        for each in sockets:
            with suppress(OSError):  # the other end has closed it
                each.shutdown(socket.SHUT_RDWR)

    def _accept(self) -> None:
        with suppress(OSError):
            while True:
                ends = self._listener.accept()[0], socket.create_connection(self._target)
                self._sockets += ends
                for source, target in (ends, ends[::-1]):
                    threading.Thread(target=self._forward, args=(source, target)).start()

    def _forward(self, source: socket.socket, target: socket.socket) -> None:
        with suppress(OSError), source, target:
            while data := source.recv(4096):
                target.sendall(data)


@pytest.fixture
def server(start_simulator: StartSimulator) -> Iterator[ServerProcess]:
    with served(start_simulator()) as server:
        server.wait_for_board()
        yield server


@pytest.fixture
def secrets(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """File of users with their secrets."""
    file, roles = tmp_path / "users", {"alice": "drive", "bob": "own", "wanda": "watch"}
    for user, role in roles.items():
        secret = add_user(file, user, role)
        client_file = Path(os.environ["TREX_STUDIO_DATA"]) / "secrets"
        client_file.parent.mkdir(exist_ok=True, parents=True)
        client_file.touch(mode=0o600)
        with client_file.open("a", encoding="utf-8") as lines:
            lines.write(f"{user}@127.0.0.1 {secret}\n")
    return file


@pytest.fixture
def user_server(start_simulator: StartSimulator, secrets: Path) -> Iterator[ServerProcess]:
    """Server with the users alice, who drives, bob, who owns it, and wanda, who watches."""
    with served(start_simulator(), "--users", str(secrets)) as server:
        server.wait_for_board("alice")
        yield server


def test_library_reads_writes_and_drives_served_board(server: ServerProcess) -> None:
    with Trex(server.url()) as trex:
        assert trex.status().product == "TReX"
        trex.set_parameters(serial_timeout="0.5 s")
        assert server.simulator.show()["parameters"]["serial_timeout"] == 5
        trex.drive(40)
        trex.wait(0.3)
        assert motor(server.simulator) == ("forward", 40)
        (row,) = find_robots([server.url()])
        assert row["driver"] == "local"
        trex.stop()
        assert motor(server.simulator) == STOPPED
        assert next(iter(trex.measurements(1.0)))["motor_1_current_A"] == 0.0
    assert comes_true(lambda: find_robots([server.url()])[0]["driver"] is None)


def test_second_driver_is_rejected_and_may_stop(server: ServerProcess) -> None:
    with Trex(server.url()) as first, Trex(server.url()) as second:
        first.drive(40)
        first.wait(0.2)
        second.drive(-40)
        with pytest.raises(MotorsStoppedError, match="Another user drives"):
            second.wait(1)
        with pytest.raises(BadRequest, match="Another user drives"):
            second.set_parameters(serial_timeout=5)
        assert second.status().serial_controls
        first.wait(0.1)
        assert motor(server.simulator) == ("forward", 40)
        second.stop()
        assert motor(server.simulator) == STOPPED


def test_earlier_clients_do_not_count_towards_the_limit(server: ServerProcess) -> None:
    for number in range(_CLIENT_LIMIT + 1):
        with open_client(server.address) as session:
            name = key("arm", "client", LOCAL_USER, str(number))
            _token = session.liveliness().declare_token(name)
    with Trex(server.url()) as trex:
        assert trex.status().product == "TReX"


def test_client_drives_on_after_a_cut_connection(server: ServerProcess) -> None:
    with Cable(server.address.port) as cable:
        address = replace(server.address, port=cable.port)
        with Trex(address.url) as trex:

            def drives() -> bool:
                try:
                    trex.drive(40)
                    trex.wait(0.3)
                    is_driving = motor(server.simulator) == ("forward", 40)
                    trex.stop()
                except (NoReply, MotorsStoppedError):
                    return False
                return is_driving

            assert drives()
            cable.cut()
            assert comes_true(drives)


_DRIVES = """
import sys
from trex_gui import Trex
with Trex(sys.argv[1]) as trex:
    trex.drive(50)
    trex.wait(0.5)
    print("ready", flush=True)
    trex.wait(60)
"""


@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGSTOP], ids=["killed", "suspended"])
def test_motors_stop_when_their_driver_ends(server: ServerProcess, end: signal.Signals) -> None:
    with running_script(_DRIVES, server.url()) as driver:
        assert motor(server.simulator) == ("forward", 50)
        driver.send_signal(end)
        assert comes_true(lambda: motor(server.simulator) == STOPPED)
        assert comes_true(lambda: find_robots([server.url()])[0]["driver"] is None)


def test_motors_stop_when_the_server_is_killed(server: ServerProcess) -> None:
    def drive() -> None:
        with Trex(server.url()) as trex:
            trex.drive(50)
            trex.wait(0.5)
            server.process.kill()
            assert comes_true(lambda: motor(server.simulator) == STOPPED), "by the guardian"
            trex.wait(10)

    with pytest.raises((NoReply, MotorsStoppedError)):
        drive()


def test_end_of_the_server_stops_the_motors(server: ServerProcess) -> None:
    def drive() -> None:
        with Trex(server.url()) as trex:
            trex.drive(50)
            trex.wait(0.3)
            assert server.end() == 0
            assert motor(server.simulator) == STOPPED
            trex.wait(1)

    with pytest.raises(StudioError, match="closed"):
        drive()


def test_script_subscribes_without_the_library(server: ServerProcess) -> None:
    script = str(resource("examples") / "subscribe.py")
    command = [sys.executable, "-S", script, f"127.0.0.1:{server.address.port}", "arm", "1"]
    environment = {"PYTHONPATH": str(Path(zenoh.__file__).parents[1])}
    output = subprocess.check_output(command, env=environment, text=True)
    rows = [json.loads(line) for line in output.splitlines()]
    assert len(rows) > 10
    assert rows[0]["channel_1_us"] == 1500.0


def test_returned_board_is_served_again(server: ServerProcess) -> None:
    server.simulator.do("power off")
    assert comes_true(lambda: not find_robots([server.url()])[0]["responds"])
    with pytest.raises(NoReply), Trex(server.url()) as trex:
        trex.status()
    server.simulator.do("power on")
    server.wait_for_board()
    with Trex(server.url()) as trex:
        assert trex.status().product == "TReX"


def test_lost_line_is_opened_again_at_the_newest_settings(start_simulator: StartSimulator) -> None:
    simulator = start_simulator()
    with served(simulator, "--protocol", "expanded", "--device", "7") as server:
        server.wait_for_board()
        with Trex(server.url()) as trex:
            trex.set_parameters(device_number=9)
        simulator.do("line unplug")
        assert server.process.stderr is not None
        assert any("is gone" in line for line in server.process.stderr)
        simulator.do("line plug")
        server.wait_for_board()
        with Trex(server.url()) as trex:
            assert trex.parameter("device_number") == 9


def test_stop_by_name_is_confirmed_for_each_robot(
    server: ServerProcess, monkeypatch: pytest.MonkeyPatch
) -> None:
    with Trex(server.url()) as trex:
        trex.drive(40)
        trex.wait(0.3)
        assert stop_robots([server.url()]) == {server.url(): ""}
        assert motor(server.simulator) == STOPPED
        trex.wait(0.5)
        assert motor(server.simulator) == STOPPED, "heartbeats of the driver start no motor"
    monkeypatch.setattr(
        "trex_gui.devices.trex.serve.robots._addresses", lambda _hosts: [server.address]
    )
    errors = stop_robots(["arm", "leg"])
    assert errors[server.url()] == ""
    assert errors["leg"], "this robot is not found"
    server.simulator.do("power off")
    (error,) = stop_robots([server.url()]).values()
    assert error


def test_served_line_drives_two_boards_together(start_simulator: StartSimulator) -> None:
    simulator = start_simulator("--device", "7", "--device", "9")
    with served(simulator, "--boards", "7,9") as server:
        server.wait_for_board()
        with TrexLine(server.url(), boards=(7, 9)) as line:
            line.drive(40)
            line.wait(0.3)
            assert target_speeds(simulator) == [40, 40]
            line[9].drive(20)
            line.wait(0.3)
            assert target_speeds(simulator) == [40, 20]
            assert line[9].status().product == "TReX"
            line.stop()
            for name in ("@7", "@9"):
                assert simulator.show(name)["motors"][0]["target_direction"] == "brake"
            line[9].set_parameters(serial_timeout=5)
            assert simulator.show("@9")["parameters"]["serial_timeout"] == 5


# --- Users --------------------------------------------------------------------------------


def test_lease_is_handed_over_taken_and_released(user_server: ServerProcess) -> None:
    with Trex(user_server.url("alice")) as alice, Trex(user_server.url("bob")) as owner:
        alice.request_lease()
        with pytest.raises(BadRequest, match="Another user drives"):
            owner.request_lease()
        assert owner.driver == "alice"
        alice.release_lease("bob")  # who has requested the lease
        owner.request_lease()
        with pytest.raises(BadRequest, match="owner"):
            alice.request_lease(take=True)
        owner.release_lease()
        alice.request_lease(1.0)
        alice.drive(40)
        alice.wait(0.3)
        words = ["robots", user_server.url("bob").rpartition("/")[0], "--release", "arm"]
        with subprocess.Popen([sys.executable, "-m", "trex_gui.cli", *words]) as command:
            with pytest.raises(MotorsStoppedError, match="handed over"):
                alice.wait(_TIMEOUT)
            assert motor(user_server.simulator) == STOPPED
        assert command.returncode == 0


def test_stranger_and_wrong_secret_are_rejected(
    user_server: ServerProcess, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("TREX_SECRET", "wrong")
    for user in ("", "mallory", "alice"):
        trex = Trex(user_server.url(user))
        with pytest.raises(PortUnavailable, match="No board is served"), trex:
            pytest.fail(f"{user!r} was admitted")


def test_user_cannot_send_requests_as_another_user(user_server: ServerProcess) -> None:
    address, numbers = Address.of(user_server.url("wanda")), count(1)
    with open_client(address) as session:
        for user in ("alice", "*", "**", "wanda"):
            name = key("arm", "from", user, "0123456789abcdef")
            for request in (Hello(VERSION, "x"), AskLease(), Arm(), SetMotor(1, Drive.at(50))):
                session.put(name, encode_request(request, next(numbers), 1e9, 0.0))
        time.sleep(0.5)
    assert find_robots([address.url])[0]["driver"] is None
    assert user_server.simulator.show()["motors"][0]["target_speed"] == 0


def test_report_and_traffic_of_served_board_contain_no_secret(
    user_server: ServerProcess, secrets: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    traffic = secrets.parent / "traffic.txt"
    lines = [line.split() for line in secrets.read_text("utf-8").splitlines()]
    (secret,) = (words[-1] for words in lines if words[:1] == ["alice"])
    monkeypatch.setenv("TREX_SECRET", secret)
    words = ["report", "-", "--port", user_server.url("alice"), "--traffic", str(traffic)]
    command = [sys.executable, "-m", "trex_gui.cli", *words]
    report = subprocess.run(command, check=True, capture_output=True, text=True)
    assert "TReX 1.2" in report.stdout, "the board was read"
    assert "get signature" in traffic.read_text("utf-8")
    assert secret not in report.stdout + report.stderr + traffic.read_text("utf-8")


@pytest.mark.skipif(not shutil.which("openssl"), reason="needs openssl")
def test_encrypted_connection_requires_the_certificate(
    start_simulator: StartSimulator, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    help_text = (resource("help") / "remote.md").read_text("utf-8")
    commands = [line for line in help_text.splitlines() if line.startswith(("openssl", "printf"))]
    assert len(commands) == 4
    script = "\n".join(commands).replace("DNS:robot.local", "IP:127.0.0.1")
    subprocess.run(["sh", "-ec", script], cwd=tmp_path, check=True, capture_output=True)
    files = str(tmp_path / "robot.pem"), str(tmp_path / "robot.key")
    with served(start_simulator(), "--tls", *files) as server:
        with pytest.raises(PortUnavailable), Trex(server.url()):
            pass
        monkeypatch.setenv("TREX_TLS_CA", str(tmp_path / "ca.pem"))
        server.wait_for_board()
        with Trex(server.url()) as trex:
            assert trex.status().product == "TReX"


def test_watcher_stops_robot_by_name(user_server: ServerProcess) -> None:
    with Trex(user_server.url("alice")) as trex:
        trex.drive(40)
        trex.wait(0.3)
        assert motor(user_server.simulator) == ("forward", 40)
        url = user_server.url("wanda")
        assert stop_robots([url]) == {url: ""}
        assert motor(user_server.simulator) == STOPPED


def test_user_cannot_reply_in_place_of_the_server(user_server: ServerProcess) -> None:
    with open_client(Address.of(user_server.url("wanda"))) as session:
        forged = json.dumps({"name": "fake", "board": None, "driver": None, "problems": []})
        name = key("arm", "info")
        queryable = session.declare_queryable(
            name, lambda query: query.reply(name, forged), complete=True
        )
        time.sleep(0.3)
        (row,) = find_robots([user_server.url("alice")])
        assert row["name"] == "arm"
        del queryable
