"""Session with a simulated robot in virtual time."""

from itertools import pairwise

import pytest

from tests.devices.aracna.session.scripted_session import ScriptedSession
from trex_gui.core.errors import BadRequest, NoReply, PortUnavailable
from trex_gui.core.session import Closed, Outcome
from trex_gui.devices.aracna.session.liveness import BOOT_TIME, BOOT_TIMEOUT
from trex_gui.devices.aracna.session.messages import (
    Connected,
    Halt,
    LineStats,
    Move,
    Moved,
    Moving,
    NotResponding,
    Progress,
    Restarted,
    SetSpeeds,
    SpeedsHeld,
    Stuck,
)
from trex_gui.devices.aracna.session.session import STATS_INTERVAL

HERE = (512,) * 8
THERE = (600,) * 8
SLOW = (100,) * 8


def test_connecting_sends_only_version_query() -> None:
    session = ScriptedSession().until(1.0).run()
    assert session.kinds == ["Connected", "Closed"]
    [connected] = session.of(Connected)
    assert (connected.version, connected.motors) == (1, 8)
    assert bytes(session.stage.transport.sent) == b".q\n"
    assert session.when(Connected)[0] < 0.1
    assert session.stage.transport.closed


@pytest.mark.parametrize("boot_loader", [0.0, 1.0, 3.0])
def test_robot_reset_by_opening_port_connects_after_boot(boot_loader: float) -> None:
    session = ScriptedSession(booted=False, boot_loader=boot_loader).until(boot_loader + 3.0).run()
    assert session.kinds == ["Connected", "Closed"]
    assert session.when(Connected)[0] == pytest.approx(boot_loader + BOOT_TIME, abs=0.6)
    assert session.line.station.firmware.boots == 1


@pytest.mark.parametrize("fragment", [b".", b".c", b".c512,5", b".v1,2,3,4,5,6,7", b"x" * 58])
def test_session_connects_after_incomplete_command(fragment: bytes) -> None:
    session = ScriptedSession()
    session.line.send(fragment)
    session.line.advance(0.5)
    session.started_at = session.line.now
    session.until(6.0).run()
    assert session.of(Connected)
    assert session.stage.positions == HERE


@pytest.mark.parametrize(("motors", "version"), [(2, 0), (8, 1)])
@pytest.mark.parametrize("reports_motors", [True, False])
def test_motor_count_is_reported_or_derived_from_version(
    *, motors: int, reports_motors: bool, version: int
) -> None:
    session = ScriptedSession(motors=motors, reports_motors=reports_motors, version=version)
    session.until(1.0).run()
    assert [connected.motors for connected in session.of(Connected)] == [motors]


def test_silent_line_closes_session_after_boot_loader_time() -> None:
    session = ScriptedSession().until(30.0)
    session.stage.do("line mute on")
    session.at(0.1, Move(1, THERE)).run()
    closed = session.reports[-1]
    assert isinstance(closed, Closed)
    assert isinstance(closed.error, NoReply)
    assert "No Aracna responds on virtual at 38400" in str(closed.error)
    assert session.when(Closed)[0] == pytest.approx(BOOT_TIMEOUT, abs=0.6)
    [outcome] = session.of(Outcome)
    assert outcome.id == 1
    assert isinstance(outcome.error, NoReply)


def test_move_reports_each_arrival_and_then_completion() -> None:
    session = ScriptedSession().at(0.2, SetSpeeds(1, SLOW)).at(0.5, Move(2, THERE)).until(3.0).run()
    [held] = session.of(SpeedsHeld)
    assert held.requested == held.held == SLOW
    [moving] = session.of(Moving)
    assert moving.starts == (None,) * 8
    assert moving.expected == pytest.approx(600 / 228)  # the longest possible distance
    assert [len(progress.present) for progress in session.of(Progress)] == list(range(8))
    [moved] = session.of(Moved)
    assert moved.present == (600,) * 8
    assert moved.seconds == pytest.approx(88 / 228, abs=0.06)
    assert session.of(Outcome) == [Outcome(1, held), Outcome(2, moved)]


def is_moving(report: object) -> bool:
    return isinstance(report, Moving)


def test_next_move_is_sent_only_after_reply() -> None:
    session = ScriptedSession().at(0.2, Move(1, THERE))
    for number in range(2, 6):
        session.on(is_moving, Move(number, THERE if number % 2 else HERE))
    session.until(5.0).run()
    starts, ends = session.when(Moving), session.when(Moved)
    assert len(starts) == len(ends) == 5
    assert all(end <= start for end, start in zip(ends, starts[1:], strict=False))
    assert session.line.station.bytes_missed == 0


@pytest.mark.parametrize("request_", [Move(1, (5,)), Move(1, (1024,) * 8), SetSpeeds(1, (-1,) * 8)])
def test_invalid_positions_and_speeds_are_rejected(request_: Move | SetSpeeds) -> None:
    session = ScriptedSession().at(0.2, request_).until(1.0).run()
    [outcome] = session.of(Outcome)
    assert isinstance(outcome.error, BadRequest)
    assert not session.of(Moving)
    assert b"c" not in session.stage.transport.sent


def test_drag_sends_only_newest_goal_when_line_is_free() -> None:
    session = ScriptedSession().at(0.2, SetSpeeds(1, (1023,) * 8))
    for number in range(100):
        session.at(0.3 + number / 100, Move(number + 2, (500 + number,) * 8, dragged=True))
    session.until(3.0).run()
    sent = [moving.goals[0] for moving in session.of(Moving)]
    assert sent == sorted(set(sent))
    assert sent[-1] == 599
    assert 20 < len(sent) < 40  # 27 to 30 a second at best


