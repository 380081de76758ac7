"""When a board counts as not responding, and when it is probed again."""

from tests.devices.trex.session.helpers import staged
from trex_gui.core.timing import Timeouts
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.line_settings import LineSettings
from trex_gui.devices.trex.session.reconnecting import LivenessMonitor

ELSEWHERE = (ConnectionSettings("virtual", LineSettings(57600)),)


def silent_at(now: float) -> LivenessMonitor:
    presence = LivenessMonitor(Timeouts())
    assert [presence.note_failure(now) for _ in range(3)] == [False, False, True]
    return presence


def test_reply_between_failures_keeps_board_responding() -> None:
    presence = LivenessMonitor(Timeouts())
    for _ in range(10):
        assert not presence.note_failure(1.0)
        assert not presence.note_failure(1.1)
        presence.note_answer()
    assert not presence.silent


def test_third_failure_reports_not_responding_once() -> None:
    presence = silent_at(7.0)
    assert presence.silent
    assert presence.retry_at == 7.0 + Timeouts().retry
    assert not presence.note_failure(8.0)


def test_reading_board_again_ends_not_responding() -> None:
    presence = silent_at(7.0)
    presence.begin()
    assert not presence.silent
    assert not presence.note_failure(8.0)


def test_candidates_are_scanned_only_when_not_responding() -> None:
    stage, settings = staged()
    client = stage.client(settings)
    assert not LivenessMonitor(Timeouts()).is_scanning(client, ELSEWHERE)
    presence = silent_at(0.0)
    assert not presence.is_scanning(client, ())
    assert presence.is_scanning(client, ELSEWHERE)
    stage.transport.is_configurable = False
    assert not presence.is_scanning(client, ELSEWHERE)


def test_scan_continues_until_board_is_read() -> None:
    stage, settings = staged()
    client = stage.client(settings)
    presence = silent_at(0.0)
    stage.board.power_off()
    assert presence.look(client, ELSEWHERE) is None
    assert presence.is_scanning(client, ())
    presence.begin()
    assert not presence.is_scanning(client, ())
