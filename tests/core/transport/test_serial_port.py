"""Real ports: a pseudo-terminal, a TCP port, and their failures."""

import errno
import itertools
import os
import pickle
import select
import signal
import socket
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
import serial

from tests.core.transport.conftest import Open
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.core.errors import NoReply, PortShared, PortUnavailable
from trex_gui.core.guardian.guardian import GuardianProcess
from trex_gui.core.timing import Timeouts
from trex_gui.core.transport.serial_port import SerialTransport, open_error
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.protocol.commands import GetMode, GetSignature, SetParameter
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.errors import ResultCode
from trex_gui.devices.trex.protocol.flags import Mode
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates

if sys.platform == "win32":
    pytest.skip("needs pseudo-terminals", allow_module_level=True)

import termios

pytestmark = pytest.mark.realtime

Start = StartSimulator

LINE = LineSettings()

LONG_TIMEOUT = 15.0
"""Seconds within which every expected event happens, even on a busy computer."""


def slow_client(transport: SerialTransport, url: str) -> TrexClient:
    """Return a client that waits for a suspended simulator."""
    return TrexClient(transport, ConnectionSettings(url, timeouts=Timeouts(extra=LONG_TIMEOUT)))


def open_failure(url: str, line: LineSettings = LINE) -> str:
    """Return the error of a port that does not open."""
    with pytest.raises(PortUnavailable) as caught:
        SerialTransport(ConnectionSettings(url, line))
    return str(caught.value)


