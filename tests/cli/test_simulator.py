"""Command line, endpoints and control lines of trex-sim."""

import json
import os
import signal
import socket
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
import serial
from click.testing import CliRunner

from tests.devices.trex.simulator.waiting import LONG_TIMEOUT, comes_true
from tests.support.matrix import sampled
from trex_gui.cli.simulator import main
from trex_gui.devices.trex.simulator.memory import Eeprom
from trex_gui.version import __version__

needs_pty = pytest.mark.skipif(sys.platform == "win32", reason="has no pseudo-terminals")


class RunningSimulator:
    """Process that runs trex-sim."""

    def __init__(self, arguments: list[str], stdin: Any = subprocess.PIPE) -> None:
        self.process = subprocess.Popen(
            [sys.executable, "-m", "trex_gui.cli.simulator", *arguments],
            stdin=stdin,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
        )
        word, _, self.url = self.line().partition(" ")
        assert word == "ready", self.errors()

    def line(self) -> str:
        """Return the next printed line. Empty at the end."""
        assert self.process.stdout is not None
        return self.process.stdout.readline().removesuffix("\n")

    def control(self, text: str) -> str:
        assert self.process.stdin is not None
        self.process.stdin.write(f"{text}\n")
        self.process.stdin.flush()
        return self.line()

    def show(self, name: str = "") -> dict[str, Any]:
        state: dict[str, Any] = json.loads(self.control(f"{name} show").removeprefix("ok "))
        return state

    def wait(self) -> int:
        return self.process.wait(LONG_TIMEOUT)

    def errors(self) -> str:
        assert self.process.stderr is not None
        self.wait()
        return self.process.stderr.read()

    def close(self) -> None:
        self.process.kill()
        self.process.wait(LONG_TIMEOUT)
        for pipe in (self.process.stdin, self.process.stdout, self.process.stderr):
            if pipe is not None:
                pipe.close()


Start = Callable[..., RunningSimulator]


@pytest.fixture
def start() -> Iterator[Start]:
    simulators: list[RunningSimulator] = []

    def start_simulator(*arguments: str, stdin: Any = subprocess.PIPE) -> RunningSimulator:
        simulators.append(RunningSimulator(list(arguments), stdin))
        return simulators[-1]

    yield start_simulator
    for simulator in simulators:
        simulator.close()


def request(url: str, packet: str, size: int, **settings: Any) -> bytes:
    with serial.serial_for_url(
        url, timeout=LONG_TIMEOUT, **{"baudrate": 19200, **settings}
    ) as port:
        port.write(bytes.fromhex(packet))
        data: bytes = port.read(size)
        return data


def is_silent(sim: RunningSimulator, packet: str, **settings: Any) -> bool:
    """Send a packet. Return whether no reply arrives."""

    def is_sent() -> bool:
        sent: int = sim.show()["counters"]["line"]["sent"]
        return sent >= before + len(data)

    data = bytes.fromhex(packet)
    before: int = sim.show()["counters"]["line"]["sent"]
    with serial.serial_for_url(sim.url, timeout=0.1, **{"baudrate": 19200, **settings}) as port:
        port.write(data)
        assert comes_true(is_sent)
        reply: bytes = port.read(1)
        return reply == b""


def error_message(*arguments: str) -> str:
    """Start trex-sim with invalid options. Return its message."""
    result = CliRunner().invoke(main, arguments)
    assert (result.exit_code, result.stdout) == (1, "")
    return result.stderr


class TestCommandLine:
    def test_version_and_help_are_printed(self) -> None:
        version = CliRunner().invoke(main, ["--version"])
        assert (version.exit_code, __version__ in version.output) == (0, True)
        help_result = CliRunner().invoke(main, ["--help"])
        assert help_result.exit_code == 0
        for option in ("--model", "--link", "--tcp", "--rfc2217", "--eeprom", "--device", "--demo"):
            assert option in help_result.output

    @pytest.mark.parametrize(
        "arguments",
        [
            ["--model", "qik"],
            ["--mode", "turbo"],
            ["--device", "128"],
            ["--device", "x"],
            ["--device", "7:qik"],
            ["--tcp", "nowhere"],
            ["--tcp", "127.0.0.1:99999"],
            ["--tcp", "127.0.0.1:0", "--rfc2217", "127.0.0.1:0"],
            ["--tcp", "127.0.0.1:0", "--link", "somewhere"],
            ["--device", "7", "--device", "7", "--eeprom", "somewhere"],
            ["--link", ""],
            ["--eeprom", ""],
            ["--warp"],
        ],
    )
    def test_invalid_arguments_exit_with_status_2(self, arguments: list[str]) -> None:
        assert CliRunner().invoke(main, arguments).exit_code == 2

    def test_damaged_eeprom_file_is_reported_with_status_1(self, tmp_path: Path) -> None:
        path = tmp_path / "eeprom.json"
        path.write_text("{", encoding="utf-8")
        message = error_message("--eeprom", str(path))
        assert str(path) in message
        assert len(message.splitlines()) == 1

    @pytest.mark.realtime
    def test_port_in_use_is_reported_with_status_1(self) -> None:
        with socket.create_server(("127.0.0.1", 0)) as server:
            address = f"127.0.0.1:{server.getsockname()[1]}"
            assert address in error_message("--tcp", address)


