"""A session with a simulated robot in virtual time: opening, asking, moving, halting, ending."""

import pytest

from tests.aracna.link.scene import Scene
from trex_gui.aracna.link.messages import (
    Connected,
    Drag,
    Halt,
    Move,
    Moved,
    Moving,
    Passed,
    Restarted,
    SetLed,
    SetSpeeds,
    Silent,
    SpeedsHeld,
    Stuck,
)
from trex_gui.aracna.link.presence import BOOT, PATIENCE
from trex_gui.link.messages import Closed, Outcome
from trex_gui.protocol.errors import BadReply, BadRequest, NoReply, PortUnavailable

HERE = (512,) * 8
THERE = (600,) * 8
SLOW = (100,) * 8


def test_a_robot_is_connected_to_with_nothing_sent_but_the_question() -> None:
    scene = Scene().until(1.0)
    scene.run()
    assert scene.kinds == ["Connected", "Closed"]
    [connected] = scene.of(Connected)
    assert (connected.version, connected.motors, connected.restarted) == (1, 8, False)
    assert connected.settings.line.baud == 38_400
    assert bytes(scene.stage.transport.sent) == b".q\n"
    assert scene.when(Connected)[0] < 0.1
    assert scene.stage.transport.closed


@pytest.mark.parametrize("boot_loader", [0.0, 1.0, 3.0])
def test_a_robot_that_opening_has_reset_is_connected_to_once_it_listens(boot_loader: float) -> None:
    scene = Scene(booted=False, boot_loader=boot_loader).until(boot_loader + 3.0)
    scene.run()
    assert scene.kinds == ["Connected", "Closed"]
    assert scene.when(Connected)[0] == pytest.approx(boot_loader + BOOT, abs=0.6)
    assert scene.line.station.firmware.boots == 1


@pytest.mark.parametrize("stump", [b".", b".c", b".c512,5", b".v1,2,3,4,5,6,7", b"x" * 58])
def test_what_another_program_left_unfinished_costs_at_most_a_restart(stump: bytes) -> None:
    scene = Scene().until(5.0)
    scene.line.send(stump)
    scene.line.advance(0.5)
    scene.begun = scene.line.now
    scene.until(6.0).run()
    assert scene.of(Connected)
    assert scene.stage.positions == HERE


@pytest.mark.parametrize("tail", [b"h\r\n", b",8\r\n", b"\xff\x00\n", b"20,512,512\r\n", b"\r\n"])
def test_a_first_line_that_is_cut_does_no_harm(tail: bytes) -> None:
    scene = Scene().until(3.0)
    scene.line.inject(tail)
    scene.run()
    assert scene.kinds == ["Connected", "Closed"]


@pytest.mark.parametrize(
    ("motors", "tells", "version"), [(2, True, 0), (2, False, 0), (8, True, 1), (8, False, 1)]
)
def test_builds_that_do_not_tell_how_many_motors_they_have_are_known_by_their_version(
    *, motors: int, tells: bool, version: int
) -> None:
    scene = Scene(motors=motors, tells_motors=tells, version=version).until(1.0)
    scene.run()
    assert [connected.motors for connected in scene.of(Connected)] == [motors]


def test_a_silent_line_is_given_up_with_a_sentence_after_a_boot_loaders_time() -> None:
    scene = Scene().until(30.0)
    scene.stage.do("line mute on")
    scene.at(0.1, Move(1, THERE))
    scene.run()
    closed = scene.reports[-1]
    assert isinstance(closed, Closed)
    assert isinstance(closed.error, NoReply)
    assert "No Aracna answers on virtual at 38400" in str(closed.error)
    assert scene.when(Closed)[0] == pytest.approx(PATIENCE, abs=0.6)
    [outcome] = scene.of(Outcome)
    assert outcome.id == 1
    assert isinstance(outcome.error, NoReply)


def test_something_else_on_the_port_is_shown() -> None:
    scene = Scene().until(30.0)
    scene.stage.do("power off")
    scene.at(0.2, lambda: scene.line.inject(b"\r\nTReX2\r\n"))
    scene.run()
    [closed] = scene.of(Closed)
    assert isinstance(closed.error, BadReply)
    assert "not as an Aracna does" in str(closed.error)
    assert "TReX" in str(closed.error)


def test_a_move_tells_each_motor_as_it_arrives_and_then_all() -> None:
    scene = Scene().at(0.2, SetSpeeds(1, SLOW)).at(0.5, Move(2, THERE)).until(3.0)
    scene.run()
    [held] = scene.of(SpeedsHeld)
    assert held.wanted == held.held == SLOW
    [moving] = scene.of(Moving)
    assert moving.starts == (None,) * 8
    assert moving.expected == pytest.approx(600 / 228)  # as far as it may have to go
    assert [len(passed.present) for passed in scene.of(Passed)] == list(range(8))
    [moved] = scene.of(Moved)
    assert moved.present == (598,) * 8
    assert moved.seconds == pytest.approx(86 / 228, abs=0.06)
    assert [(one.id, one.error) for one in scene.of(Outcome)] == [(1, None), (2, None)]
    assert scene.of(Outcome)[1].value == moved


def test_a_second_move_knows_where_it_starts() -> None:
    scene = Scene().at(0.2, SetSpeeds(1, SLOW)).at(0.4, Move(2, THERE))
    scene.at(2.0, Move(3, HERE)).until(4.0)
    scene.run()
    assert scene.of(Moving)[1].starts == (598,) * 8
    assert scene.of(Moving)[1].expected == pytest.approx(86 / 228)


