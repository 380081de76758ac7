"""Busy board, which reads nothing and stores only three bytes."""

from collections.abc import Callable, Sequence

import pytest

from tests.support.aracna import AracnaHarness
from trex_gui.devices.aracna.simulator.firmware import State
from trex_gui.devices.aracna.simulator.line import LINE, STORED_BYTES

VERSION = b".q1,8\r\n"
SPEEDS = b".v100,100,100,100,100,100,100,100\n"
GOALS = b".c600,600,600,600,600,600,600,600\n"
SHORT_TIME = 0.0002  # seconds; every state takes longer


def wait_until(harness: AracnaHarness, reached: Callable[[], bool]) -> None:
    """Advance time until the condition is true."""
    end = harness.now + 5
    while not reached():
        assert harness.now < end
        harness.line.advance(SHORT_TIME)


def wait_for_state(harness: AracnaHarness, state: State) -> None:
    wait_until(harness, lambda: harness.line.station.firmware.state is state)


def boots(harness: AracnaHarness) -> None:
    harness.do("reset")
    harness.line.advance(0.5)
    assert harness.line.receive() == b".h\r\n"


def answers(harness: AracnaHarness) -> None:
    harness.line.send(b".q\n")
    wait_for_state(harness, State.ANSWERING)


def pauses_before_it_reads_speeds_back(harness: AracnaHarness) -> None:
    harness.line.send(SPEEDS)
    wait_for_state(harness, State.SPEEDS)
    harness.line.advance(0.005)


def reads_speeds_back(harness: AracnaHarness) -> None:
    harness.line.send(SPEEDS)
    wait_until(harness, lambda: harness.line.receive().endswith(b","))


def moves(harness: AracnaHarness) -> None:
    harness.line.send(GOALS)
    wait_for_state(harness, State.MOVING)
    harness.line.advance(0.02)


def waits_for_a_dead_servo(harness: AracnaHarness) -> None:
    harness.do("servo 5 dead")
    moves(harness)
    harness.line.advance(2)


BUSY = [
    boots,
    answers,
    pauses_before_it_reads_speeds_back,
    reads_speeds_back,
    moves,
    waits_for_a_dead_servo,
]
LONG_BUSY = [boots, pauses_before_it_reads_speeds_back, moves, waits_for_a_dead_servo]


def for_each_state(functions: Sequence[Callable[[AracnaHarness], None]]) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("busy", functions, ids=lambda each: each.__name__)


def wait_until_free(harness: AracnaHarness) -> bytes:
    """Advance time until the board is idle. Return the received bytes."""
    harness.do("servo 5 alive")
    harness.line.advance(3)
    return harness.line.receive()


@pytest.mark.parametrize("lines", [b".l0\n.l1\n", b".l0\n\n.l1\n"])
def test_command_is_received_during_last_two_bytes_of_reply(
    harness: AracnaHarness, lines: bytes
) -> None:
    harness.line.advance(2)
    harness.line.receive()
    harness.line.send(lines)
    harness.line.advance(0.01)
    assert harness.line.receive() == b".l0\r\n.l1\r\n"
    assert harness.line.station.bytes_missed == 0


@pytest.mark.parametrize(
    ("lines", "replies"),
    [
        (b".q\n.l1\n.q\n", b".q1,8\r\n.l0\r\n"),
        (b".l1\n.l0\n.l1\n", b".l1\r\n.l0\r\n.l0\r\n"),
        (b".l\n.l1\n.q\n.l0\n", b".l0\r\n.l1\r\n.q1,8\r\n"),
    ],
)
def test_command_is_truncated_during_parsing_of_previous_command(
    harness: AracnaHarness, lines: bytes, replies: bytes
) -> None:
    harness.transport.reconfigure(LINE)
    harness.line.send(lines)
    harness.line.advance(0.02)
    assert harness.line.receive() == replies


@pytest.mark.parametrize(("sent", "seconds"), [(b".q\n", 0.001), (b".q\n.q\n", 0.0017)])
@for_each_state(BUSY)
def test_query_to_busy_board_is_answered_once_when_idle(
    harness: AracnaHarness, busy: Callable[[AracnaHarness], None], sent: bytes, seconds: float
) -> None:
    busy(harness)
    before = harness.line.station.firmware.counters["commands"]
    harness.line.send(sent)
    harness.line.advance(seconds)
    assert harness.line.station.firmware.state is not State.IDLE
    assert wait_until_free(harness).endswith(VERSION)
    assert harness.line.station.firmware.counters["commands"] == before + 1


@for_each_state(LONG_BUSY)
@pytest.mark.parametrize("line", [GOALS, SPEEDS], ids=["positions", "speeds"])
def test_busy_board_keeps_three_bytes_of_longer_command_and_restarts(
    harness: AracnaHarness, busy: Callable[[AracnaHarness], None], line: bytes
) -> None:
    busy(harness)
    boots_before = harness.line.station.firmware.boots
    harness.line.send(line)
    harness.line.advance(0.0095)
    assert len(harness.line.station.held) == STORED_BYTES
    assert harness.line.station.bytes_missed == len(line) - STORED_BYTES
    assert wait_until_free(harness).endswith(b".h\r\n")
    assert harness.line.station.firmware.boots == boots_before + 1
    assert harness.request(b".q\n") == VERSION


@for_each_state(LONG_BUSY)
def test_next_line_completes_truncated_command_and_restarts(
    busy: Callable[[AracnaHarness], None],
) -> None:
    harness = AracnaHarness(keeps_last=False)
    busy(harness)
    harness.line.send(GOALS)  # leaves ".c6"
    harness.line.advance(0.0095)
    assert not wait_until_free(harness).endswith(b".h\r\n")
    assert harness.request(b".q\n", 0.5) == b".h\r\n"


def test_next_command_gives_enough_values_to_truncated_command() -> None:
    harness = AracnaHarness(keeps_last=False)
    moves(harness)
    harness.line.send(GOALS)  # leaves ".c6", which the next line extends to ".c6.c600,…"
    harness.line.advance(0.0095)
    wait_until_free(harness)
    assert harness.request(GOALS) == b".c600,600,600,600,600,600,600,600\r\n"


def test_speeds_sent_right_after_hello_restart_board_each_time() -> None:
    harness = AracnaHarness(booted=False)
    for boot in range(1, 21):
        received = b""
        while not received.endswith(b".h\r\n"):
            byte = harness.line.read(1, 2)
            assert byte, "the board sends nothing more"
            received += byte
        assert received == b".h\r\n"
        assert harness.line.station.firmware.boots == boot
        harness.line.send(SPEEDS)
    assert harness.now == pytest.approx(19, abs=0.1)