@needs_pty
@pytest.mark.realtime
class TestPseudoTerminal:
    def test_pty_works_as_a_serial_port_until_it_is_unplugged(
        self, start: Start, tmp_path: Path
    ) -> None:
        link = tmp_path / "trex"
        link.symlink_to("/dev/pts/nothing")
        sim = start("--link", str(link))
        assert sim.url == str(link)
        assert link.readlink() != Path("/dev/pts/nothing")
        host = os.open(sim.url, os.O_RDWR | os.O_NOCTTY)  # without settings of the serial line
        os.write(host, b"\x82")
        assert os.read(host, 1) == b"r"
        os.close(host)
        assert request(sim.url, "80 07 01", 7) == b"TReX1.2"
        with serial.Serial(sim.url, 19200, timeout=LONG_TIMEOUT) as port:
            start_time = time.monotonic()
            for _ in range(20):
                port.write(bytes.fromhex("86 1F"))
                assert len(port.read(10)) == 10
            duration = time.monotonic() - start_time
            assert duration >= 20 * 12 * 10 / 19200 * 0.999
            assert sim.control("line unplug") == "ok unplugged"
            with pytest.raises(serial.SerialException):
                port.write(b"\x81")
        assert not link.is_symlink()
        assert sim.control("line plug") == f"ok plugged {link}"
        assert request(sim.url, "81", 7) == b"TReX1.2"
        assert sim.control("quit") == "ok bye"
        assert (sim.wait(), sim.errors()) == (0, "")
        assert not link.is_symlink()

    @pytest.mark.parametrize(
        ("baud", "errors"), sampled([(76800, b"\x10"), (1200, b"\0"), (115200, b"\x10")], every=3)
    )
    def test_pty_follows_host_baud_rate(
        self, start: Start, tmp_path: Path, baud: int, errors: bytes
    ) -> None:
        path = tmp_path / "eeprom.json"
        Eeprom.open(path).write("uart_settings", {1200: 0, 76800: 9, 115200: 10}[baud])
        sim = start("--eeprom", str(path))
        assert request(sim.url, "82", 1, baudrate=baud) == b"r"
        assert is_silent(sim, "82", baudrate=19200)
        # At 1200 baud, the board is too slow to detect errors.
        assert request(sim.url, "85", 1, baudrate=baud) == errors

    def test_existing_file_is_not_replaced_by_the_link(self, tmp_path: Path) -> None:
        link = tmp_path / "trex"
        link.write_text("old content", encoding="utf-8")
        assert str(link) in error_message("--link", str(link))
        assert list(tmp_path.iterdir()) == [link]
        assert link.read_text(encoding="utf-8") == "old content"


@pytest.mark.realtime
class TestTcp:
    def test_tcp_server_accepts_successive_hosts_until_it_is_unplugged(self, start: Start) -> None:
        sim = start("--tcp", "127.0.0.1:0", "--demo", "--unpaced")
        host, _, port = sim.url.removeprefix("socket://").partition(":")
        address = (host, int(port))
        assert host == "127.0.0.1"
        assert address[1]
        for _ in range(2):
            assert request(sim.url, "81", 7) == b"TReX1.2"
        replies: set[bytes] = set()

        def has_five_replies() -> bool:
            replies.add(request(sim.url, "86 1F", 10))
            return len(replies) == 5

        assert comes_true(has_five_replies), "the sticks of the demo move"
        with socket.create_connection(address, LONG_TIMEOUT) as connection:
            connection.sendall(b"\x82")
            assert connection.recv(1) == b"r"
            sim.control("line unplug")
            assert connection.recv(1) == b""
        with pytest.raises(ConnectionRefusedError):
            socket.create_connection(address, LONG_TIMEOUT)
        assert sim.control("line plug") == f"ok plugged {sim.url}"
        assert request(sim.url, "82", 1) == b"r"


