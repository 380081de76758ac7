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
def errors() -> ErrorCounts:
    return ErrorCounts()


def report(*bits: Status | UartError) -> LatchedStatus:
    status, uart = Status(0), UartError(0)
    for bit in bits:
        if isinstance(bit, Status):
            status |= bit
        else:
            uart |= bit
    return LatchedStatus(1.0, status, uart)


def counts(errors: ErrorCounts) -> list[int]:
    return [entry.count for entry in errors.entries]


def uncleared(errors: ErrorCounts) -> int:
    return sum(entry.is_uncleared for entry in errors.occurred)


def test_each_of_13_bits_has_its_own_entry(errors: ErrorCounts) -> None:
    assert [entry.bit for entry in errors.entries] == BITS
    assert [type(entry.bit) for entry in errors.entries] == [Status] * 5 + [UartError] * 8
    assert len({entry.name for entry in errors.entries}) == 13
    assert all(entry.meaning and entry.remedy for entry in errors.entries)


def test_bits_set_before_connecting_are_shown_but_not_counted(errors: ErrorCounts) -> None:
    earlier = replace(report(Status.UART_ERROR, UartError.FRAMING), is_earlier=True)
    errors.count(earlier, NOW, TODAY)
    errors.count(report(UartError.FRAMING), NOW, TODAY)
    shown = [(entry.bit, entry.count) for entry in errors.entries if entry.is_earlier]
    assert shown == [(Status.UART_ERROR, 0), (UartError.FRAMING, 1)]
    assert uncleared(errors) == 1


@pytest.mark.parametrize("position", range(13), ids=lambda index: BITS[index].name or "")
def test_each_bit_is_counted_separately(errors: ErrorCounts, position: int) -> None:
    errors.count(report(BITS[position]), NOW, TODAY)
    errors.count(report(BITS[position]), NOW, TODAY)
    expected = [0] * 13
    expected[position] = 2
    assert counts(errors) == expected
    assert errors.entries[position].last == TODAY


def test_newest_error_is_listed_first(errors: ErrorCounts) -> None:
    errors.count(report(Status.MOTOR2_FAULT), NOW, TODAY)
    errors.count(report(UartError.CRC), NOW + 1, TODAY)
    assert [entry.bit for entry in errors.occurred] == [UartError.CRC, Status.MOTOR2_FAULT]


def test_each_change_is_reported() -> None:
    totals: list[int] = []
    observed = ErrorCounts(lambda: totals.append(sum(counts(observed))))
    observed.count(report(*BITS), NOW, TODAY)
    observed.clear(Status.MOTOR1_FAULT)
    observed.reset()
    assert totals == [13, 13, 0]
    assert all(entry.last is None for entry in observed.entries)


def test_clearing_keeps_counts_and_lasts_until_the_next_report(errors: ErrorCounts) -> None:
    assert uncleared(errors) == 0
    errors.count(report(Status.MOTOR1_FAULT, Status.UART_ERROR, UartError.FRAMING), NOW, TODAY)
    assert uncleared(errors) == 2, "UART_ERROR only announces another error"
    errors.clear(Status.MOTOR1_FAULT)
    (uncleared_bit,) = (entry.bit for entry in errors.occurred if entry.is_uncleared)
    assert uncleared_bit is UartError.FRAMING, "FRAMING has the value of MOTOR1_FAULT"
    errors.clear(UartError.FRAMING)
    assert uncleared(errors) == 0
    assert sum(counts(errors)) == 3
    errors.count(report(Status.UART_ERROR), NOW, TODAY)
    assert uncleared(errors) == 1


def test_error_is_active_while_it_is_reported(errors: ErrorCounts) -> None:
    errors.count(report(Status.MOTOR1_FAULT), NOW, TODAY)
    assert errors.is_active(errors.entries[0], NOW + 0.5)
    assert not errors.is_active(errors.entries[0], NOW + 1.5)
    assert not errors.is_active(errors.entries[1], NOW + 0.5)


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


def test_returned_entries_are_not_updated(errors: ErrorCounts) -> None:
    before = errors.entries
    errors.count(report(*BITS), NOW, TODAY)
    assert [entry.count for entry in before] == [0] * 13


def test_only_the_last_report_is_marked_as_doubtful(errors: ErrorCounts) -> None:
    errors.count(report(Status.MOTOR1_FAULT), NOW, TODAY, is_doubtful=True)
    assert [entry.bit for entry in errors.entries if entry.is_doubtful] == [Status.MOTOR1_FAULT]
    errors.count(report(Status.MOTOR1_FAULT), NOW, TODAY)
    assert not any(entry.is_doubtful for entry in errors.entries)


def test_recent_errors_of_a_motor_include_line_errors(errors: ErrorCounts) -> None:
    latched = report(Status.MOTOR1_FAULT, Status.MOTOR2_OVER_LIMIT, UartError.TIMEOUT)
    errors.count(latched, NOW, TODAY)
    assert [entry.bit for entry in errors.recent(1, NOW + 2)] == [
        Status.MOTOR1_FAULT, UartError.TIMEOUT
    ]  # fmt: skip
    assert [entry.bit for entry in errors.recent(2, NOW + 2)] == [
        Status.MOTOR2_OVER_LIMIT, UartError.TIMEOUT
    ]  # fmt: skip
    assert not errors.recent(1, NOW + 3)


def test_counts_of_another_board_on_the_line_are_retained(errors: ErrorCounts) -> None:
    errors.count(report(Status.MOTOR1_FAULT), NOW, TODAY)
    errors.select("first", "second")
    assert sum(counts(errors)) == 0
    errors.select("second", "first")
    assert sum(counts(errors)) == 1
