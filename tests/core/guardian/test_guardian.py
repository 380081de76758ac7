"""Guardian process: stops, confirmations and its end."""

import ast
import os
import select
import signal
import socket
import sys
import time
from collections import deque
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import replace
from io import FileIO
from itertools import repeat
from pathlib import Path
from threading import Event, Thread
from typing import Any

import pytest

from tests.support.simulator import StartSimulator
from trex_gui.core.crash_detection import is_locked
from trex_gui.core.guardian import process
from trex_gui.core.guardian.guardian import GuardianProcess, SharedPort, StopSequence, _message
from trex_gui.core.guardian.log import StopResult, log_file, logged_stops
from trex_gui.core.transport.guarded import GuardedTransport
from trex_gui.core.transport.serial_port import SerialTransport
from trex_gui.core.transport.settings import PortSettings, SerialFormat

pytestmark = pytest.mark.realtime

STOP = StopSequence(b"\xc1\x00\xf0\x00", (b"\x84",), 1, 0x01, has_echo=False, seconds=0.05)
LONG_SILENCE = 3600.0  # seconds; longer than any test
LONG_TIMEOUT = 25.0


class Board:
    """Board at the far end of a line. It replies to status queries with `statuses`, in order.

    The last status is repeated.
    """

    def __init__(self, line: socket.socket) -> None:
        self.line = line
        self.statuses = [b"\x00"]
        self.received = b""
        Thread(target=self._serve, daemon=True).start()

    def _serve(self) -> None:
        while data := self._receive():
            self.received += data
            for _ in range(data.count(STOP.queries[0])):
                status = self.statuses.pop(0) if len(self.statuses) > 1 else self.statuses[0]
                self.line.sendall(status)

    def _receive(self) -> bytes:
        try:
            return self.line.recv(4096)
        except OSError:
            return b""


Ends = tuple[socket.socket, socket.socket]


@pytest.fixture
def ends() -> Iterator[Ends]:
    """Return the program's and the board's end of a line."""
    ours, theirs = socket.socketpair()
    yield ours, theirs
    ours.close()
    theirs.close()


def started(
    line: socket.socket, silence: float = LONG_SILENCE, kind: str = "serial"
) -> GuardianProcess:
    guardian = GuardianProcess(SharedPort(kind, line.fileno()), silence)
    guardian.wait_until_ready(LONG_TIMEOUT)
    assert guardian.is_ready
    return guardian


@pytest.fixture
def board(ends: Ends) -> Board:
    return Board(ends[1])


@pytest.fixture
def guardian(ends: Ends, board: Board) -> GuardianProcess:
    """Return a guardian of a board whose motors may move."""
    guardian = started(ends[0])
    guardian.watch(STOP)
    return guardian


def wait_until(happened: Callable[[], bool]) -> None:
    end = time.monotonic() + LONG_TIMEOUT
    while not happened():
        assert time.monotonic() < end
        time.sleep(0.01)


def process_of(guardian: GuardianProcess) -> Any:
    assert guardian._process is not None
    return guardian._process


def close_input(guardian: GuardianProcess) -> None:
    """Close the input, as at the end of the program."""
    process_of(guardian).stdin.close()


def has_ended(guardian: GuardianProcess) -> bool:
    return process_of(guardian).poll() is not None and guardian._ended.is_set()


def test_motors_are_stopped_when_the_program_ends_while_they_may_move(
    guardian: GuardianProcess, board: Board
) -> None:
    close_input(guardian)
    wait_until(lambda: has_ended(guardian))
    assert board.received == STOP.packets + 2 * (STOP.packets + STOP.queries[0])
    assert guardian.end(), "the stop is confirmed"
    assert logged(guardian) is StopResult.CONFIRMED


def test_every_board_must_confirm_the_stop(guardian: GuardianProcess, board: Board) -> None:
    board.statuses = [b"\x00", b"\x01", b"\x00"]  # the second board does not confirm in round 1
    both = replace(STOP, packets=STOP.packets * 2, queries=(b"\x84", b"\x84"))
    guardian.watch(both)
    close_input(guardian)
    wait_until(lambda: has_ended(guardian))
    round_ = both.packets + both.queries[0] + both.queries[1]
    assert board.received == both.packets + 3 * round_
    assert logged(guardian) is StopResult.CONFIRMED