def test_bytes_read_by_another_program_raise_port_shared(
    terminal: tuple[int, str], opened: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    master, path = terminal
    transport = opened(path)
    other_reader = os.open(path, os.O_RDONLY | os.O_NOCTTY)
    wait = select.select

    def read_first(*arguments: Any) -> object:
        ready = wait(*arguments)
        if ready[0]:
            os.read(other_reader, 100)
        return ready

    with monkeypatch.context() as patch:
        patch.setattr("serial.serialposix.select.select", read_first)
        os.write(master, b"reply")
        with pytest.raises(PortShared, match=f"Another program is also reading from {path}"):
            transport.read(5, LONG_TIMEOUT)
    os.close(other_reader)


# --- Data -------------------------------------------------------------------------------


def test_board_replies_over_pseudo_terminal(quick_simulator: SimulatedDevice, opened: Open) -> None:
    transport = opened(quick_simulator.url)
    # A client with a long timeout would wait too long for an echo.
    assert TrexClient(transport, ConnectionSettings(quick_simulator.url)).detect_echo() is False
    client = slow_client(transport, quick_simulator.url)
    assert str(client.request(GetSignature())) == "TReX 1.2"
    assert client.request(SetParameter(7, 9)) is ResultCode.OK
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 9


def test_board_replies_over_tcp(
    start_simulator: Start, opened: Open, terminal: tuple[int, str]
) -> None:
    url = start_simulator("--tcp", "127.0.0.1:0", "--echo").url
    assert url.startswith("socket://")
    transport = opened(url)
    assert transport.latency > opened(terminal[1]).latency
    client = slow_client(transport, url)
    assert client.detect_echo() is True
    assert client.request(GetMode()) is Mode.SERIAL_RC


@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")  # a warning of pyserial
def test_rfc2217_port_applies_parity(start_simulator: Start, opened: Open) -> None:
    url = start_simulator("--rfc2217", "127.0.0.1:0").url
    line = LineSettings(19200, Detection.EVEN)
    client = TrexClient(opened(url, line), ConnectionSettings(url, line))
    with pytest.raises(NoReply):
        client.request(GetMode())  # the board has no parity


@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")
@pytest.mark.parametrize("moment", [pytest.param("at once", marks=pytest.mark.slow), "later"])
def test_garbage_from_rfc2217_server_is_a_port_failure(
    start_simulator: Start, opened: Open, moment: str
) -> None:
    """A suboption that ends without a start raises an error in pyserial's thread."""
    target = start_simulator("--rfc2217", "127.0.0.1:0").url.rpartition(":")[2]
    with socket.create_server(("127.0.0.1", 0)) as server:
        url = f"rfc2217://127.0.0.1:{server.getsockname()[1]}"
        garbage = threading.Event()
        arguments = (server, int(target), garbage)
        relay = threading.Thread(target=relay_one, args=arguments, daemon=True)
        relay.start()
        if moment == "at once":
            garbage.set()
            message = open_failure(url)
        else:
            transport = opened(url)
            garbage.set()
            with pytest.raises(PortUnavailable) as error:
                transport.read(1, LONG_TIMEOUT)
            message = str(error.value)
            transport.close()
        relay.join()
    assert "cannot be reached: the server does not use RFC 2217" in message


def relay_one(server: socket.socket, target: int, garbage: threading.Event) -> None:
    """Relay a connection to a local port, or send garbage."""
    client, _ = server.accept()
    with client, socket.create_connection(("127.0.0.1", target)) as device:
        ends = {client: device, device: client}
        while True:
            if garbage.is_set():
                client.sendall(b"\xff\xf0")
                client.settimeout(LONG_TIMEOUT)
                while client.recv(100):
                    pass
                return
            for end in select.select(list(ends), [], [], 0.02)[0]:
                ends[end].sendall(end.recv(4096))


def test_every_baud_rate_of_boards_can_be_set(terminal: tuple[int, str], opened: Open) -> None:
    for baud in baud_rates():
        opened(terminal[1], LineSettings(baud)).close()


def test_port_gets_baud_rate_and_stop_bits_of_line(terminal: tuple[int, str], opened: Open) -> None:
    master, path = terminal
    opened(path, LineSettings(57600, stop_bits=2))
    attributes = termios.tcgetattr(master)
    assert attributes[5] == termios.B57600
    assert attributes[2] & termios.CSTOPB


def test_low_latency_is_requested_from_adapter(
    terminal: tuple[int, str], opened: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    requested: list[bool] = []

    def set_mode(_port: serial.Serial, low_latency: bool) -> None:
        requested.append(low_latency)
        raise OSError(errno.ENOTTY, "a terminal has no latency")

    monkeypatch.setattr(serial.Serial, "set_low_latency_mode", set_mode)
    opened(terminal[1])
    assert requested == [True]


def test_all_byte_values_pass_unchanged(terminal: tuple[int, str], opened: Open) -> None:
    master, path = terminal
    transport = opened(path)
    everything = bytes(range(256))
    transport.write(everything)
    received = b""
    while len(received) < len(everything):  # a terminal may deliver the bytes in pieces
        assert select.select([master], [], [], LONG_TIMEOUT)[0]
        received += os.read(master, 512)
    assert received == everything
    os.write(master, everything)
    start = time.monotonic()
    assert transport.read(256, 40.0) == everything
    assert time.monotonic() - start < 30.0, "the read ends when all bytes have arrived"


def test_incomplete_read_ends_at_timeout(terminal: tuple[int, str], opened: Open) -> None:
    master, path = terminal
    transport = opened(path)
    for _ in range(20):  # a busy computer may take longer
        os.write(master, b"xab")
        assert transport.read(1, LONG_TIMEOUT) == b"x"  # the other bytes have then also arrived
        start = transport.clock()
        assert transport.read(3, 0.1) == b"ab"
        took = transport.clock() - start
        assert took >= 0.1
        if took < 0.3:
            break
    assert took < 0.3


def test_discard_returns_and_removes_bytes(terminal: tuple[int, str], opened: Open) -> None:
    master, path = terminal
    transport = opened(path)
    os.write(master, b"xstale")
    assert transport.read(1, LONG_TIMEOUT) == b"x"  # the other bytes have then also arrived
    assert transport.discard() == b"stale"
    assert transport.discard() == b""
    os.write(master, b"new")
    assert transport.read(3, LONG_TIMEOUT) == b"new"


def test_clock_jump_while_reading_loses_no_bytes(terminal: tuple[int, str], opened: Open) -> None:
    master, path = terminal
    seconds = itertools.count()
    transport = opened(path, clock=lambda: next(seconds))
    os.write(master, b"xlate")
    assert transport.read(1, 1_000_000) == b"x"
    assert transport.discard() == b"late"


# --- Ports that do not open -------------------------------------------------------------


def test_missing_port_is_reported_with_available_ports() -> None:
    message = open_failure("/dev/ttyNothing9")
    assert message.startswith("There is no port /dev/ttyNothing9.")
    assert "Ports of this computer:" in message


def test_port_is_opened_exclusively(terminal: tuple[int, str], opened: Open) -> None:
    opened(terminal[1])
    message = open_failure(terminal[1])
    assert "is in use" in message
    assert "Close the port there, then connect again." in message


@contextmanager
def other_program(opening: str) -> Iterator[int]:
    """Run a program that evaluates an expression and waits. Return its process ID."""
    code = f"import serial, sys; port = {opening}; print('open', flush=True); sys.stdin.read()"
    command, pipe = [sys.executable, "-c", code], subprocess.PIPE
    with subprocess.Popen(command, stdin=pipe, stdout=pipe) as program:
        assert program.stdout is not None
        assert program.stdout.readline() == b"open\n"
        yield program.pid
        program.communicate(b"", timeout=30)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux shows who holds a port")
def test_owner_of_port_lock_is_named_before_other_users(
    terminal: tuple[int, str], opened: Open
) -> None:
    with other_program(f"open({terminal[1]!r})"):
        opened(terminal[1])
        assert "in use by another connection of this program" in open_failure(terminal[1])


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux shows who holds a port")
def test_process_that_holds_port_is_named(terminal: tuple[int, str]) -> None:
    with other_program(f"serial.Serial({terminal[1]!r}, exclusive=True)") as number:
        assert f"(process {number})" in open_failure(terminal[1])


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux shows who holds a port")
def test_open_waits_for_closing_connection_of_own_program(
    terminal: tuple[int, str], opened: Open
) -> None:
    first = opened(terminal[1])
    closing = threading.Timer(0.2, first.close)
    closing.start()
    try:
        opened(terminal[1], clock=lambda: 0.0)  # without a timeout, for a busy computer
    finally:
        closing.join()


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux shows who holds a port")
def test_guardian_that_is_stopping_motors_is_named(
    quick_simulator: SimulatedDevice, opened: Open
) -> None:
    url = quick_simulator.url
    line = opened(url)
    guardian = line.start_guardian(3600.0)
    assert isinstance(guardian, GuardianProcess)
    assert guardian._process is not None
    guardian.wait_until_ready(LONG_TIMEOUT)
    guardian._process.send_signal(signal.SIGSTOP)  # so that it never completes its stop
    try:
        assert "another connection of this program" in open_failure(url), (
            "the guardian only watches"
        )
        line.close()
        assert "The guardian process is still stopping the motors" in open_failure(url)
    finally:
        guardian.end()
    opened(url)


def test_closed_port_can_be_closed_again_and_reopened_but_not_used(
    terminal: tuple[int, str], opened: Open
) -> None:
    transport = opened(terminal[1])
    transport.close()
    for act in (lambda: transport.read(1, 0.1), lambda: transport.write(b"x"), transport.discard):
        with pytest.raises(PortUnavailable):
            act()
    opened(terminal[1])
    transport.close()


def test_regular_file_is_rejected_as_port(tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.write_text("no port")
    assert str(path) in open_failure(str(path))
    assert path.read_text() == "no port"


def test_network_port_without_server_is_reported_as_unreachable() -> None:
    assert "port socket://127.0.0.1:9 cannot be reached" in open_failure("socket://127.0.0.1:9")


@pytest.mark.parametrize("url", ["", "nonsense://x", "socket://nowhere", "rfc2217://", "a\0b"])
def test_invalid_url_is_rejected_with_message(url: str) -> None:
    assert open_failure(url)


# --- Messages ------------------------------------------------------------------------


def test_permission_error_names_group_of_port(terminal: tuple[int, str]) -> None:
    import grp

    denied = serial.SerialException(errno.EACCES, "could not open: Permission denied")
    message = str(open_error(terminal[1], LINE, denied))
    group = grp.getgrgid(Path(terminal[1]).stat().st_gid).gr_name
    assert message.startswith(f"Permission denied for {terminal[1]}.")
    if group != "root":
        assert f"sudo usermod -aG {group} $USER" in message
    assert f"sudo chmod a+rw {terminal[1]}" in message


def test_permission_error_of_missing_port_names_dialout() -> None:
    denied = open_error("/dev/ttyGone9", LINE, OSError(errno.EACCES, "denied"))
    assert denied.command == "sudo usermod -aG dialout $USER"
    assert denied.command in str(denied)
    assert pickle.loads(pickle.dumps(denied)).command == denied.command


def wrapped(number: int) -> serial.SerialException:
    """Return a system error as the cause of pyserial's error."""
    error = serial.SerialException("could not open port")
    error.__cause__ = OSError(number, os.strerror(number))
    return error


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (serial.SerialException(errno.EBUSY, "could not open"), "/dev/ttyX is in use by"),
        (serial.SerialException(errno.EAGAIN, "could not open"), "/dev/ttyX is in use by"),
        (
            ValueError("Invalid baud rate"),
            "cannot be set to 19200 baud, no error detection, 1 stop bit",
        ),
        (
            serial.SerialException(errno.EIO, "could not open: [Errno 5] Input/output error"),
            "The port /dev/ttyX cannot be opened: input/output error.",
        ),
        (wrapped(errno.EACCES), "Permission denied for /dev/ttyX."),
        (AttributeError(), "The port /dev/ttyX cannot be opened: AttributeError."),
        (
            serial.SerialException("Remote does not accept parameter change (RFC2217): [...]"),
            "/dev/ttyX cannot be opened: the server rejects the line settings.",
        ),
    ],
)
def test_message_explains_why_port_does_not_open(error: Exception, words: str) -> None:
    assert words in str(open_error("/dev/ttyX", LINE, error))


# --- Lines that are lost ----------------------------------------------------------------


def test_unplugged_cable_is_detected_at_once(
    start_simulator: Start, opened: Open, tmp_path: Path
) -> None:
    simulator = start_simulator("--unpaced", "--link", str(tmp_path / "port"))
    actions: tuple[Callable[[SerialTransport], object], ...] = (
        lambda transport: transport.read(1, 40.0),
        SerialTransport.discard,
        lambda transport: transport.write(b"\x82"),
    )
    for act in actions:
        transport = opened(simulator.url)
        simulator.do("line unplug")
        start = time.monotonic()
        gone = rf"{simulator.url} is gone\. Plug the adapter in, then connect again\."
        with pytest.raises(PortUnavailable, match=gone):
            act(transport)
        assert time.monotonic() - start < 30.0
        simulator.do("line plug")


def test_lost_network_connection_is_detected(start_simulator: Start, opened: Open) -> None:
    simulator = start_simulator("--tcp", "127.0.0.1:0")
    client = slow_client(opened(simulator.url), simulator.url)
    client.request(GetMode())
    simulator.end()
    with pytest.raises(PortUnavailable, match="is gone"):
        client.request(GetMode())
