"""Real ports: a pseudo-terminal, a TCP port, and every way in which they fail."""

import errno
import os
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
import serial

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.link.client import Client
from trex_gui.link.settings import LinkSettings
from trex_gui.link.timeouts import Timeouts
from trex_gui.link.transport import SerialTransport, why_not_open
from trex_gui.protocol.commands import GetMode, GetSignature, SetParameter
from trex_gui.protocol.errors import NoReply, PortUnavailable, ResultCode
from trex_gui.protocol.flags import Mode
from trex_gui.protocol.line_settings import Detection, LineSettings, baud_rates

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)

import termios

pytestmark = pytest.mark.realtime

Start = StartSimulator

LINE = LineSettings()

PATIENCE = 15.0
"""Seconds after which what should have happened will not, however loaded the machine."""


def patient(transport: SerialTransport, url: str) -> Client:
    """Return a client that waits for a simulator which stands still."""
    return Client(transport, LinkSettings(url, timeouts=Timeouts(extra=PATIENCE)))


@pytest.fixture
def terminal() -> Iterator[tuple[int, str]]:
    """A pseudo-terminal with nobody behind it: its master end, and the path of the other."""
    master, slave = os.openpty()
    yield master, os.ttyname(slave)
    for end in (master, slave):
        os.close(end)


@pytest.fixture
def opened() -> Iterator[Callable[[str], SerialTransport]]:
    """Open ports that are closed with the test."""
    transports: list[SerialTransport] = []

    def open_port(url: str, line: LineSettings = LINE) -> SerialTransport:
        transports.append(SerialTransport(LinkSettings(url, line)))
        return transports[-1]

    yield open_port
    for transport in transports:
        transport.close()


Open = Callable[..., SerialTransport]


def refusal(url: str, line: LineSettings = LINE) -> str:
    """Return why a port does not open."""
    with pytest.raises(PortUnavailable) as caught:
        SerialTransport(LinkSettings(url, line))
    return str(caught.value)


# --- Talking ----------------------------------------------------------------------------


def test_a_board_answers_through_a_terminal(quick_simulator: SimulatedDevice, opened: Open) -> None:
    transport = opened(quick_simulator.url)
    # No echo comes, so a patient one would wait for it in vain.
    assert Client(transport, LinkSettings(quick_simulator.url)).detect_echo() is False
    client = patient(transport, quick_simulator.url)
    assert str(client.request(GetSignature())) == "TReX 1.2"
    assert client.request(SetParameter(7, 9)) is ResultCode.OK
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 9


def test_a_board_answers_through_a_network(start_simulator: Start, opened: Open) -> None:
    url = start_simulator("--tcp", "127.0.0.1:0", "--echo").url
    assert url.startswith("socket://")
    client = patient(opened(url), url)
    assert client.detect_echo() is True
    assert client.request(GetMode()) is Mode.SERIAL_RC


@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")  # pyserial's, not ours
def test_a_remote_serial_port_carries_parity(start_simulator: Start, opened: Open) -> None:
    url = start_simulator("--rfc2217", "127.0.0.1:0").url
    line = LineSettings(19200, Detection.EVEN)
    client = Client(opened(url, line), LinkSettings(url, line))
    with pytest.raises(NoReply):
        client.request(GetMode())  # the board has no parity


def test_a_network_is_allowed_to_be_later_than_a_local_port(
    start_simulator: Start, opened: Open, terminal: tuple[int, str]
) -> None:
    remote = opened(start_simulator("--tcp", "127.0.0.1:0").url)
    assert remote.latency > opened(terminal[1]).latency


@pytest.mark.parametrize("baud", baud_rates())
def test_every_baud_rate_of_a_board_can_be_set(
    baud: int, terminal: tuple[int, str], opened: Open
) -> None:
    opened(terminal[1], LineSettings(baud))


def test_the_port_is_set_as_the_line_is(terminal: tuple[int, str], opened: Open) -> None:
    master, path = terminal
    opened(path, LineSettings(57600, stop_bits=2))
    attributes = termios.tcgetattr(master)
    assert attributes[5] == termios.B57600
    assert attributes[2] & termios.CSTOPB


