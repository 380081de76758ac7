"""Faults during a command: restarts, dead servos, cut lines and silence."""

from enum import Enum

import pytest

from tests.devices.aracna.session.scripted_session import ScriptedSession
from trex_gui.core.errors import BadReply, NoReply
from trex_gui.core.session import Closed, Outcome
from trex_gui.devices.aracna.session.errors import ErrorCode, RobotError
from trex_gui.devices.aracna.session.liveness import BOOT_TIME
from trex_gui.devices.aracna.session.messages import (
    Connected,
    Ending,
    LineStats,
    Move,
    Moved,
    Moving,
    NotResponding,
    Play,
    PlayEnded,
    Progress,
    Restarted,
    SetSpeeds,
    SpeedsHeld,
    Step,
    Stuck,
)

HERE = (512,) * 8
THERE = (600,) * 8
SLOW = (100,) * 8
STEPS = (Step(THERE, 0.6), Step(HERE, 0.6))


def code(error: object) -> Enum:
    assert isinstance(error, RobotError)
    return error.code


# --- Restarts -------------------------------------------------------------------------------


def _assert_recovered_from_restart(session: ScriptedSession, *, voided: bool) -> None:
    [restarted] = session.of(Restarted)
    assert restarted.voided is voided
    wait = session.when(Connected)[1] - session.when(Restarted)[0]
    assert BOOT_TIME <= wait < BOOT_TIME + 0.2
    assert session.line.station.firmware.boots == 2  # no command was sent too early
    assert not session.of(NotResponding)


def test_restart_while_idle_is_reported_and_robot_reconnects() -> None:
    session = ScriptedSession().at(1.0, "reset").until(4.0).run()
    _assert_recovered_from_restart(session, voided=False)
    assert session.of(LineStats)[-1].restarts == 1


@pytest.mark.parametrize("delay", [0.0005, 0.005, 0.04])
def test_restart_voids_speed_command(delay: float) -> None:
    session = ScriptedSession().at(0.5, SetSpeeds(1, SLOW))
    session.at(0.5 + delay, "reset").at(4.0, SetSpeeds(2, SLOW)).until(5.0).run()
    _assert_recovered_from_restart(session, voided=True)
    assert code(session.errors[1]) is ErrorCode.RESTARTED
    assert session.errors[2] is None


@pytest.mark.parametrize("delay", [0.0005, 0.012, 0.1, 0.38])
def test_restart_voids_move_while_servos_keep_moving(delay: float) -> None:
    session = ScriptedSession().at(0.2, SetSpeeds(9, SLOW)).at(0.5, Move(1, THERE))
    session.on(lambda report: isinstance(report, Moving), Move(2, HERE))
    session.at(0.5 + delay, "reset").until(5.0).run()
    _assert_recovered_from_restart(session, voided=True)
    assert code(session.errors[1]) is ErrorCode.RESTARTED
    assert code(session.errors[2]) is ErrorCode.RESTARTED
    assert not session.of(Moved)
    assert len(session.of(Moving)) == 1  # no motion is sent after the restart
    if delay > 0.01:
        assert session.stage.positions == (600,) * 8


@pytest.mark.parametrize("delay", [0.0, 0.03, 0.3, 1.0])
def test_restart_ends_playback(delay: float) -> None:
    session = ScriptedSession().at(0.5, Play(1, STEPS, rounds=0))
    session.at(0.52 + delay, "reset").until(6.0).run()
    _assert_recovered_from_restart(session, voided=True)
    [ended] = session.of(PlayEnded)
    assert ended.ending is Ending.RESTARTED
    [outcome] = session.of(Outcome)
    assert code(outcome.error) is ErrorCode.RESTARTED
    sent_last = max([0.0, *session.when(Moving)])
    assert sent_last <= session.when(Restarted)[0]


def test_restart_while_connecting_only_delays_connection() -> None:
    session = ScriptedSession(booted=False).at(0.7, "reset").until(5.0).run()
    assert session.kinds == ["Connected", "Closed"]


def test_session_reconnects_once_after_repeated_restarts() -> None:
    session = ScriptedSession()
    for time in (1.0, 1.6, 2.2, 2.8):
        session.at(time, "reset")
    session.until(6.0).run()
    assert len(session.of(Restarted)) == 4
    assert len(session.of(Connected)) == 2
    assert session.line.station.firmware.boots == 5


