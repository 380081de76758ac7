"""Finding a robot, and moving nothing on the way: neither it nor a TReX that is there instead."""

from collections import deque
from collections.abc import Iterable

import pytest

from tests.emulator.ports import a_board
from tests.link.test_discovery import BOARDS, OWN, State, Wire, hear, orders
from tests.support.aracna import AracnaStage
from trex_gui.aracna.link.client import LINE
from trex_gui.aracna.link.discovery import QUESTION, QUESTIONS, Search, find_aracna
from trex_gui.aracna.protocol.lines import QUERY
from trex_gui.emulator.line import Line
from trex_gui.link.discovery import Step, find
from trex_gui.link.looking import RINSE, RINSE_LINE
from trex_gui.link.settings import LinkSettings
from trex_gui.protocol.errors import PortUnavailable
from trex_gui.protocol.line_settings import Detection, LineSettings

VIRTUAL = LinkSettings("virtual", LineSettings(9600, Detection.ODD), device_number=9)

__all__ = ["orders"]  # a fixture


def search(stage: AracnaStage) -> Search:
    return find_aracna(VIRTUAL, open_wire=lambda _settings: stage.transport)


# --- Aracna ---------------------------------------------------------------------------------


def test_a_robot_is_found_at_its_one_setting() -> None:
    stage = AracnaStage()
    begun = stage.now
    result = search(stage)
    [found] = result.found
    assert found.settings == LinkSettings("virtual", LineSettings(38_400))
    assert (found.name, found.motors, found.device_number, found.echo) == (
        "Aracna 1",
        8,
        None,
        False,
    )
    assert stage.now - begun < 0.6
    assert stage.transport.closed


@pytest.mark.parametrize("ago", [0.0, 0.2, 0.5, 0.9, 1.05])
@pytest.mark.parametrize("keeps_last", [True, False])
def test_a_robot_that_opening_the_port_has_reset_is_found_once_it_listens(
    ago: float, *, keeps_last: bool
) -> None:
    stage = AracnaStage(booted=False, keeps_last=keeps_last)
    stage.line.advance(ago)
    if ago:
        stage.line.receive()  # opening a port commonly discards what came before
    [found] = search(stage).found
    assert ("has reset its board" in found.note) == (ago == 0.0)
    assert stage.now < 2.0
    assert stage.line.station.firmware.boots == 1


def test_an_early_build_with_two_motors_is_found() -> None:
    [found] = search(AracnaStage(motors=2, tells_motors=False)).found
    assert (found.name, found.motors) == ("Aracna 0", 2)


def test_a_robot_is_not_moved_by_being_found() -> None:
    stage = AracnaStage(positions=tuple(range(100, 900, 100)))
    search(stage)
    assert not any(servo.torque for servo in stage.line.servos)
    assert stage.speeds == (0,) * 8


@pytest.mark.parametrize("full", [False, True])
@pytest.mark.parametrize("mute", [False, True])
def test_the_search_for_a_trex_moves_no_robot(*, full: bool, mute: bool) -> None:
    stage = AracnaStage(positions=tuple(range(100, 900, 100)))
    stage.line.faults.mute = mute
    result = find(LinkSettings("virtual"), lambda _settings: stage.transport, full=full)
    stage.line.advance(5.0)
    assert not result.found
    assert not any(servo.torque for servo in stage.line.servos)
    assert stage.speeds == (0,) * 8
    stage.line.faults.mute = False
    stage.line.receive()
    stage.transport.closed = False
    assert len(search(stage).found) == 1


# --- What else may be there -----------------------------------------------------------------


def test_silence_takes_less_than_three_seconds_and_is_told_with_what_to_look_at() -> None:
    stage = AracnaStage()
    stage.do("power off")
    begun = stage.now
    result = search(stage)
    assert not result.found
    assert stage.now - begun < 3.0
    assert "No Aracna answers on virtual at 38400" in result.verdict()
    assert "power" in result.verdict()


def test_something_else_is_shown() -> None:
    stage = AracnaStage()
    stage.do("power off")
    stage.line.inject(b"\r\nERR 7\r\n")
    assert "not as an Aracna does: ERR 7" in search(stage).verdict()


def test_a_robot_that_starts_but_never_answers_is_told() -> None:
    stage = AracnaStage()
    stage.do("power off")
    stage.line.inject(b".h\r\n")
    assert "starts again and again" in search(stage).verdict()


def test_an_echo_is_told() -> None:
    board = a_board()
    board.power_off()
    line = Line([board], echo=True)
    wire = Wire(line)
    result = find_aracna(VIRTUAL, open_wire=lambda _settings: wire)
    assert "comes back" in result.verdict()