def test_adapter_is_asked_not_to_hold_bytes_back(
    terminal: tuple[int, str], opened: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[bool] = []

    def set_mode(_port: serial.Serial, low_latency: bool) -> None:
        asked.append(low_latency)
        raise OSError(errno.ENOTTY, "a terminal has no latency")

    monkeypatch.setattr(serial.Serial, "set_low_latency_mode", set_mode)
    opened(terminal[1])
    assert asked == [True]


def test_bytes_pass_as_they_are(terminal: tuple[int, str], opened: Open) -> None:
    master, path = terminal
    transport = opened(path)
    everything = bytes(range(256))
    transport.write(everything)
    passed = b""
    while len(passed) < len(everything):  # a terminal may pass them on in pieces
        passed += os.read(master, 512)
    assert passed == everything
    os.write(master, everything)
    assert transport.read(256, PATIENCE) == everything


def test_reading_ends_as_soon_as_everything_is_there(
    terminal: tuple[int, str], opened: Open
) -> None:
    master, path = terminal
    transport = opened(path)
    os.write(master, b"abc")
    begun = time.monotonic()
    assert transport.read(3, 40.0) == b"abc"
    assert time.monotonic() - begun < 30.0


def test_reading_in_vain_takes_its_time_and_hardly_more(
    terminal: tuple[int, str], opened: Open
) -> None:
    master, path = terminal
    transport = opened(path)
    for _ in range(20):  # a busy computer adds to some
        os.write(master, b"xab")
        assert transport.read(1, PATIENCE) == b"x"  # so the rest is here as well
        begun = transport.clock()
        assert transport.read(3, 0.1) == b"ab"
        took = transport.clock() - begun
        assert took >= 0.1
        if took < 0.3:
            break
    assert took < 0.3


def test_what_is_discarded_is_returned_and_gone(terminal: tuple[int, str], opened: Open) -> None:
    master, path = terminal
    transport = opened(path)
    os.write(master, b"xstale")
    assert transport.read(1, PATIENCE) == b"x"  # so the rest is here as well
    assert transport.discard() == b"stale"
    assert transport.discard() == b""
    os.write(master, b"new")
    assert transport.read(3, PATIENCE) == b"new"


def test_a_computer_that_stood_still_loses_nothing_of_what_came_meanwhile(
    terminal: tuple[int, str], opened: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    master, path = terminal
    transport = opened(path)
    os.write(master, b"xlate")
    assert transport.read(1, PATIENCE) == b"x"
    monkeypatch.setattr("trex_gui.link.transport._LONGEST_STALE", -1.0)  # it is over already
    assert transport.discard() == b"late"


# --- Ports that do not open -------------------------------------------------------------


def test_a_port_that_is_not_there_is_said_to_be_missing() -> None:
    said = refusal("/dev/ttyNothing9")
    assert said.startswith("There is no port /dev/ttyNothing9.")
    assert "Ports of this computer:" in said


def test_a_port_is_opened_for_us_alone(terminal: tuple[int, str], opened: Open) -> None:
    opened(terminal[1])
    said = refusal(terminal[1])
    assert "is in use" in said
    assert "Close it there, then connect again." in said


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells who holds a port")
def test_who_has_locked_a_port_is_named_before_who_only_has_it_open(
    terminal: tuple[int, str], opened: Open
) -> None:
    code = f"import sys; port = open({terminal[1]!r}); print('open', flush=True); sys.stdin.read()"
    with subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as onlooker:
        assert onlooker.stdout is not None
        assert onlooker.stdout.readline() == b"open\n"
        opened(terminal[1])
        assert "in use by another line of this program" in refusal(terminal[1])
        onlooker.communicate(b"", timeout=30)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells who holds a port")
def test_the_program_that_holds_a_port_is_named(terminal: tuple[int, str]) -> None:
    code = (
        "import serial, sys\n"
        f"port = serial.Serial({terminal[1]!r}, exclusive=True)\n"
        "print('open', flush=True)\n"
        "sys.stdin.read()\n"
    )
    with subprocess.Popen(
        [sys.executable, "-c", code], stdin=subprocess.PIPE, stdout=subprocess.PIPE
    ) as holder:
        assert holder.stdout is not None
        assert holder.stdout.readline() == b"open\n"
        said = refusal(terminal[1])
        assert f"(process {holder.pid})" in said
        holder.communicate(b"", timeout=30)


@pytest.mark.skipif(sys.platform != "linux", reason="only Linux tells who holds a port")
def test_a_line_of_this_program_that_closes_is_waited_for(
    terminal: tuple[int, str], opened: Open, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("trex_gui.link.transport._HANDING_OVER", 30.0)  # however busy
    first = opened(terminal[1])
    closing = threading.Timer(0.2, first.close)
    closing.start()
    try:
        opened(terminal[1])
    finally:
        closing.join()


def test_a_closed_port_can_be_opened_again(terminal: tuple[int, str], opened: Open) -> None:
    opened(terminal[1]).close()
    opened(terminal[1])


def test_closing_twice_does_no_harm(terminal: tuple[int, str], opened: Open) -> None:
    transport = opened(terminal[1])
    transport.close()
    transport.close()


def test_a_file_is_no_port(tmp_path: Path) -> None:
    path = tmp_path / "notes.txt"
    path.write_text("no port")
    assert str(path) in refusal(str(path))
    assert path.read_text() == "no port"


def test_a_network_port_that_nobody_serves_cannot_be_reached() -> None:
    assert refusal("socket://127.0.0.1:9").startswith("socket://127.0.0.1:9 cannot be reached")


@pytest.mark.parametrize("url", ["", "nonsense://x", "socket://nowhere", "rfc2217://", "a\0b"])
def test_a_bad_address_is_refused_in_words(url: str) -> None:
    assert refusal(url)


@pytest.mark.skipif(
    not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may open everything"
)
def test_a_port_without_permission_is_told_with_its_cure(terminal: tuple[int, str]) -> None:
    Path(terminal[1]).chmod(0)
    assert "You may not open" in refusal(terminal[1])


# --- The sentences ----------------------------------------------------------------------


def why(number: int, url: str = "/dev/ttyUSB0") -> str:
    """Return the sentence for an error of the system, as pyserial wraps it."""
    error = OSError(number, os.strerror(number))
    return why_not_open(url, LINE, serial.SerialException(number, f"could not open: {error}"))


def test_a_missing_permission_names_the_group_that_has_it(terminal: tuple[int, str]) -> None:
    import grp

    said = why(errno.EACCES, terminal[1])
    group = grp.getgrgid(Path(terminal[1]).stat().st_gid).gr_name
    assert said.startswith(f"You may not open {terminal[1]}.")
    assert "sudo" in said
    if group != "root":
        assert f"sudo usermod -aG {group} $USER" in said
    assert f"sudo chmod a+rw {terminal[1]}" in said


def test_a_missing_permission_of_a_port_that_is_gone_again_names_the_usual_group() -> None:
    assert "sudo usermod -aG dialout $USER" in why(errno.EACCES, "/dev/ttyGone9")


@pytest.mark.parametrize("number", [errno.EBUSY, errno.EAGAIN])
def test_a_port_in_use_is_to_be_closed_elsewhere(number: int) -> None:
    assert "/dev/ttyUSB0 is in use by" in why(number)


def test_settings_that_a_port_cannot_have_are_named() -> None:
    said = why_not_open("/dev/ttyUSB0", LINE, ValueError("Invalid baud rate"))
    assert "cannot be set to 19200 baud, no error detection, 1 stop bit" in said


def test_an_error_that_nobody_expected_is_told_in_the_words_of_the_system() -> None:
    assert why(errno.EIO) == "/dev/ttyUSB0 cannot be opened: input/output error."


def test_an_error_number_is_found_behind_a_wrapped_error() -> None:
    cause = PermissionError(errno.EACCES, "Permission denied")
    wrapped = serial.SerialException("could not open port")
    wrapped.__cause__ = cause
    assert why_not_open("/dev/ttyX", LINE, wrapped).startswith("You may not open /dev/ttyX.")


def test_an_error_without_a_word_still_makes_a_sentence() -> None:
    said = why_not_open("/dev/ttyX", LINE, AttributeError())
    assert said == "/dev/ttyX cannot be opened: AttributeError."


# --- Lines that are lost ----------------------------------------------------------------


@pytest.mark.parametrize("action", ["read", "discard", "write"])
def test_a_cable_that_is_pulled_is_noticed_at_once(
    action: str, quick_simulator: SimulatedDevice, opened: Open
) -> None:
    transport = opened(quick_simulator.url)
    quick_simulator.do("line unplug")
    begun = time.monotonic()
    act: dict[str, Callable[[], object]] = {
        "read": lambda: transport.read(1, 40.0),
        "discard": transport.discard,
        "write": lambda: transport.write(b"\x82"),
    }
    with pytest.raises(
        PortUnavailable, match=r"is gone\. Plug it in, then connect again\."
    ) as caught:
        act[action]()
    assert time.monotonic() - begun < 30.0
    assert quick_simulator.url in str(caught.value)


def test_a_cable_that_is_pulled_is_noticed_by_a_request(
    quick_simulator: SimulatedDevice, opened: Open
) -> None:
    client = patient(opened(quick_simulator.url), quick_simulator.url)
    client.request(GetMode())
    quick_simulator.do("line unplug")
    with pytest.raises(PortUnavailable):
        client.request(GetMode())


def test_a_network_that_breaks_is_noticed(start_simulator: Start, opened: Open) -> None:
    simulator = start_simulator("--tcp", "127.0.0.1:0")
    client = patient(opened(simulator.url), simulator.url)
    client.request(GetMode())
    simulator.end()
    with pytest.raises(PortUnavailable, match="is gone"):
        client.request(GetMode())


def test_a_port_that_was_closed_under_our_feet_is_gone(
    terminal: tuple[int, str], opened: Open
) -> None:
    transport = opened(terminal[1])
    transport.close()
    for act in (lambda: transport.read(1, 0.1), lambda: transport.write(b"x"), transport.discard):
        with pytest.raises(PortUnavailable):
            act()
