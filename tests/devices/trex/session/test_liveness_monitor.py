"""When a board counts as not responding, and when it is probed again."""

from tests.devices.trex.session.helpers import staged
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.client.telemetry import Control, Currents, ModeSample, Raw
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.session.reconnecting import LivenessMonitor

ELSEWHERE = (ConnectionSettings("virtual", LineSettings(57600)),)


def silent_at(now: float) -> LivenessMonitor:
    liveness = LivenessMonitor(Timeouts())
    assert [liveness.note_failure(now) for _ in range(3)] == [False, False, True]
    return liveness


def test_reply_between_failures_keeps_board_responding() -> None:
    liveness = LivenessMonitor(Timeouts())
    for _ in range(10):
        assert not liveness.note_failure(1.0)
        assert not liveness.note_failure(1.1)
        liveness.note_answer()
    assert not liveness.silent


def test_topic_that_always_fails_counts_despite_other_replies() -> None:
    """Where wires touch, a request that comes back can pass for a measurement."""
    for topic, fails in ((Control, True), (ModeSample, True), (Raw, False)):
        liveness = LivenessMonitor(Timeouts())
        for _ in range(3):
            liveness.note_failure(1.0, topic)
            liveness.note_answer(Currents)
        assert liveness.silent is fails
    liveness = LivenessMonitor(Timeouts())
    for _ in range(9):
        liveness.note_failure(1.0, ModeSample)
        liveness.note_answer(ModeSample)
    assert not liveness.silent


def test_third_failure_reports_not_responding_once() -> None:
    liveness = silent_at(7.0)
    assert liveness.silent
    assert liveness.retry_at == 7.0 + Timeouts().retry
    assert not liveness.note_failure(8.0)


def test_reading_board_again_ends_not_responding() -> None:
    liveness = silent_at(7.0)
    liveness.begin()
    assert not liveness.silent
    assert not liveness.note_failure(8.0)


def test_candidates_are_scanned_only_when_not_responding() -> None:
    stage, settings = staged()
    client = stage.client(settings)
    responding = LivenessMonitor(Timeouts())
    responding.expect(ELSEWHERE)
    assert not responding.is_scanning(client)
    liveness = silent_at(0.0)
    assert not liveness.is_scanning(client)
    liveness.expect(ELSEWHERE)
    assert liveness.is_scanning(client)
    stage.transport.is_configurable = False
    assert not liveness.is_scanning(client)


def test_scan_continues_until_board_is_read() -> None:
    stage, settings = staged()
    client = stage.client(settings)
    liveness = silent_at(0.0)
    stage.board.power_off()
    liveness.expect(ELSEWHERE)
    assert liveness.look(client) is None
    liveness.expect(())
    assert liveness.is_scanning(client)
    liveness.begin()
    assert not liveness.is_scanning(client)