def test_slow_disk_delays_only_the_removal_of_the_file(
    ends: Ends, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    disk, file = Event(), tmp_path / "driven" / "port.txt"
    monkeypatch.setattr(os, "fsync", lambda _descriptor: disk.wait(LONG_TIMEOUT))
    (messages, send), (replies, reply) = os.pipe(), os.pipe()
    port = process.SocketPort(ends[0].detach())
    files = str(tmp_path / "log.txt"), str(file)
    streams = FileIO(messages), FileIO(reply, "w")
    watchdog = process.Watchdog(port, LONG_SILENCE, files, *streams)

    def run() -> None:
        with streams[1]:  # closed at the end, so that a missing reply does not block the test
            watchdog.run()

    thread = Thread(target=run)
    thread.start()
    try:
        os.write(send, f"{_message(STOP)}\nidle\nend\n".encode())
        with FileIO(replies) as lines:
            assert any(line == b"closed\n" for line in lines)
        assert ends[1].recv(1) == b"", "the port is closed"
        wait_until(file.exists)
        assert is_locked(file), "the board does not count as left running"
    finally:
        disk.set()
        os.close(send)
        thread.join(LONG_TIMEOUT)
        streams[0].close()
    assert not file.exists()


def logged(guardian: GuardianProcess) -> StopResult:
    """Return the log entry of a guardian that has stopped motors."""
    wait_until(lambda: has_ended(guardian))
    _, stops = logged_stops(0)
    return stops[-1][1]


@pytest.mark.parametrize("confirms", [True, False])
def test_file_exists_until_stop_is_confirmed(
    board: Board, confirms: bool, ends: Ends, tmp_path: Path
) -> None:
    file = tmp_path / "driven" / "port.txt"
    guardian = GuardianProcess(SharedPort("serial", ends[0].fileno()), LONG_SILENCE, file)
    guardian.wait_until_ready(LONG_TIMEOUT)
    guardian.watch(STOP)
    wait_until(file.exists)
    guardian.watch(None)
    wait_until(lambda: not file.exists())
    guardian.watch(replace(STOP, note="board: ours\n"))
    wait_until(lambda: file.exists() and "board: ours" in file.read_text(encoding="utf-8"))
    assert is_locked(file)
    if not confirms:
        board.line.shutdown(socket.SHUT_RDWR)
    close_input(guardian)
    wait_until(lambda: has_ended(guardian))
    assert file.exists() != confirms
    assert confirms or not is_locked(file)


def test_guardian_with_closed_pipe_continues_to_stop(
    guardian: GuardianProcess, board: Board
) -> None:
    board.statuses = [b""]
    null = os.open(os.devnull, os.O_RDONLY)
    os.dup2(null, process_of(guardian).stdin.fileno())  # closes the pipe
    os.close(null)
    guardian.watch(STOP)
    assert guardian.has_acted
    assert not guardian.stop(0)
    board.statuses = [b"\x00"]
    guardian.end()
    assert logged(guardian) is StopResult.CONFIRMED


def test_suspended_guardian_is_lost_and_may_be_killed(board: Board, ends: Ends) -> None:
    guardian = started(ends[0])
    process_of(guardian).send_signal(signal.SIGSTOP)

    def is_lost() -> bool:
        guardian.watch(STOP)
        return not guardian.is_ready

    wait_until(is_lost)
    assert not guardian.end()
    assert has_ended(guardian)
    assert board.received == b""


def test_session_replaces_a_suspended_guardian(start_simulator: StartSimulator) -> None:
    simulator = start_simulator()
    line = SerialTransport(PortSettings(simulator.url, SerialFormat(19200)))
    transport = GuardedTransport(
        line, LONG_SILENCE, lambda: STOP, taken_over=lambda _: None, stop_is_due=lambda: False
    )
    transport.wait_for_guardian()
    first = line._guardian
    assert first is not None
    transport.beat()
    process_of(first).send_signal(signal.SIGSTOP)

    def is_replaced() -> bool:
        transport.wait(0.05)
        return first.has_ended and transport._guardian.is_ready

    try:
        wait_until(is_replaced)
        assert line._guardian is not first
    finally:
        transport.close()


def test_lost_line_ends_the_guardian(ends: Ends) -> None:
    guardian = started(ends[0])
    guardian.watch(STOP)
    ends[1].close()
    assert not guardian.stop(LONG_TIMEOUT)
    assert logged(guardian) is StopResult.UNCONFIRMED


def test_bytes_read_by_another_process_cause_no_failure(monkeypatch: pytest.MonkeyPatch) -> None:
    master, slave = os.openpty()
    with monkeypatch.context() as patched:  # another reader reads between `select` and `read`
        patched.setattr(select, "select", lambda *_: ([slave], [], []))
        assert process.FilePort(slave).receive(LONG_SILENCE) == b""
    os.write(master, b"\x00\n")
    assert process.FilePort(slave).receive(LONG_SILENCE) == b"\x00\n"
    os.close(master)
    os.close(slave)


def test_pipe_in_place_of_log_does_not_block_the_guardian(ends: Ends) -> None:
    Board(ends[1])
    log_file().parent.mkdir(parents=True, exist_ok=True)
    os.mkfifo(log_file())
    guardian = started(ends[0])
    guardian.watch(STOP)
    assert guardian.stop(LONG_TIMEOUT)
    wait_until(lambda: has_ended(guardian))


def test_motors_are_stopped_when_the_heartbeat_is_missing(board: Board, ends: Ends) -> None:
    guardian = started(ends[0], silence=0.2)
    guardian.watch(STOP)
    wait_until(lambda: has_ended(guardian))
    assert board.received.startswith(STOP.packets)
    assert guardian.has_acted
    assert not guardian.is_ready


def test_suspended_guardian_does_not_act_afterwards(board: Board, ends: Ends) -> None:
    guardian = started(ends[0], silence=2.0)
    guardian.watch(STOP)
    wait_until(lambda: guardian._unread == 0)
    process_of(guardian).send_signal(signal.SIGSTOP)
    for _ in range(10):
        guardian.watch(STOP)
        time.sleep(0.25)
    process_of(guardian).send_signal(signal.SIGCONT)
    guardian.watch(STOP)
    wait_until(lambda: guardian._unread == 0)
    assert not guardian.has_acted
    guardian.end()
    assert board.received == b""


def test_idle_guardian_sends_nothing(guardian: GuardianProcess, board: Board) -> None:
    guardian.watch(None)
    close_input(guardian)
    wait_until(lambda: has_ended(guardian))
    assert board.received == b""
    assert not guardian.has_acted


def test_end_frees_the_line_and_sends_nothing(guardian: GuardianProcess, board: Board) -> None:
    assert not guardian.end()
    wait_until(lambda: has_ended(guardian))
    assert board.received == b""


def test_line_errors_do_not_confirm_a_stop_but_motor_faults_do(
    guardian: GuardianProcess, board: Board
) -> None:
    board.statuses = [b"\x01", b"\xf0", b"\x01", b"\xf0"]
    assert guardian.stop(LONG_TIMEOUT)
    assert board.received.count(STOP.queries[0]) == 5


def test_stop_of_silent_board_is_repeated_until_session_returns(
    guardian: GuardianProcess, board: Board
) -> None:
    board.statuses = [b""]
    assert not guardian.stop(0)
    wait_until(lambda: board.received.count(STOP.packets) > 3)
    assert not guardian.end()
    assert logged(guardian) is StopResult.REPEATED


def test_end_waits_longer_than_a_guardian_stops_motors(
    ends: Ends, monkeypatch: pytest.MonkeyPatch
) -> None:
    guardian = started(ends[0])
    guardian.has_acted = True
    waits: list[float] = []

    def wait(seconds: float) -> bool:
        waits.append(seconds)
        return True

    monkeypatch.setattr(guardian._ended, "wait", wait)
    guardian.end()
    assert waits[0] > process._GIVE_UP_S


def test_echo_does_not_count_as_status(board: Board, ends: Ends) -> None:
    echo = STOP.packets + STOP.queries[0]
    board.statuses = [echo + b"\x01", echo + b"\x00"]
    guardian = started(ends[0])
    guardian.watch(replace(STOP, has_echo=True))
    assert guardian.stop(LONG_TIMEOUT)
    assert board.received.count(STOP.queries[0]) == 3


def test_request_echoed_byte_by_byte_confirms_nothing(ends: Ends) -> None:
    """The sent and received data lines touch, although no echo is expected."""

    def echo() -> None:
        with suppress(OSError):
            while data := ends[1].recv(1):
                time.sleep(0.001)
                ends[1].sendall(data)

    Thread(target=echo, daemon=True).start()
    guardian = started(ends[0])
    guardian.watch(STOP)
    assert not guardian.stop(LONG_TIMEOUT)
    wait_until(lambda: has_ended(guardian))


def test_telnet_commands_do_not_count_as_status(board: Board, ends: Ends) -> None:
    negotiation = bytes([255, 251, 3, 255, 250, 44, 107, 255, 255, 0, 255, 240])
    board.statuses = [negotiation + b"\x00"]
    guardian = started(ends[0], kind="telnet")
    escaped = STOP.packets + b"\xff"
    guardian.watch(replace(STOP, packets=escaped))
    assert guardian.stop(LONG_TIMEOUT)
    assert board.received.startswith(escaped + b"\xff" + escaped + b"\xff" + STOP.queries[0])


@pytest.mark.filterwarnings("ignore:set(Daemon|Name):DeprecationWarning")  # a warning of pyserial
@pytest.mark.parametrize("option", ["--link", "--tcp", "--rfc2217"])
def test_guardian_of_hanging_session_gets_replies(
    option: str, start_simulator: StartSimulator, tmp_path: Path
) -> None:
    address = str(tmp_path / "port") if option == "--link" else "127.0.0.1:0"
    simulator = start_simulator(option, address, "--unpaced")
    line = SerialTransport(PortSettings(simulator.url, SerialFormat(19200)))
    try:
        guardian = line.start_guardian(0.3)
        assert isinstance(guardian, GuardianProcess)
        guardian.wait_until_ready(LONG_TIMEOUT)
        guardian.watch(STOP)
        wait_until(lambda: guardian.has_ended)  # without a heartbeat
        assert guardian.end(), "the stop is confirmed"
        assert line.discard() == b""
        line.write(STOP.queries[0])
        assert len(line.read(STOP.reply_size, LONG_TIMEOUT)) == STOP.reply_size
    finally:
        line.close()


def test_ending_signals_do_not_end_the_guardian(guardian: GuardianProcess) -> None:
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        os.kill(process_of(guardian).pid, number)
    assert guardian.stop(LONG_TIMEOUT)


def test_killed_guardian_is_not_ready(ends: Ends) -> None:
    guardian = started(ends[0])
    process_of(guardian).kill()
    wait_until(lambda: not guardian.is_ready)
    guardian.watch(STOP)
    assert not guardian.stop(0)
    assert not guardian.end()


def test_guardian_that_cannot_start_is_never_ready(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, "executable", "/nowhere/python")
    guardian = GuardianProcess(SharedPort("serial", 0), LONG_SILENCE)
    guardian.wait_until_ready(LONG_TIMEOUT)
    guardian.watch(STOP)
    assert not guardian.is_ready
    assert not guardian.end()


def start_late(ends: Ends, folder: Path) -> tuple[GuardianProcess, Path]:
    """Start a guardian that hangs in its start until a file exists. Return it and the file."""
    gate, executable = folder / "gate", folder / "python"
    wait = f'while [ ! -e "{gate}" ]; do sleep 0.01; done'
    executable.write_text(f'#!/bin/sh\n{wait}\nexec "{sys.executable}" "$@"\n')
    executable.chmod(0o755)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "executable", str(executable))
        return GuardianProcess(SharedPort("serial", ends[0].fileno()), LONG_SILENCE), gate


