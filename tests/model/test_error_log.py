"""Every error bit that was ever seen."""

from datetime import UTC, datetime

import pytest
from pytestqt.qtbot import QtBot

from trex_gui.link.telemetry import StatusNews
from trex_gui.model.errors import ErrorLog
from trex_gui.protocol.flags import STATUS_MEANING, UART_MEANING, Status, UartError

BITS: list[Status | UartError] = [*STATUS_MEANING, *UART_MEANING]


@pytest.fixture
def log(qtbot: QtBot) -> ErrorLog:
    return ErrorLog()


def news(*bits: Status | UartError) -> StatusNews:
    status, uart = Status(0), UartError(0)
    for bit in bits:
        if isinstance(bit, Status):
            status |= bit
        else:
            uart |= bit
    return StatusNews(1.0, status, uart)


def counts(log: ErrorLog) -> list[int]:
    return [entry.count for entry in log.entries]


def test_all_thirteen_bits_have_an_entry_of_their_own(log: ErrorLog) -> None:
    assert [entry.bit for entry in log.entries] == BITS
    assert [type(entry.bit) for entry in log.entries] == [Status] * 5 + [UartError] * 8
    assert len({entry.name for entry in log.entries}) == 13
    assert all(entry.meaning for entry in log.entries)


def test_nothing_was_seen_at_first(log: ErrorLog) -> None:
    assert counts(log) == [0] * 13
    assert all(entry.last is None for entry in log.entries)


@pytest.mark.parametrize("position", range(13), ids=lambda index: BITS[index].name or "")
def test_each_bit_is_counted_by_itself(log: ErrorLog, position: int) -> None:
    before = datetime.now(UTC)
    log.take(news(BITS[position]))
    log.take(news(BITS[position]))
    expected = [0] * 13
    expected[position] = 2
    assert counts(log) == expected
    last = log.entries[position].last
    assert last is not None
    assert before <= last <= datetime.now(UTC)


def test_bits_that_come_together_are_counted_together(log: ErrorLog) -> None:
    log.take(news(*BITS))
    assert counts(log) == [1] * 13


def test_a_bit_with_an_equal_number_in_the_other_byte_stays_uncounted(log: ErrorLog) -> None:
    log.take(news(Status.UART_ERROR))
    entry = next(one for one in log.entries if one.bit is UartError.SEND_OVERRUN)
    assert entry.count == 0


def test_news_are_announced(log: ErrorLog, qtbot: QtBot) -> None:
    with qtbot.waitSignal(log.changed):
        log.take(news(Status.MOTOR1_FAULT))


def test_a_reset_forgets_counts_and_times(log: ErrorLog, qtbot: QtBot) -> None:
    log.take(news(*BITS))
    with qtbot.waitSignal(log.changed):
        log.reset()
    assert counts(log) == [0] * 13
    assert all(entry.last is None for entry in log.entries)


def test_entries_that_were_handed_out_do_not_change(log: ErrorLog) -> None:
    before = log.entries
    log.take(news(*BITS))
    assert [entry.count for entry in before] == [0] * 13