def test_session_waits_for_boot_loader_after_restart() -> None:
    session = ScriptedSession(boot_loader=3.0).at(1.0, "reset").until(9.0).run()
    assert len(session.of(Connected)) == 2
    assert session.line.station.firmware.boots == 2


# --- Servos that fail -----------------------------------------------------------------------


def _moving_session() -> ScriptedSession:
    """Return a session in which the second move starts after 0.6 s and takes 0.39 s."""
    session = ScriptedSession().at(0.2, SetSpeeds(1, SLOW)).at(0.4, Move(2, HERE))
    return session.at(0.6, Move(3, THERE))


def _stuck_session() -> ScriptedSession:
    return _moving_session().at(0.8, "servo 3 dead")


def test_servo_failing_in_motion_is_reported_as_stuck_once() -> None:
    session = _stuck_session()
    session.at(8.0, Move(4, HERE)).until(10.0).run()
    [stuck] = session.of(Stuck)
    assert stuck.motor == 3
    # The timeout is the time for 88 units at speed 100, plus a quarter, a second and the latency.
    assert session.when(Stuck)[0] - session.when(Moving)[1] == pytest.approx(
        88 / 228 * 1.25 + 1.0, abs=0.06
    )
    assert session.of(Progress)[-1].present == (600,) * 3
    assert not session.of(NotResponding)
    assert session.errors[3] is not None  # closed before the request was complete
    assert session.errors[4] is not None


def test_second_failed_servo_is_also_reported_as_stuck() -> None:
    session = _stuck_session()
    session.at(6.0, "servo 5 dead").at(8.0, "servo 3 alive").until(20.0).run()
    assert [stuck.motor for stuck in session.of(Stuck)] == [3, 5]


def test_recovered_servo_ends_move_and_starts_nothing_else() -> None:
    session = _stuck_session()
    session.at(0.9, Move(4, HERE))  # queued
    session.at(3.1, Move(5, HERE)).at(3.2, Play(6, STEPS)).at(3.3, SetSpeeds(8, (0,) * 8))
    session.at(9.0, "servo 3 alive").at(10.5, Move(7, HERE)).until(14.0).run()
    assert len(session.of(Stuck)) == 1
    assert [moved.present[3] for moved in session.of(Moved)] == [512, 600, 512]
    assert session.when(Moving)[2] > 10.4, "the move was requested after the recovery"
    assert (0,) * 8 not in [held.requested for held in session.of(SpeedsHeld)]
    assert [number for number, error in session.errors.items() if error is None] == [1, 2, 3, 7]
    assert {code(session.errors[number]) for number in (4, 5, 6, 8)} == {ErrorCode.STUCK}
    assert not session.of(NotResponding)


def test_unreadable_position_is_reported_as_unknown() -> None:
    session = ScriptedSession().at(0.1, SetSpeeds(3, SLOW)).at(0.2, "servo 2 lose position")
    session.at(0.3, Move(1, THERE)).at(2.0, Move(2, HERE)).until(6.0).run()
    assert session.of(Moved)[0].present[2] == -1
    assert session.of(Moving)[1].starts[2] is None
    assert session.of(Moving)[1].expected == pytest.approx(512 / 228)


@pytest.mark.parametrize("load", [0.1, 0.19])
def test_slightly_slow_servo_is_not_reported_as_stuck(load: float) -> None:
    session = (
        ScriptedSession(positions=(0,) * 8).at(0.1, SetSpeeds(1, SLOW)).at(0.2, Move(2, (0,) * 8))
    )
    session.at(0.4, f"servo 7 load {load}").at(0.5, Move(3, (1000,) * 8)).until(10.0).run()
    assert len(session.of(Moved)) == 2
    assert not session.of(Stuck)


