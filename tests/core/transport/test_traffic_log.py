"""Traffic log of a line."""

from collections.abc import Callable

import pytest

from tests.devices.trex.session.helpers import run_for
from tests.support.virtual import SessionHarness, VirtualTransport
from trex_gui.core.errors import PortUnavailable
from trex_gui.core.transport.settings import PortSettings
from trex_gui.core.transport.traffic import (
    LoggingTransport,
    TrafficDirection,
    TrafficEvent,
    TrafficLog,
    logged,
)
from trex_gui.devices.trex.driving.requests import SetMotor
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings
from trex_gui.devices.trex.session.messages import Connected
from trex_gui.devices.trex.session.session import TrexSession
from trex_gui.devices.trex.simulator.firmware import Board

SETTINGS = ConnectionSettings("virtual")


def bytes_of(events: list[TrafficEvent], direction: TrafficDirection) -> bytes:
    return b"".join(event.data for event in events if event.direction is direction)


def texts_of(events: list[TrafficEvent]) -> list[str]:
    return [event.text for event in events if event.direction is TrafficDirection.LINE]


def run_logged(harness: SessionHarness, seconds: float) -> list[TrafficEvent]:
    """Run a session on a logged line. Return the log."""
    log = TrafficLog()
    harness.script.at(seconds, lambda: None)  # keeps the session open until then
    open_logged = logged(log.record, lambda _settings: harness.transport, harness.transport.clock)
    TrexSession(SETTINGS, harness.script, harness.reports.append, open_logged).run()
    return log.pop()


def test_sent_and_received_bytes_are_logged_in_order(harness: SessionHarness) -> None:
    harness.script.at(1.0, SetMotor(1, Drive.at(40)))
    events = run_logged(harness, 2.0)
    assert bytes_of(events, TrafficDirection.SENT) == bytes(harness.transport.sent)
    assert b"TReX1.2" in bytes_of(events, TrafficDirection.RECEIVED)
    assert [event.time for event in events] == sorted(event.time for event in events)
    assert texts_of(events)[0] == f"Opened {SETTINGS.text()}."
    assert texts_of(events)[-1] == "Closed."
    assert harness.transport.closed


def test_logging_does_not_change_session() -> None:
    def sent_bytes(run: Callable[[SessionHarness], object]) -> bytes:
        harness = SessionHarness(Board())
        run(harness)
        assert any(isinstance(report, Connected) for report in harness.reports)
        return bytes(harness.transport.sent)

    logged_run = sent_bytes(lambda harness: run_logged(harness, 2.0))
    assert logged_run == sent_bytes(lambda harness: run_for(harness, 2.0))


def test_failed_opening_of_port_is_logged() -> None:
    def refuse(_settings: PortSettings) -> VirtualTransport:
        raise PortUnavailable("It is in use.")

    log = TrafficLog()
    with pytest.raises(PortUnavailable):
        logged(log.record, refuse)(SETTINGS)
    assert texts_of(log.pop()) == ["It is in use."]


@pytest.mark.parametrize("operation", ["write", "read"])
def test_port_loss_is_logged(harness: SessionHarness, operation: str) -> None:
    log = TrafficLog()
    line = LoggingTransport(harness.transport, SETTINGS, log.record)
    harness.transport.fail = PortUnavailable("The line is gone.")
    with pytest.raises(PortUnavailable):
        line.write(b"\x81") if operation == "write" else line.read(1, 0.1)
    assert texts_of(log.pop()) == ["The line is gone."]


def test_new_line_settings_are_logged_once(harness: SessionHarness) -> None:
    log = TrafficLog()
    line = LoggingTransport(harness.transport, SETTINGS, log.record)
    other = LineSettings(57600, Detection.CRC7)
    line.reconfigure(SETTINGS.line)
    line.reconfigure(other)
    line.reconfigure(other)
    events = log.pop()
    assert [event.text for event in events] == [f"Set to {other.text()}."]
    assert events[0].settings is not None
    assert events[0].settings.line == other


def test_unread_traffic_log_is_bounded_and_counts_losses() -> None:
    log = TrafficLog()
    for number in range(60_000):
        log.record(TrafficEvent(float(number), TrafficDirection.SENT, b"\xff"))
    events = log.pop()
    assert log.lost > 0
    assert len(events) + log.lost == 60_000
    assert events[0].time == 0.0
    log.record(TrafficEvent(1.0, TrafficDirection.SENT, b"\xff"))
    assert len(log.pop()) == 1
