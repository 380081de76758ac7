"""Boards that were left running."""

import logging
import os
import queue
import signal
import sys
from pathlib import Path
from types import SimpleNamespace

import pytest
import serial
from serial.tools import list_ports
from serial.tools.list_ports_common import ListPortInfo

from tests.devices.trex.simulator.waiting import comes_true
from tests.support.simulator import StartSimulator
from trex_gui.core.crash_detection import is_locked
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.guardian import process
from trex_gui.core.guardian.guardian import GuardianProcess, SharedPort, StopSequence, _message
from trex_gui.core.guardian.log import StopResult, logged_stops
from trex_gui.core.guardian.process import StopMessage, maintain_file
from trex_gui.core.transport import driven, serial_port
from trex_gui.core.transport.driven import (
    driven_at,
    driven_boards,
    driven_file,
    driven_note,
    port_of,
)
from trex_gui.core.transport.serial_port import SerialTransport
from trex_gui.core.transport.settings import Parity, PortSettings, SerialFormat

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="Windows has other locks")

LINE = SerialFormat(57600, Parity.EVEN, 2)
STOP = "d07f7ff000 84 1 1 0 0.05"


def write_driven_file(url: str, line: SerialFormat = LINE) -> Path:
    """Write the file of a board that was left running at a port."""
    file = driven_file(url)
    file.parent.mkdir(parents=True, exist_ok=True)
    note = driven_note("TReX 1.2", PortSettings(url, line))
    file.write_text(f"{note}stop: {STOP}\nsince: 2026-11-28 12:00:00\nguardian: 999999\n")
    return file


def test_board_is_found_at_its_port_only() -> None:
    assert driven_boards() == {}
    write_driven_file("socket://robot:4000")
    board = driven_at("socket://robot:4000")[1]
    assert board is not None
    assert board.settings == PortSettings("socket://robot:4000", LINE)
    stop = bytes.fromhex("d07f7ff000"), (b"\x84",), 1, 1, False, 0.05
    note = f"{driven_note('TReX 1.2', board.settings)}since: 2026-11-28 12:00:00\n"
    assert board.stop == StopSequence(*stop, note)
    assert driven_at("socket://robot:4001")[1] is None
    assert board.text().startswith("Motors may still be turning")


def test_adapter_is_found_at_another_port(monkeypatch: pytest.MonkeyPatch) -> None:
    def plug(device: str, number: str = "A10KX7YZ") -> None:
        port = ListPortInfo(device)
        port.vid, port.pid, port.serial_number = 0x0403, 0x6001, number
        monkeypatch.setattr(list_ports, "comports", lambda: [port])

    plug("/dev/ttyUSB0")
    file = write_driven_file("/dev/ttyUSB0")
    plug("/dev/ttyUSB1")
    board = driven_at("/dev/ttyUSB1")[1]
    assert board is not None
    assert board.settings.url == "/dev/ttyUSB0"
    assert driven_at("/dev/ttyUSB0")[1] is None
    assert port_of(file, board) == PortSettings("/dev/ttyUSB1", LINE)
    plug("/dev/ttyUSB0", "another")
    with pytest.raises(PortUnavailable, match=r"ttyUSB0 is gone\. Plug the adapter in"):
        port_of(file, board)


@pytest.mark.filterwarnings(
    "ignore::ResourceWarning"
)  # the file stays open, as at the end of the process
def test_later_stop_attempt_preserves_start_of_driving() -> None:
    file = write_driven_file("/dev/ttyUSB0")
    found = driven_boards()
    board = found[file]
    assert board is not None
    notes: queue.Queue[bytes | None] = queue.Queue()
    notes.put(StopMessage(_message(board.stop).split()[1:]).note)
    notes.put(None)
    maintain_file(str(file), notes, lambda: None)
    assert driven_boards() == found
    assert file.read_text().count("since: ") == 1


def test_port_failure_during_stop_reports_running_board(monkeypatch: pytest.MonkeyPatch) -> None:
    def fail(_line: SerialTransport, _data: bytes) -> None:
        raise PortUnavailable("It is gone.")

    write_driven_file("loop://")
    monkeypatch.setattr(SerialTransport, "write", fail)
    port = serial.serial_for_url("loop://")
    monkeypatch.setattr(serial_port, "_open", lambda *_: port)
    with pytest.raises(PortUnavailable, match=r"^Motors may still be turning.* It is gone\.$"):
        SerialTransport(PortSettings("loop://"))
    assert not port.is_open


def test_replacement_guardian_does_not_search_ports(monkeypatch: pytest.MonkeyPatch) -> None:
    transport = SerialTransport(PortSettings("loop://"))
    monkeypatch.delattr(serial_port, "driven_at")
    transport.start_guardian(60.0)
    transport.close()


def test_board_of_running_program_is_not_reported() -> None:
    import fcntl  # other test files import this file on Windows

    with write_driven_file("/dev/ttyUSB0").open("rb") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        assert driven_boards() == {}
    assert len(driven_boards()) == 1