def test_behind_a_network_port_of_fixed_rate_nothing_is_asked() -> None:
    stage = AracnaStage()
    stage.transport.can_be_tuned = False
    result = search(stage)
    assert not stage.transport.sent
    assert "was asked for" in result.verdict()
    assert "--device aracna --port virtual" in result.verdict()


def test_neither_silence_nor_noise_is_taken_for_an_echo() -> None:
    stage = AracnaStage()
    stage.do("power off")
    stage.line.inject(b"\xff\x00\xff")
    assert "not as an Aracna does: FF 00 FF" in search(stage).verdict()


def test_progress_is_told_and_the_search_can_be_cancelled() -> None:
    stage = AracnaStage()
    stage.do("line mute on")
    steps: list[Step] = []
    result = find_aracna(
        VIRTUAL,
        progress=steps.append,
        cancelled=lambda: len(steps) == 2,
        open_wire=lambda _settings: stage.transport,
    )
    assert result.cancelled
    assert [(step.done, step.total, step.line) for step in steps] == [
        (0, QUESTIONS, LINE),
        (1, QUESTIONS, LINE),
    ]
    assert stage.transport.closed


def test_a_port_that_goes_away_ends_the_search() -> None:
    stage = AracnaStage()
    stage.transport.fail = PortUnavailable("It is gone.")
    with pytest.raises(PortUnavailable):
        search(stage)
    assert stage.transport.closed


# --- A TReX ---------------------------------------------------------------------------------


@pytest.mark.parametrize("settings", BOARDS, ids=lambda settings: settings.text())
def test_no_trex_hears_an_order_in_the_search(settings: LineSettings, orders: list[str]) -> None:
    """Of every rate, parity, number of stop bits, and with CRC; twice, and whether it is heard."""
    board = a_board(settings=settings.to_wire(), uart_error_shutdown=0)
    for _ in range(2):
        wire = Wire(Line([board]))
        assert not find_aracna(VIRTUAL, open_wire=lambda _settings, wire=wire: wire).found  # type: ignore[misc]
    assert not orders
    assert not board.memory.writes


def _orders_obeyed(
    begun: Iterable[State],
    questions: Iterable[bytes],
    own: LineSettings,
    *,
    crc: bool,
    rinsed: bool,
) -> set[str]:
    """Return every order that a board may obey, these being asked in any order and number.

    Takes every device number for the board's own and every checksum for the right one, so that
    it stands for all of both.
    """
    states = set(begun)
    waiting = deque(states)
    obeyed: set[str] = set()
    while waiting:
        before = {waiting.popleft()}
        if rinsed:
            before, first = hear(before, RINSE, RINSE_LINE, own, crc=crc)
            obeyed |= first
        for question in questions:
            left, more = hear(before, question, LINE, own, crc=crc)
            obeyed |= more
            waiting.extend(left - states)
            states |= left
    return obeyed


BEGUN: list[State] = [(first, *rest) for first in range(0x80, 0xF2) for rest in ((), (1,), (1, 2))]


@pytest.mark.parametrize("own", OWN, ids=lambda own: own.text())
def test_with_no_polynomial_and_no_device_number_can_the_search_be_an_order(
    own: LineSettings,
) -> None:
    """Whatever the board had begun to hear before."""
    for crc in (False, True) if own.detection is Detection.NONE else (False,):
        assert not _orders_obeyed([(), *BEGUN], [QUESTION], own, crc=crc, rinsed=True)


@pytest.mark.parametrize("own", OWN, ids=lambda own: own.text())
def test_neither_can_what_a_session_asks_before_a_robot_has_answered(own: LineSettings) -> None:
    for crc in (False, True) if own.detection is Detection.NONE else (False,):
        assert not _orders_obeyed([()], [QUERY], own, crc=crc, rinsed=False)


def test_the_same_question_without_the_byte_before_it_would_start_a_motor() -> None:
    """The danger is real: else the tests above would say nothing."""
    own = LineSettings(28800)
    assert "c5 05" in _orders_obeyed([()], [QUESTION], own, crc=False, rinsed=False)


def test_where_the_rate_is_fixed_the_question_would_start_a_motor() -> None:
    """Which is why it is not asked there: FF at the same rate ends nothing at another."""
    own, host = LineSettings(28800), LINE
    begun: set[State] = {()}
    obeyed: set[str] = set()
    for question in (RINSE, QUESTION) * 2:
        left, more = hear(begun, question, host, own, crc=False)
        begun |= left
        obeyed |= more
    assert "c5 05" in obeyed