def test_stuck_motor_ends_playback() -> None:
    session = ScriptedSession().at(0.2, Play(1, STEPS, rounds=0)).at(4.0, "servo 6 block")
    session.at(12.0, "servo 6 free").until(14.0).run()
    assert [ended.ending for ended in session.of(PlayEnded)] == [Ending.STUCK]
    assert session.of(Stuck)[0].motor == 6
    assert "motor 6" in str(session.of(Outcome)[0].error)
    assert session.when(Moving)[-1] < session.when(Stuck)[0]
    reports = [report for report in session.reports if not isinstance(report, LineStats)]
    assert isinstance(reports[-2], Moved)  # the late reply


# --- Corrupted lines ------------------------------------------------------------------------


@pytest.mark.parametrize("lost", [1, 20, 33, 34])
def test_command_after_truncated_reply_succeeds(lost: int) -> None:
    session = ScriptedSession().at(0.2, SetSpeeds(1, SLOW)).at(0.5, Move(2, THERE))
    session.at(0.7, f"line drop {lost}").at(7.0, Move(3, HERE)).until(14.0).run()
    assert session.errors[3] is None
    if session.errors[2] is not None:
        assert isinstance(session.errors[2], NoReply | BadReply)
    assert session.of(Moved)[-1].goals == HERE
    assert session.line.station.firmware.boots == 1


def test_corrupted_speed_reply_fails_after_1_s_and_robot_stays_connected() -> None:
    session = ScriptedSession().at(0.5, "line drop 5").at(0.5, SetSpeeds(1, SLOW))
    session.at(3.0, SetSpeeds(2, SLOW)).until(4.0).run()
    first, second = session.of(Outcome)
    assert isinstance(first.error, BadReply)
    assert second.error is None
    assert session.when(Outcome)[0] == pytest.approx(1.5, abs=0.1)
    assert not session.of(NotResponding)


@pytest.mark.parametrize("dropped", [1, 4, 33, 34])
def test_lost_sent_bytes_do_not_prevent_later_move(dropped: int) -> None:
    session = ScriptedSession().at(0.2, SetSpeeds(9, SLOW)).at(0.5, Move(8, HERE))
    session.at(0.7, f"line drop {dropped} sent")
    session.at(0.7, Move(1, THERE)).at(12.0, Move(2, HERE)).until(16.0).run()
    assert set(session.errors) == {1, 2, 8, 9}
    assert session.errors[2] is None
    assert session.of(Moved)[-1].goals == HERE


@pytest.mark.parametrize("seed", range(3))
def test_session_survives_noise_and_every_request_has_outcome(seed: int) -> None:
    session = ScriptedSession(seed=seed).at(0.2, SetSpeeds(99, SLOW)).at(0.4, "line noise 0.02")
    for number in range(20):
        session.at(0.5 + number * 2, Move(number, THERE if number % 2 else HERE))
    session.at(41.0, "line noise 0")
    for servo in session.line.servos:
        servo.speed = 500
    session.until(51.0).run()
    assert session.reports[-1].error is None  # type: ignore[union-attr]  # it is Closed
    assert sorted(outcome.id for outcome in session.of(Outcome)) == [*range(20), 99]


def test_robot_muted_during_motion_is_reported_as_not_responding() -> None:
    session = _moving_session()
    session.at(0.6, "line mute on").at(12.0, "line mute off").until(16.0).run()
    assert session.of(Stuck)[0].motor is None
    assert len(session.of(NotResponding)) == 1
    assert len(session.of(Connected)) == 2
    assert isinstance(session.errors[3], NoReply)
    assert session.line.station.firmware.boots == 1


def test_move_sent_right_after_lost_reply_succeeds() -> None:
    """The move waits until the robot replies to `.q`."""
    session = _moving_session()
    session.at(0.7, "line cut 8")
    session.on(lambda report: isinstance(report, Moved) and -1 in report.present, Move(4, HERE))
    session.until(10.0).run()
    assert len(session.of(Stuck)) == 1
    assert session.errors[3] is not None
    assert session.errors[4] is None
    assert not session.of(NotResponding)


def test_session_closes_when_board_only_sends_hello() -> None:
    session = ScriptedSession()
    session.stage.do("power off")
    for turn in range(40):
        session.at(3.0 * turn, lambda: session.line.inject(b".h\r\n"))
    session.until(120.0).run()
    [closed] = session.of(Closed)
    assert code(closed.error) is ErrorCode.BOOT_LOOP
    assert session.when(Closed)[0] < 20.0