def watch_all(guardian: GuardianProcess, sequences: Iterable[StopSequence]) -> None:
    """Send heartbeats. A write that blocks fails the test."""
    session = Thread(target=lambda: deque(map(guardian.watch, sequences)), daemon=True)
    session.start()
    session.join(LONG_TIMEOUT)
    is_blocked = session.is_alive()
    if is_blocked and guardian._process is not None:
        guardian._process.kill()
    assert not is_blocked


def test_guardian_that_hangs_in_its_start_never_blocks_the_session(
    ends: Ends, tmp_path: Path
) -> None:
    guardian, _ = start_late(ends, tmp_path)
    watch_all(guardian, (replace(STOP, seconds=number) for number in range(1000)))
    assert not guardian.end()
    assert has_ended(guardian)


def test_guardian_that_starts_late_stops_the_motors(
    board: Board, ends: Ends, tmp_path: Path
) -> None:
    guardian, gate = start_late(ends, tmp_path)
    watch_all(guardian, repeat(STOP, 1000))
    gate.touch()
    guardian.wait_until_ready(LONG_TIMEOUT)
    assert guardian.stop(LONG_TIMEOUT)
    assert board.received.startswith(STOP.packets)


def test_process_imports_only_the_standard_library() -> None:
    tree = ast.parse(Path(process.__file__).read_text(encoding="utf-8"))
    names = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            names |= {alias.name.split(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            names.add((node.module or ".").split(".")[0])
    assert names <= sys.stdlib_module_names


@pytest.mark.parametrize("module", ["trex_gui", "trex_gui.cli"])
def test_executable_can_run_as_guardian(
    board: Board, ends: Ends, module: str, tmp_path: Path
) -> None:
    """Without a Python interpreter, a frozen application runs itself as the guardian."""
    executable = tmp_path / "trex"
    executable.write_text(f'#!/bin/sh\nexec "{sys.executable}" -m {module} "$@"\n')
    executable.chmod(0o755)
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(sys, "executable", str(executable))
        patch.setattr(sys, "frozen", True, raising=False)
        guardian = started(ends[0])
    guardian.watch(STOP)
    assert guardian.stop(LONG_TIMEOUT)
    assert board.received.startswith(STOP.packets)
