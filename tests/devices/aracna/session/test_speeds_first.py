"""Speeds that precede motions, outdated requests, and limits."""

import re

import pytest

from tests.devices.aracna.session.scripted_session import ScriptedSession
from trex_gui.devices.aracna.protocol.joints import Limits
from trex_gui.devices.aracna.session.errors import rejected_speeds
from trex_gui.devices.aracna.session.messages import (
    Ending,
    Halt,
    Move,
    Moved,
    Moving,
    Play,
    PlayEnded,
    SetLimits,
    SetSpeeds,
    SpeedsHeld,
    Step,
    StepStarted,
    Stuck,
)

HERE = (512,) * 8
THERE = (600,) * 8
SLOW = (30,) * 8
FAST = (700,) * 8


def lines(session: ScriptedSession, letter: str) -> list[str]:
    """Return the values of all sent commands of one letter. Equal values are merged."""
    sent = bytes(session.stage.transport.sent).decode().splitlines()
    return [re.sub(r"^(\d+)(,\1)+$", r"\1", line[2:]) for line in sent if line[1:2] == letter]


def errors(session: ScriptedSession) -> dict[int, str]:
    return {number: str(error or "") for number, error in session.errors.items()}


# --- Speeds before every motion -------------------------------------------------------------


def test_move_needs_servo_power_and_keeps_requested_speed() -> None:
    session = ScriptedSession().at(0.1, "servo power off")
    session.at(0.2, SetSpeeds(1, SLOW)).at(0.5, Move(2, THERE, SLOW))
    session.at(2.0, "servo power on").at(2.1, Move(3, THERE, SLOW)).until(8.0).run()
    assert "Check the servo power" in errors(session)[2]
    assert errors(session)[3] == ""
    [moved] = session.of(Moved)
    assert moved.seconds > 1.2, "88 units at speed 30 take 1.29 s"
    assert [held.held for held in session.of(SpeedsHeld)] == [(-1,) * 8, (-1,) * 8, SLOW]


def test_motor_rejecting_its_speed_is_named_and_none_moves() -> None:
    session = ScriptedSession().at(0.1, "servo 3 dead")
    session.at(0.2, Move(1, THERE, SLOW)).until(3.0).run()
    assert errors(session)[1] == "Motor 3 did not accept speed 30: it does not respond."
    assert not lines(session, "c")


@pytest.mark.parametrize("lost", ["line drop 5", "line drop 5 sent"])
def test_lost_speed_command_or_reply_prevents_motion(lost: str) -> None:
    session = ScriptedSession().at(0.2, lost).at(0.2, Move(1, THERE, SLOW))
    session.at(6.0, Move(2, THERE, SLOW)).until(10.0).run()
    assert errors(session)[1]
    assert errors(session)[2] == ""
    assert len(session.of(Moving)) == 1
    assert session.when(Moving)[0] > 6.0


def test_drag_does_not_resend_confirmed_speeds() -> None:
    session = ScriptedSession().at(0.2, Move(1, THERE, FAST)).at(1.5, Move(2, HERE, FAST))
    session.at(3.0, Move(3, THERE, FAST, dragged=True)).until(5.0).run()
    assert lines(session, "v") == ["700", "700"], "before each move, but not before the drag"
    assert lines(session, "c") == ["600", "512", "600"]


@pytest.mark.parametrize(
    "fault", ["servo 2 lose position", "line drop 11", "reset", "power cycle", "line mute on"]
)
def test_speeds_are_resent_after_fault(fault: str) -> None:
    session = ScriptedSession().at(0.2, Move(1, THERE, FAST)).at(4.0, fault)
    session.at(4.0, Move(2, HERE, FAST)).at(13.0, "line mute off")
    session.at(17.0, Move(3, THERE, FAST)).until(20.0).run()
    assert lines(session, "v")[-1] == "700"
    assert len(lines(session, "v")) >= 2
    assert session.when(SpeedsHeld)[-1] > 17.0
    assert session.of(Moved)[-1].goals == THERE


def test_speeds_are_resent_after_stuck_servo() -> None:
    session = ScriptedSession().at(0.2, Move(1, HERE, FAST)).at(1.1, Move(2, THERE, FAST))
    session.at(1.18, "servo 3 dead").at(8.0, "servo 3 alive")
    session.at(9.0, Move(3, HERE, FAST)).until(11.0).run()
    assert len(session.of(Stuck)) == 1
    assert session.when(SpeedsHeld)[-1] > 9.0
    assert session.of(Moved)[-1].goals == HERE