def test_board_is_not_reported_while_its_file_is_removed(monkeypatch: pytest.MonkeyPatch) -> None:
    file, found = driven_file("/dev/ttyUSB0"), []

    def unlink(path: str) -> None:
        found.append(driven_boards())
        Path(path).unlink()

    notes: queue.Queue[bytes | None] = queue.Queue()
    for note in (b"board: TReX 1.2\n", b"", None):
        notes.put(note)
    monkeypatch.setattr(process, "os", SimpleNamespace(**vars(os) | {"unlink": unlink}))
    maintain_file(str(file), notes, lambda: None)
    assert not file.exists()
    assert found == [{}]


def test_board_whose_guardian_ends_meanwhile_is_not_reported(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    def end_guardian(path: Path) -> bool:
        path.unlink()
        return False  # the lock of a removed file

    write_driven_file("/dev/ttyUSB0")
    monkeypatch.setattr(driven, "is_locked", end_guardian)
    assert driven_boards() == {}


@pytest.mark.parametrize("text", ["", "port: x\n", "\xff\0", "line: fast N 1\n", "x" * 9999])
def test_damaged_file_warns_of_motors(text: str, caplog: pytest.LogCaptureFixture) -> None:
    file = write_driven_file("/dev/ttyUSB0")
    file.write_text(text)
    assert driven_boards() == {file: None}
    assert driven_at("/dev/ttyUSB0") == (file, None)
    assert f"Motors may still be turning: the file {file} shows" in caplog.text


def test_board_is_found_at_changed_link(tmp_path: Path) -> None:
    link = tmp_path / "robot"
    link.symlink_to("/dev/pts/1")
    file = write_driven_file(str(link))
    link.unlink()
    link.symlink_to("/dev/pts/2")
    at, board = driven_at(str(link))
    assert at == file
    assert board is not None
    assert port_of(file, board).url == str(link)


def test_board_is_found_at_each_name_of_its_address() -> None:
    file = write_driven_file("socket://127.0.0.1:4000")
    for url in ("socket://localhost:4000", "socket://LOCALHOST:4000", "rfc2217://localhost:4000"):
        assert driven_file(url) == file
    assert driven_file("socket://localhost:4001") != file


def test_board_is_logged_once(caplog: pytest.LogCaptureFixture) -> None:
    write_driven_file("/dev/ttyUSB7")
    driven_boards()
    driven_boards()
    warnings = [record for record in caplog.records if record.levelno == logging.WARNING]
    assert ["/dev/ttyUSB7" in record.getMessage() for record in warnings] == [True]


@pytest.mark.realtime
@pytest.mark.parametrize("rate", [19200, 57600])
def test_opening_a_port_stops_its_running_board(
    rate: int, start_simulator: StartSimulator, caplog: pytest.LogCaptureFixture
) -> None:
    simulator = start_simulator()
    line = SerialTransport(PortSettings(simulator.url, SerialFormat(19200)))
    line.write(b"\xc2\x40")
    line.wait(0.1)
    line.close()
    assert simulator.show()["motors"][0]["speed"] == 64
    file = write_driven_file(simulator.url, SerialFormat(19200))
    transport = SerialTransport(PortSettings(simulator.url, SerialFormat(rate)))
    try:
        assert simulator.show()["motors"][0]["direction"] == "brake"
        assert transport._port.baudrate == rate
    finally:
        transport.close()
    assert not file.exists()
    assert logged_stops(0)[1][-1][1] is StopResult.CONFIRMED
    assert "The board now connected there has confirmed a stop." in caplog.records[-1].getMessage()


@pytest.mark.realtime
def test_suspended_guardian_is_resumed_and_stops_the_motors(
    start_simulator: StartSimulator,
) -> None:
    simulator = start_simulator()
    file = driven_file(simulator.url)
    port = os.open(simulator.url, os.O_RDWR | os.O_NOCTTY)
    guardian = GuardianProcess(SharedPort("serial", port), 60.0, file)
    guardian.wait_until_ready(25.0)
    note = driven_note("TReX 1.2", PortSettings(simulator.url, SerialFormat(19200)))
    stop = StopSequence(bytes.fromhex("d07f7ff000"), (b"\x84",), 1, 1, False, 0.07, note)
    guardian.watch(stop)
    os.write(port, b"\xc2\x40")
    assert comes_true(lambda: file.exists() and file.stat().st_size and is_locked(file))
    assert guardian._process is not None
    assert guardian._process.stdin is not None
    guardian._process.send_signal(signal.SIGSTOP)
    null = os.open(os.devnull, os.O_RDONLY)
    os.dup2(null, guardian._process.stdin.fileno())  # closes the pipe, like the end of the program
    os.close(null)
    os.close(port)
    status = Path(f"/proc/{guardian._process.pid}/status")
    assert comes_true(lambda: "(stopped)" in status.read_text())
    SerialTransport(PortSettings(simulator.url, SerialFormat(19200))).close()
    assert simulator.show()["motors"][0]["direction"] == "brake"
    assert not file.exists()
    guardian._process.wait(25)
    assert len(logged_stops(0)[1]) == 2, "the guardian and the opened line have stopped the motors"