@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")  # pyserial 3.5
@pytest.mark.realtime
class TestRfc2217:
    def test_rfc2217_follows_host_parity(self, start: Start, tmp_path: Path) -> None:
        path = tmp_path / "eeprom.json"
        Eeprom.open(path).write("uart_settings", 0x45)
        sim = start("--rfc2217", "127.0.0.1:0", "--eeprom", str(path))
        assert sim.url.startswith("rfc2217://127.0.0.1:")
        assert is_silent(sim, "82", parity="N")
        assert request(sim.url, "85", 1, parity="E") == b"\x04"
        assert is_silent(sim, "82", parity="E", baudrate=38400)

    def test_rfc2217_passes_telnet_bytes_and_survives_malformed_client(self, start: Start) -> None:
        sim = start("--rfc2217", "127.0.0.1:0")
        sim.control("channel 1 invalid")
        assert request(sim.url, "FF FF 86 01", 2) == b"\xff\xff"
        address = sim.url.removeprefix("rfc2217://").split(":")
        with socket.create_connection((address[0], int(address[1])), LONG_TIMEOUT) as host:
            host.sendall(b"\xff\xf0")
            while host.recv(1024):
                pass
        assert request(sim.url, "82", 1) == b"r"


@pytest.mark.realtime
class TestInputAndEnd:
    @needs_pty
    @pytest.mark.parametrize("end", [*sampled(["SIGTERM", "SIGINT", "SIGHUP"], every=3), "input"])
    def test_signal_or_closed_input_ends_simulator_cleanly(
        self, start: Start, tmp_path: Path, end: str
    ) -> None:
        link = tmp_path / "trex"
        sim = start("--link", str(link))
        if end == "input":
            assert sim.process.stdin is not None
            sim.process.stdin.close()
        else:
            sim.process.send_signal(getattr(signal, end))
        assert (sim.wait(), sim.errors()) == (0, "")
        assert not link.is_symlink()

    def test_simulator_runs_without_standard_input(self, start: Start) -> None:
        sim = start("--tcp", "127.0.0.1:0", stdin=subprocess.DEVNULL)
        assert request(sim.url, "82", 1) == b"r"
        assert sim.process.poll() is None
        sim.process.terminate()
        assert (sim.wait(), sim.errors()) == (0, "")

    def test_control_lines_are_read_from_file(self, start: Start, tmp_path: Path) -> None:
        script = tmp_path / "script"
        script.write_text("channel 1 4000\nbogus\nchannel 2 4001", encoding="utf-8")
        with script.open("rb") as file:
            sim = start("--tcp", "127.0.0.1:0", stdin=file)
        replies = [sim.line() for _ in range(3)]
        assert replies[0] == "ok channel 1 gets 1600us"
        assert replies[1].startswith("error 'bogus' is not a command")
        assert replies[2] == "ok channel 2 gets 1600.4us"
        assert comes_true(lambda: request(sim.url, "86 03", 4) == bytes.fromhex("A0 0F A1 0F"))
        assert sim.process.poll() is None

    @needs_pty
    def test_simulator_continues_after_end_of_terminal_input(self, start: Start) -> None:
        master, slave = os.openpty()
        try:
            sim = start("--tcp", "127.0.0.1:0", stdin=slave)
            os.write(master, b"channel 1 4000\n\x04")  # Ctrl-D
            assert sim.line() == "ok channel 1 gets 1600us"
            assert comes_true(lambda: request(sim.url, "86 01", 2) == bytes.fromhex("A0 0F"))
            assert sim.process.poll() is None
        finally:
            os.close(slave)
            os.close(master)


@pytest.mark.realtime
class TestEeprom:
    def test_eeprom_write_survives_restart_and_overrides_option(
        self, start: Start, tmp_path: Path
    ) -> None:
        path = tmp_path / "eeprom.json"
        Eeprom.open(path).write("device_number", 12)
        first = start("--tcp", "127.0.0.1:0", "--eeprom", str(path))
        assert request(first.url, "AF 07 0F 55 2A", 1) == b"\x00"
        first.close()
        second = start("--tcp", "127.0.0.1:0", "--eeprom", str(path), "--device", "9")
        assert request(second.url, "9F 07", 1) == b"\x0f"
        assert second.show()["parameters"]["device_number"] == 12
        second.control("quit")
        assert "device 12" in second.errors()

    def test_each_board_has_its_own_eeprom_file(self, start: Start, tmp_path: Path) -> None:
        path = tmp_path / "eeprom.json"
        sim = start("--tcp", "127.0.0.1:0", "--eeprom", str(path), "--device", "7", "--device", "9")
        assert sim.show("@9")["parameters"]["device_number"] == 9
        assert {file.name for file in tmp_path.iterdir()} == {"eeprom-7.json", "eeprom-9.json"}