def test_halt_during_speed_command_prevents_motion() -> None:
    session = ScriptedSession().at(0.2, Move(1, THERE, SLOW)).at(0.21, Halt())
    session.at(1.0, Move(2, THERE, FAST)).at(1.01, Halt()).until(3.0).run()
    assert lines(session, "v") == ["30", "700"]
    assert not lines(session, "c")
    assert "Stopped" in errors(session)[1]


def test_rejected_step_speed_ends_playback() -> None:
    session = ScriptedSession().at(0.1, Move(1, HERE, FAST))
    session.at(2.0, "servo 5 dead").at(2.0, Play(2, (Step(THERE, 1.0),), 0)).until(5.0).run()
    assert [ended.ending for ended in session.of(PlayEnded)] == [Ending.SPEEDS]
    assert "Motor 5 did not accept speed" in errors(session)[2]
    assert lines(session, "c") == ["512"]


def test_servo_that_keeps_its_old_speed_is_named() -> None:
    error = rejected_speeds((30, 30, 30), (30, 0, 30))
    assert str(error) == "Motor 1 did not accept speed 30; it still has speed 0."


# --- The newest request ---------------------------------------------------------------------


def test_newest_speed_applies_to_next_motion() -> None:
    session = ScriptedSession().at(0.2, Move(1, HERE, FAST)).at(3.0, Move(2, THERE, (100,) * 8))
    session.at(3.15, Move(5, HERE, (100,) * 8))
    session.at(3.2, SetSpeeds(3, FAST)).at(3.2, SetSpeeds(4, (20,) * 8)).until(8.0).run()
    assert lines(session, "v") == ["700", "100", "20"]
    assert lines(session, "c") == ["512", "600", "512"]
    assert session.of(Moved)[-1].seconds > 1.8, "86 units at speed 20 take 1.89 s"
    assert "A newer request" in errors(session)[3]
    assert errors(session)[4] == ""


def test_speed_requested_during_speed_command_applies_to_its_motion() -> None:
    session = ScriptedSession().at(0.2, Move(1, THERE, SLOW)).at(0.21, SetSpeeds(2, FAST))
    session.until(3.0).run()
    assert session.of(Moved)[0].seconds < 0.2, "88 units at speed 30 take 1.29 s"
    assert set(errors(session).values()) == {""}


def test_newer_move_replaces_queued_move() -> None:
    session = ScriptedSession().at(0.2, Move(1, THERE, SLOW)).at(0.5, Move(2, (300,) * 8, SLOW))
    session.at(0.6, Move(3, HERE, SLOW)).until(6.0).run()
    assert lines(session, "c") == ["600", "512"]
    assert [number for number, error in errors(session).items() if not error] == [1, 3]
    assert "A newer request" in errors(session)[2]


def test_newer_move_replaces_move_whose_speeds_are_being_set() -> None:
    session = ScriptedSession().at(0.2, Move(1, THERE, SLOW)).at(0.21, Move(2, HERE, SLOW))
    session.until(3.0).run()
    assert lines(session, "c") == ["512"]
    assert "A newer request" in errors(session)[1]


# --- Limits ---------------------------------------------------------------------------------


def test_newest_limits_apply_to_moves_and_playback() -> None:
    session = (
        ScriptedSession().at(0.1, Move(1, HERE, FAST)).at(3.0, SetLimits((Limits(520, 550),) * 8))
    )
    session.at(3.1, Move(2, THERE, FAST)).at(5.0, Move(4, HERE, FAST))
    session.at(7.0, Play(3, (Step((530,) * 8, 0.5), Step((545,) * 8, 0.5)), rounds=0))
    session.on(
        lambda report: isinstance(report, StepStarted) and report.round == 2,
        SetLimits((Limits(535, 540),) * 8),
    )
    session.until(12.0).run()
    sent = lines(session, "c")
    assert sent[:3] == ["512", "550", "520"]
    assert sent[3:7] == ["530", "545"] * 2
    assert sent[8:12] == ["540", "535"] * 2