def test_halt_drops_queued_moves_and_reports_motion_end() -> None:
    session = (
        ScriptedSession().at(0.1, SetSpeeds(9, SLOW)).at(0.4, Move(1, THERE)).at(0.5, Move(2, HERE))
    )
    session.at(0.5, SetSpeeds(3, SLOW)).at(0.6, Halt()).until(4.0).run()
    assert session.errors[1] is None
    assert "Stopped" in str(session.errors[2])
    assert "Stopped" in str(session.errors[3])
    assert len(session.of(Moving)) == 1
    assert session.stage.positions == (600,) * 8
    assert session.of(Moved)[0].present == (600,) * 8


def test_close_in_motion_ends_every_request_with_outcome() -> None:
    session = (
        ScriptedSession().at(0.1, SetSpeeds(9, SLOW)).at(0.4, Move(1, THERE)).at(0.5, Move(2, HERE))
    )
    session.until(0.6).run()
    assert {outcome.id for outcome in session.of(Outcome) if outcome.error} == {1, 2}
    assert isinstance(session.reports[-1], Closed)
    assert session.reports[-1].error is None


@pytest.mark.parametrize("time", [0.001, 0.3, 0.55, 2.5])
def test_unplugged_line_ends_session_in_any_state(time: float) -> None:
    session = ScriptedSession()
    gone = PortUnavailable("The line to virtual is gone. Plug the adapter in, then connect again.")

    def unplug() -> None:
        session.stage.transport.fail = gone

    moment = min(time, 0.2)
    session.at(moment, SetSpeeds(1, SLOW)).at(moment, Move(2, THERE)).at(moment, Move(3, HERE))
    session.at(time, unplug).until(10.0).run()
    assert session.reports[-1] == Closed(gone)
    assert {outcome.id for outcome in session.of(Outcome)} == {1, 2, 3}
    assert session.stage.transport.closed


@pytest.mark.parametrize("fragment", [b".", b".c", b".c\n", b".v\n", b".q"])
def test_move_succeeds_after_truncated_command(fragment: bytes) -> None:
    """The robot has received only the first bytes of a command."""
    session = ScriptedSession().at(0.3, lambda: session.line.send(fragment)).at(0.4, Move(1, THERE))
    session.at(8.0, Move(2, THERE)).until(9.0).run()
    assert set(session.errors) == {1, 2}
    assert session.errors[2] is None
    assert session.stage.positions == (600,) * 8


def test_silent_robot_is_polled_until_it_replies() -> None:
    session = ScriptedSession().at(1.0, "line mute on")
    session.at(6.0, Move(1, THERE)).at(10.0, "line mute off").until(13.0).run()
    assert session.kinds == ["Connected", "NotResponding", "Outcome", "Connected", "Closed"]
    assert session.when(NotResponding)[0] < 5.0
    assert session.when(Connected)[1] < 12.0
    assert isinstance(session.of(Outcome)[0].error, NoReply)
    assert set(bytes(session.stage.transport.sent).split(b"\n")) == {b"", b".q"}
    assert not session.of(Stuck)
    assert not session.of(Restarted)


# --- Statistics of the line -----------------------------------------------------------------


def last_stats(session: ScriptedSession) -> LineStats:
    return session.of(LineStats)[-1]


def test_counters_are_reported_once_soon_after_connecting() -> None:
    session = ScriptedSession().until(1.9)  # before the keep-alive query
    session.run()
    [counters] = session.of(LineStats)
    assert counters.replies == counters.requests == 1
    assert session.when(LineStats)[0] - session.when(Connected)[0] < 0.1


def test_unanswered_queries_during_boot_are_not_counted() -> None:
    session = ScriptedSession(booted=False).until(4.0).run()
    assert last_stats(session).timeouts == last_stats(session).restarts == 0
    assert last_stats(session).slowest < 0.1


def test_counters_are_reported_at_most_once_a_second() -> None:
    session = ScriptedSession()
    for number in range(40):
        session.at(1 + number / 10, SetSpeeds(number + 1, (100 + number,) * 8))
    session.until(6.0)
    session.run()
    times = session.when(LineStats)
    assert 4 <= len(times) <= 7
    assert all(later - earlier >= STATS_INTERVAL for earlier, later in pairwise(times))
    assert last_stats(session).replies >= 40


def test_slowest_reply_time_excludes_motions() -> None:
    session = ScriptedSession(positions=(100,) * 8).at(0.5, Move(1, HERE, (100,) * 8)).until(4.0)
    session.run()
    counters = last_stats(session)
    assert counters.replies >= 3
    assert 0.02 < counters.slowest < 0.2


def test_unanswered_queries_are_counted_as_timeouts() -> None:
    session = ScriptedSession().at(1.0, "line mute on").until(12.0).run()
    assert last_stats(session).timeouts >= 3
    assert last_stats(session).corrupted == 0


def test_invalid_reply_is_counted_as_corrupted_and_unrecognized() -> None:
    session = ScriptedSession()

    def reply_wrongly() -> None:
        session.stage.do("power off")
        session.line.inject(b".v,what\r\n")

    session.at(1.0, SetSpeeds(1, (100,) * 8)).at(1.001, reply_wrongly).until(4.0).run()
    assert last_stats(session).corrupted == 1
    assert last_stats(session).unrecognized >= 1
