"""Line statistics: what is counted, and how often it is reported."""

from itertools import pairwise

from tests.devices.aracna.session.scripted_session import ScriptedSession
from trex_gui.devices.aracna.session.messages import Connected, LineStats, Move, SetSpeeds
from trex_gui.devices.aracna.session.session import STATS_INTERVAL

THERE = (520,) * 8


def last(session: ScriptedSession) -> LineStats:
    return session.of(LineStats)[-1]


def test_counters_are_reported_soon_after_connecting() -> None:
    session = ScriptedSession().until(0.5).run()
    assert last(session).replies == last(session).requests == 1
    assert session.when(LineStats)[0] - session.when(Connected)[0] < 0.1


def test_unanswered_queries_during_boot_are_not_counted() -> None:
    session = ScriptedSession(booted=False).until(4.0).run()
    assert last(session).timeouts == last(session).restarts == 0
    assert last(session).slowest < 0.1


def test_counters_are_reported_at_most_once_a_second() -> None:
    session = ScriptedSession()
    for number in range(40):
        session.at(1 + number / 10, SetSpeeds(number + 1, (100 + number,) * 8))
    session.until(6.0)
    session.run()
    times = session.when(LineStats)
    assert 4 <= len(times) <= 7
    assert all(later - earlier >= STATS_INTERVAL for earlier, later in pairwise(times))
    assert last(session).replies >= 40


def test_unchanged_counters_are_not_reported_again() -> None:
    session = ScriptedSession().until(1.9)  # before the keep-alive query
    session.run()
    assert len(session.of(LineStats)) == 1


def test_slowest_reply_time_excludes_motions() -> None:
    session = ScriptedSession(positions=(100,) * 8).at(0.5, Move(1, THERE, (100,) * 8)).until(12.0)
    session.run()
    counters = last(session)
    assert counters.replies >= 3
    assert 0.02 < counters.slowest < 0.2


def test_unanswered_queries_are_counted_as_silence() -> None:
    session = ScriptedSession().at(1.0, "line mute on").until(12.0).run()
    assert last(session).timeouts >= 3
    assert last(session).corrupted == 0


def test_invalid_reply_is_counted_as_damaged_and_strange() -> None:
    session = ScriptedSession()

    def garble() -> None:
        session.stage.do("power off")
        session.line.inject(b".v,what\r\n")

    session.at(1.0, SetSpeeds(1, (100,) * 8)).at(1.001, garble).until(4.0).run()
    assert last(session).corrupted == 1
    assert last(session).unrecognized >= 1


def test_restart_is_counted() -> None:
    session = ScriptedSession().at(1.0, "reset").until(5.0).run()
    assert last(session).restarts == 1
