"""Counts of error bits."""

from dataclasses import replace
from datetime import UTC, datetime

import pytest

from trex_gui.devices.trex.board.errors import ErrorCounts
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.protocol.flags import UART_MEANING, Status, UartError, stops_motors

NOW = 100.0
TODAY = datetime(2026, 7, 1, 12, tzinfo=UTC)

BITS: list[Status | UartError] = [
    *(Status.MOTOR1_FAULT, Status.MOTOR1_OVER_LIMIT),
    *(Status.MOTOR2_FAULT, Status.MOTOR2_OVER_LIMIT),
    Status.UART_ERROR,
    *UART_MEANING,
]


@pytest.fixture
def log() -> ErrorCounts:
    return ErrorCounts()


def news(*bits: Status | UartError) -> LatchedStatus:
    status, uart = Status(0), UartError(0)
    for bit in bits:
        if isinstance(bit, Status):
            status |= bit
        else:
            uart |= bit
    return LatchedStatus(1.0, status, uart)


def counts(log: ErrorCounts) -> list[int]:
    return [entry.count for entry in log.entries]


def uncleared(log: ErrorCounts) -> int:
    return sum(entry.is_uncleared for entry in log.occurred)


def test_each_of_13_bits_has_its_own_entry(log: ErrorCounts) -> None:
    assert [entry.bit for entry in log.entries] == BITS
    assert [type(entry.bit) for entry in log.entries] == [Status] * 5 + [UartError] * 8
    assert len({entry.name for entry in log.entries}) == 13
    assert all(entry.meaning and entry.remedy for entry in log.entries)


def test_bits_from_before_the_connection_are_noted_and_not_counted(log: ErrorCounts) -> None:
    earlier = replace(news(Status.UART_ERROR, UartError.FRAMING), is_earlier=True)
    log.count(earlier, NOW, TODAY)
    log.count(news(UartError.FRAMING), NOW, TODAY)
    noted = [(entry.bit, entry.count) for entry in log.entries if entry.is_earlier]
    assert noted == [(Status.UART_ERROR, 0), (UartError.FRAMING, 1)]
    assert uncleared(log) == 1


@pytest.mark.parametrize("position", range(13), ids=lambda index: BITS[index].name or "")
def test_each_bit_is_counted_separately(log: ErrorCounts, position: int) -> None:
    log.count(news(BITS[position]), NOW, TODAY)
    log.count(news(BITS[position]), NOW, TODAY)
    expected = [0] * 13
    expected[position] = 2
    assert counts(log) == expected
    assert log.entries[position].last == TODAY


def test_each_change_is_reported() -> None:
    told: list[int] = []
    board = ErrorCounts(lambda: told.append(sum(counts(board))))
    board.count(news(*BITS), NOW, TODAY)
    board.clear(Status.MOTOR1_FAULT)
    board.reset()
    assert told == [13, 13, 0]
    assert all(entry.last is None for entry in board.entries)


def test_clearing_keeps_counts_and_ends_with_the_next_report(log: ErrorCounts) -> None:
    assert uncleared(log) == 0
    log.count(news(Status.MOTOR1_FAULT, Status.UART_ERROR, UartError.FRAMING), NOW, TODAY)
    assert uncleared(log) == 2, "the bit that announces UART errors is no error of its own"
    log.clear(Status.MOTOR1_FAULT)
    (left,) = (entry.bit for entry in log.occurred if entry.is_uncleared)
    assert left is UartError.FRAMING, "its bit has the same number"
    log.clear(UartError.FRAMING)
    assert uncleared(log) == 0
    assert sum(counts(log)) == 3
    log.count(news(Status.UART_ERROR), NOW, TODAY)
    assert uncleared(log) == 1


def test_error_is_active_while_it_is_reported(log: ErrorCounts) -> None:
    log.count(news(Status.MOTOR1_FAULT), NOW, TODAY)
    assert log.is_active(log.entries[0], NOW + 0.5)
    assert not log.is_active(log.entries[0], NOW + 1.5)
    assert not log.is_active(log.entries[1], NOW + 0.5)


@pytest.mark.parametrize(
    ("bit", "stops", "stops_if_set"),
    [
        (Status.MOTOR2_FAULT, True, True),
        (Status.MOTOR2_OVER_LIMIT, False, False),
        (Status.UART_ERROR, False, True),
        (UartError.TIMEOUT, True, True),
        (UartError.SEND_OVERRUN, False, True),
        (UartError.FRAMING, False, True),
    ],
)
def test_error_shutdown_determines_bits_that_stop_motors(
    bit: Status | UartError, *, stops: bool, stops_if_set: bool
) -> None:
    assert stops_motors(bit, errors_stop=False) is stops
    assert stops_motors(bit, errors_stop=True) is stops_if_set


def test_returned_entries_are_not_updated(log: ErrorCounts) -> None:
    before = log.entries
    log.count(news(*BITS), NOW, TODAY)
    assert [entry.count for entry in before] == [0] * 13


def test_only_the_last_report_is_marked_as_doubtful(log: ErrorCounts) -> None:
    log.count(news(Status.MOTOR1_FAULT), NOW, TODAY, is_doubtful=True)
    assert [entry.bit for entry in log.entries if entry.is_doubtful] == [Status.MOTOR1_FAULT]
    log.count(news(Status.MOTOR1_FAULT), NOW, TODAY)
    assert not any(entry.is_doubtful for entry in log.entries)


def test_recent_errors_are_those_of_the_motor_and_of_the_line(log: ErrorCounts) -> None:
    log.count(news(Status.MOTOR1_FAULT, Status.MOTOR2_OVER_LIMIT, UartError.TIMEOUT), NOW, TODAY)
    assert [entry.bit for entry in log.recent(1, NOW + 2)] == [
        Status.MOTOR1_FAULT, UartError.TIMEOUT
    ]  # fmt: skip
    assert [entry.bit for entry in log.recent(2, NOW + 2)] == [
        Status.MOTOR2_OVER_LIMIT, UartError.TIMEOUT
    ]  # fmt: skip
    assert not log.recent(1, NOW + 3)


def test_counts_of_another_board_on_the_line_are_retained(log: ErrorCounts) -> None:
    log.count(news(Status.MOTOR1_FAULT), NOW, TODAY)
    log.select("one", "other")
    assert sum(counts(log)) == 0
    log.select("other", "one")
    assert sum(counts(log)) == 1