def test_nothing_is_sent_before_the_answer_is_there() -> None:
    scene = Scene()
    for number in range(1, 6):
        scene.at(0.2, Move(number, THERE if number % 2 else HERE))
    scene.until(5.0).run()
    starts, ends = scene.when(Moving), scene.when(Moved)
    assert len(starts) == len(ends) == 5
    assert all(end <= start for end, start in zip(ends, starts[1:], strict=False))
    assert scene.line.station.holding.lost == 0


@pytest.mark.parametrize("request_", [Move(1, (5,)), Move(1, (1024,) * 8), SetSpeeds(1, (-1,) * 8)])
def test_values_that_the_firmware_would_take_ill_are_refused(request_: Move | SetSpeeds) -> None:
    scene = Scene().at(0.2, request_).at(0.2, Drag((1, 2))).until(1.0)
    scene.run()
    [outcome] = scene.of(Outcome)
    assert isinstance(outcome.error, BadRequest)
    assert not scene.of(Moving)
    assert b"c" not in scene.stage.transport.sent


def test_while_dragging_the_newest_wins_and_goes_out_as_soon_as_the_line_is_free() -> None:
    scene = Scene().at(0.2, SetSpeeds(1, (1023,) * 8))
    for number in range(100):
        scene.at(0.3 + number / 100, Drag((500 + number,) * 8))
    scene.until(3.0).run()
    sent = [moving.goals[0] for moving in scene.of(Moving)]
    assert sent == sorted(set(sent))
    assert sent[-1] == 599
    assert 20 < len(sent) < 40  # 27 to 30 a second at best


def test_the_led_answers_its_state() -> None:
    scene = Scene().at(0.2, SetLed(1, on=True)).at(0.3, SetLed(2, on=False)).until(1.0)
    scene.run()
    assert [outcome.value for outcome in scene.of(Outcome)] == [True, False]


def test_a_halt_drops_what_waits_and_tells_how_the_running_motion_ends() -> None:
    scene = Scene().at(0.1, SetSpeeds(9, SLOW)).at(0.4, Move(1, THERE)).at(0.5, Move(2, HERE))
    scene.at(0.5, Drag(HERE)).at(0.5, SetSpeeds(3, SLOW)).at(0.6, Halt()).until(4.0)
    scene.run()
    outcomes = {outcome.id: outcome.error for outcome in scene.of(Outcome)}
    assert outcomes[1] is None
    assert "Halted" in str(outcomes[2])
    assert "Halted" in str(outcomes[3])
    assert len(scene.of(Moving)) == 1
    assert scene.stage.positions == (598,) * 8
    assert scene.of(Moved)[0].present == (598,) * 8


def test_closing_in_mid_motion_gives_every_request_its_outcome() -> None:
    scene = Scene().at(0.1, SetSpeeds(9, SLOW)).at(0.4, Move(1, THERE)).at(0.5, Move(2, HERE))
    scene.until(0.6).run()
    assert {one.id for one in scene.of(Outcome) if one.error} == {1, 2}
    assert isinstance(scene.reports[-1], Closed)
    assert scene.reports[-1].error is None


@pytest.mark.parametrize("time", [0.001, 0.3, 0.55, 2.5])
def test_a_line_that_is_pulled_out_ends_the_session_in_any_state(time: float) -> None:
    scene = Scene()
    gone = PortUnavailable("The line to virtual is gone. Plug it in, then connect again.")

    def pull() -> None:
        scene.stage.transport.fail = gone

    asked = min(time, 0.2)
    scene.at(asked, SetSpeeds(1, SLOW)).at(asked, Move(2, THERE)).at(asked, Move(3, HERE))
    scene.at(time, pull).until(10.0).run()
    assert scene.reports[-1] == Closed(gone)
    assert {outcome.id for outcome in scene.of(Outcome)} == {1, 2, 3}
    assert scene.stage.transport.closed


@pytest.mark.parametrize("size", [1, 2, 3])
@pytest.mark.parametrize("stump", [b".c\n", b".v\n", b".q\n"])
def test_stumps_on_the_way_to_the_robot_end_in_a_restart_that_is_told(
    stump: bytes, size: int
) -> None:
    """As if only three bytes of a command had come through."""
    scene = Scene().at(0.3, lambda: scene.line.send(stump[:size])).at(0.4, Move(1, THERE))
    scene.at(8.0, Move(2, THERE)).until(12.0)
    scene.run()
    outcomes = {outcome.id: outcome.error for outcome in scene.of(Outcome)}
    assert set(outcomes) == {1, 2}
    assert outcomes[2] is None
    assert scene.stage.positions == (598,) * 8


def test_a_robot_that_falls_silent_is_asked_until_it_is_back() -> None:
    scene = Scene().at(1.0, lambda: scene.stage.do("line mute on"))
    scene.at(6.0, Move(1, THERE)).at(10.0, lambda: scene.stage.do("line mute off")).until(13.0)
    scene.run()
    assert scene.kinds == ["Connected", "Silent", "Outcome", "Connected", "Closed"]
    assert scene.when(Silent)[0] < 5.0
    assert scene.when(Connected)[1] < 12.0
    assert not scene.of(Connected)[1].restarted
    assert isinstance(scene.of(Outcome)[0].error, NoReply)
    assert set(bytes(scene.stage.transport.sent).split(b"\n")) == {b"", b".q"}
    assert not scene.of(Stuck)
    assert not scene.of(Restarted)
