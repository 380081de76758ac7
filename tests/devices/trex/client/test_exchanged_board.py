"""Settings are only written to the board that was read."""

from collections.abc import Callable

import pytest

from tests.devices.trex.session.helpers import commands, create_harness
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness
from trex_gui.devices.trex.client.client import TrexClient
from trex_gui.devices.trex.client.reading import DeviceState, read_everything
from trex_gui.devices.trex.client.writing import WriteResult, write_all
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.commands import Command, ReplyT_co, SetParameter
from trex_gui.devices.trex.protocol.errors import ErrorCode, OtherBoard, Skipped, TrexNoReplyError
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import parameters_of
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import SimulatedBoards

SPECS = parameters_of("trex", "1.2")
CHANGES = [("motor1_acceleration", 3), ("motor2_acceleration", 4), ("serial_timeout", 15)]
Preparation = Callable[[Board], object]


def _store(key: str, wire: int) -> Preparation:
    return lambda board: board.eeprom.write(key, wire)


def _calibrate(board: Board) -> None:
    board.eeprom.write_calibration(InputSource.RC, 5, Calibration(2400, 3700, 5100, 80))


def read_board() -> tuple[SessionHarness, TrexClient, DeviceState]:
    """Read a simulated board. Return its harness, its client and its state."""
    harness, settings = create_harness()
    client = harness.client(settings)
    return harness, client, read_everything(client.request)


def _exchange(harness: SessionHarness, board: Board) -> Board:
    """Let another board reply from now on."""
    board.memory.load()
    line = SimulatedBoards([board])
    line.advance(harness.line.now)
    harness.transport.line = line
    return board


def _was_written(board: Board) -> bool:
    return board.memory.writes > 0


@pytest.mark.parametrize(
    ("board", "prepare", "code"),
    [
        (Board("trexjr"), lambda _board: None, ErrorCode.OTHER_BOARD),
        (Board(firmware="1.3"), lambda _board: None, ErrorCode.OTHER_BOARD),
        (Board(), _store("device_number", 9), ErrorCode.OTHER_VALUES),
        (Board(), _store("motor_mode", 1), ErrorCode.OTHER_VALUES),
        (Board(), _store("serial_timeout", 15), ErrorCode.OTHER_VALUES),
        (Board(), _calibrate, ErrorCode.OTHER_VALUES),
    ],
    ids=["model", "firmware", "number", "another value", "value to write", "calibration"],
)
def test_board_with_other_settings_is_not_written(
    board: Board, prepare: Preparation, code: ErrorCode
) -> None:
    harness, client, before = read_board()
    prepare(board)
    other = _exchange(harness, board)
    with pytest.raises(OtherBoard) as caught:
        write_all(client.request, SPECS, CHANGES, before=before)
    assert caught.value.code is code
    assert not _was_written(other)
    assert not _was_written(harness.board)


@pytest.mark.parametrize("writes", range(1, len(CHANGES) + 1))
@pytest.mark.parametrize(
    ("model", "number"), [("trexjr", 7), ("trex", 9)], ids=["another model", "another number"]
)
def test_board_that_replaces_a_silent_board_is_not_written(
    writes: int, model: str, number: int
) -> None:
    harness, client, before = read_board()
    other = Board(model)
    _store("device_number", number)(other)
    sent = 0

    def request(command: Command[ReplyT_co]) -> ReplyT_co:
        """Lose the reply to a write, and exchange the board."""
        nonlocal sent
        sent += isinstance(command, SetParameter)
        if sent < writes or harness.transport.line is not harness.line:
            return client.request(command)
        harness.board.power_off()
        try:
            return client.request(command)
        finally:
            _exchange(harness, other)

    with pytest.raises(OtherBoard) as caught:
        write_all(request, SPECS, CHANGES, before=before)
    assert caught.value.code is ErrorCode.OTHER_BOARD_AFTER_WRITING
    assert not _was_written(other)
    assert harness.board.memory.writes == writes - 1


@pytest.mark.parametrize("replies", [1, 5, 20, 36])
def test_board_exchanged_during_comparison_is_not_written(replies: int) -> None:
    """Otherwise values of two boards would be taken for values of one board."""
    harness, client, before = read_board()
    other = Board("trexjr")
    requests = 0

    def request(command: Command[ReplyT_co]) -> ReplyT_co:
        nonlocal requests
        requests += 1
        if requests == replies + 1:
            _exchange(harness, other)
        return client.request(command)

    with pytest.raises(OtherBoard):
        write_all(request, SPECS, CHANGES, before=before)
    assert not _was_written(other)


def test_board_is_compared_again_after_the_last_write() -> None:
    harness, client, before = read_board()
    stored: list[WriteResult] = []

    def record(result: WriteResult) -> None:
        stored.append(result)
        if len(stored) == len(CHANGES):
            _exchange(harness, Board("trexjr"))

    with pytest.raises(OtherBoard) as caught:
        write_all(client.request, SPECS, CHANGES, before=before, on_stored=record)
    assert caught.value.code is ErrorCode.OTHER_BOARD_AFTER_WRITING


@pytest.mark.parametrize("seed", sampled(range(20), every=4))
def test_corrupted_readings_are_not_taken_for_another_board(seed: int) -> None:
    harness, client, before = read_board()
    harness.transport.line = SimulatedBoards([harness.board], seed=seed)
    harness.transport.line.faults.noise = 0.005
    results = write_all(client.request, SPECS, CHANGES, before=before)
    assert {result.key for result in results} == dict(CHANGES).keys()


def test_board_that_cannot_be_compared_is_not_written() -> None:
    harness, client, before = read_board()
    harness.board.power_off()
    results = write_all(client.request, SPECS, CHANGES, before=before)
    assert [type(result.error) for result in results] == [TrexNoReplyError] * len(CHANGES)
    assert SetParameter not in map(type, commands(harness.transport.sent))


def test_changed_device_number_is_not_taken_for_another_board() -> None:
    _, client, before = read_board()
    changes = [("device_number", 9), *CHANGES]
    results = write_all(client.request, SPECS, changes, before=before)
    assert all(result.error is None for result in results)


def test_board_without_writes_is_not_compared_at_the_end() -> None:
    harness, client, before = read_board()
    _exchange(harness, Board("trexjr"))
    results = write_all(client.request, SPECS, CHANGES, before=before, cancelled=lambda: True)
    assert all(isinstance(result.error, Skipped) for result in results)
    assert len(results) == len(CHANGES)
