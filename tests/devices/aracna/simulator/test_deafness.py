"""Busy board that reads nothing but three bytes."""

from collections.abc import Callable, Sequence

import pytest

from tests.support.aracna import BOOT, AracnaStage
from trex_gui.devices.aracna.simulator.firmware import State
from trex_gui.devices.aracna.simulator.line import HOLDS, OWN

VERSION = b".q1,8\r\n"
SPEEDS = b".v100,100,100,100,100,100,100,100\n"
GOALS = b".c600,600,600,600,600,600,600,600\n"
MOMENT = 0.0002  # seconds, shorter than any state


def until(stage: AracnaStage, reached: Callable[[], bool]) -> None:
    """Advance time until the board is in a state."""
    end = stage.now + 5
    while not reached():
        assert stage.now < end
        stage.line.advance(MOMENT)


def in_state(stage: AracnaStage, state: State) -> None:
    until(stage, lambda: stage.line.station.firmware.state is state)


def boots(stage: AracnaStage) -> None:
    stage.do("reset")
    stage.line.advance(0.5)
    assert stage.line.receive() == b".h\r\n"


def answers(stage: AracnaStage) -> None:
    stage.line.send(b".q\n")
    in_state(stage, State.ANSWERING)


def pauses_before_it_reads_speeds_back(stage: AracnaStage) -> None:
    stage.line.send(SPEEDS)
    in_state(stage, State.SPEEDS)
    stage.line.advance(0.005)


def reads_speeds_back(stage: AracnaStage) -> None:
    stage.line.send(SPEEDS)
    until(stage, lambda: stage.line.receive().endswith(b","))


def moves(stage: AracnaStage) -> None:
    stage.line.send(GOALS)
    in_state(stage, State.MOVING)
    stage.line.advance(0.02)


def waits_for_a_dead_servo(stage: AracnaStage) -> None:
    stage.do("servo 5 dead")
    moves(stage)
    stage.line.advance(2)


BUSY = [
    boots,
    answers,
    pauses_before_it_reads_speeds_back,
    reads_speeds_back,
    moves,
    waits_for_a_dead_servo,
]
LONG_BUSY = [boots, pauses_before_it_reads_speeds_back, moves, waits_for_a_dead_servo]


def named(functions: Sequence[Callable[[AracnaStage], None]]) -> pytest.MarkDecorator:
    return pytest.mark.parametrize("busy", functions, ids=lambda each: each.__name__)


def is_free(stage: AracnaStage) -> bytes:
    """Advance time until the board is idle. Return the received bytes."""
    stage.do("servo 5 alive")
    stage.line.advance(3)
    return stage.line.receive()


@pytest.mark.parametrize("glued", [b".l0\n.l1\n", b".l0\n\n.l1\n"])
def test_command_is_received_during_last_two_bytes_of_reply(
    stage: AracnaStage, glued: bytes
) -> None:
    stage.line.advance(2)
    stage.line.receive()
    stage.line.send(glued)
    stage.line.advance(0.01)
    assert stage.line.receive() == b".l0\r\n.l1\r\n"
    assert stage.line.station.bytes_missed == 0


@pytest.mark.parametrize(
    ("glued", "replies"),
    [
        (b".q\n.l1\n.q\n", b".q1,8\r\n.l0\r\n"),
        (b".l1\n.l0\n.l1\n", b".l1\r\n.l0\r\n.l0\r\n"),
        (b".l\n.l1\n.q\n.l0\n", b".l0\r\n.l1\r\n.q1,8\r\n"),
    ],
)
def test_command_is_truncated_during_parsing_of_previous_command(
    stage: AracnaStage, glued: bytes, replies: bytes
) -> None:
    stage.transport.reconfigure(OWN)
    stage.line.send(glued)
    stage.line.advance(0.02)
    assert stage.line.receive() == replies


@pytest.mark.parametrize(("sent", "seconds"), [(b".q\n", 0.001), (b".q\n.q\n", 0.0017)])
@named(BUSY)
def test_query_to_busy_board_is_answered_once_when_idle(
    stage: AracnaStage, busy: Callable[[AracnaStage], None], sent: bytes, seconds: float
) -> None:
    busy(stage)
    before = stage.line.station.firmware.counters["commands"]
    stage.line.send(sent)
    stage.line.advance(seconds)
    assert stage.line.station.firmware.state is not State.IDLE
    assert is_free(stage).endswith(VERSION)
    assert stage.line.station.firmware.counters["commands"] == before + 1


@named(LONG_BUSY)
@pytest.mark.parametrize("line", [GOALS, SPEEDS], ids=["positions", "speeds"])
def test_busy_board_keeps_three_bytes_of_longer_command_and_restarts(
    stage: AracnaStage, busy: Callable[[AracnaStage], None], line: bytes
) -> None:
    busy(stage)
    boots_before = stage.line.station.firmware.boots
    stage.line.send(line)
    stage.line.advance(0.0095)
    assert len(stage.line.station.held) == HOLDS
    assert stage.line.station.bytes_missed == len(line) - HOLDS
    assert is_free(stage).endswith(b".h\r\n")
    assert stage.line.station.firmware.boots == boots_before + 1
    assert stage.request(b".q\n") == VERSION


@named(LONG_BUSY)
def test_next_line_completes_truncated_command_and_restarts(
    busy: Callable[[AracnaStage], None],
) -> None:
    stage = AracnaStage(keeps_last=False)
    busy(stage)
    stage.line.send(GOALS)  # leaves ".c6"
    stage.line.advance(0.0095)
    assert not is_free(stage).endswith(b".h\r\n")
    assert stage.request(b".q\n", 0.5) == b".h\r\n"


def test_next_command_completes_truncated_one_with_enough_values() -> None:
    stage = AracnaStage(keeps_last=False)
    moves(stage)
    stage.line.send(GOALS)  # leaves ".c6", which the next line extends to ".c6.c600,…"
    stage.line.advance(0.0095)
    is_free(stage)
    assert stage.request(GOALS) == b".c600,600,600,600,600,600,600,600\r\n"


def test_command_sent_right_after_speeds_is_truncated(stage: AracnaStage) -> None:
    stage.line.send(SPEEDS + b".l1\n")  # ".l" and the newline survive
    stage.line.advance(1)
    assert stage.line.receive() == SPEEDS.replace(b"\n", b"\r\n") + b".l0\r\n"


def test_speeds_sent_right_after_hello_restart_board_each_time() -> None:
    stage = AracnaStage(booted=False)
    for boot in range(1, 21):
        heard = b""
        while not heard.endswith(b".h\r\n"):
            byte = stage.line.read(1, 2)
            assert byte, "nothing comes any more"
            heard += byte
        assert heard == b".h\r\n"
        assert stage.line.station.firmware.boots == boot
        stage.line.send(SPEEDS)
    assert stage.now == pytest.approx(19, abs=0.1)


def test_speeds_sent_after_boot_second_are_accepted() -> None:
    stage = AracnaStage(booted=False)
    assert stage.line.read(4, 1) == b".h\r\n"
    stage.line.advance(BOOT)
    assert stage.request(SPEEDS) == SPEEDS.replace(b"\n", b"\r\n")
    assert stage.line.station.firmware.boots == 1
