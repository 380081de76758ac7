"""Keep-alive of the serial timeout while motors are armed."""

import itertools
import math

import pytest

from tests.devices.trex.session.helpers import create_harness, of_type, read_at, run_for, samples
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness
from trex_gui.core.session import Outcome
from trex_gui.core.transport.serial_port import latency_of
from trex_gui.devices.trex.client.telemetry import Control, Currents, LatchedStatus, ModeSample, Raw
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, SetMotor, Stop
from trex_gui.devices.trex.protocol.commands import GetParameter, GetRawChannels
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.framing import Framing
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameter_number
from trex_gui.devices.trex.session.messages import NotResponding, Write
from trex_gui.devices.trex.session.polling import silence, survives_a_loss, too_slow


def opening(baud: int) -> float:
    """Seconds in which everything is read."""
    return 1.0 + 4.0 * 1200 / baud


def set_timeout(harness: SessionHarness, tenths: int) -> None:
    """Store and activate a serial timeout."""
    harness.board.eeprom.write("serial_timeout", tenths)
    harness.board.memory.load()


INTERVAL = 0.25
"""Seconds between two heartbeats."""


@pytest.mark.parametrize(
    ("baud", "detection"), sampled(itertools.product(baud_rates(), Detection), every=9)
)
def test_100_ms_timeout_never_fires_while_armed(baud: int, detection: Detection) -> None:
    harness, settings = create_harness(baud, detection)
    set_timeout(harness, 1)
    start = opening(baud)
    harness.script.at(start, Arm()).at(start, SetMotor(1, Drive.at(90)))
    for number in range(12):
        harness.script.at(start + number * INTERVAL, Heartbeat())
    speeds = read_at(harness, start + 3.0, lambda: harness.board.motors[0].speed)
    reports = run_for(harness, start + 3.1, settings)
    assert speeds == [90]
    fired = [
        one.time
        for one in samples(reports, LatchedStatus)
        if one.uart & UartError.TIMEOUT and one.time > start + 0.5
    ]
    assert fired == []


def test_slow_line_omits_long_polls_while_armed() -> None:
    harness, settings = create_harness(1200)
    set_timeout(harness, 1)
    start = opening(1200)
    harness.script.at(start, Arm())
    for number in range(20):
        harness.script.at(start + number * INTERVAL, Heartbeat())
    harness.script.at(start + 5.0, Stop(1))
    reports = run_for(harness, start + 8.0, settings)
    seen = [one.time for one in samples(reports, Raw)]
    assert [time for time in seen if start + 0.2 < time < start + 5.0] == []
    assert [time for time in seen if time > start + 5.5] != [], "all is asked again after the stop"


def test_timeout_written_while_connected_applies_at_once() -> None:
    harness, settings = create_harness(1200)
    start = opening(1200)
    harness.script.at(start, Write(1, (("serial_timeout", 1),)))
    harness.script.at(start + 1.0, Arm())
    for number in range(16):
        harness.script.at(start + 1.0 + number * INTERVAL, Heartbeat())
    reports = run_for(harness, start + 4.0, settings)
    assert of_type(reports, Outcome)[0].error is None
    assert [one for one in samples(reports, Raw) if one.time > start + 1.2] == []


@pytest.mark.parametrize(("baud", "tenths"), [(1200, 1), (2400, 2), (115200, 1)])
def test_lost_reply_fires_timeout_only_where_predicted(baud: int, tenths: int) -> None:
    harness, settings = create_harness(baud)
    harness.transport.latency = latency_of("/dev/ttyUSB0")
    set_timeout(harness, tenths)
    start = opening(baud)
    harness.script.at(start, Arm()).at(start, SetMotor(1, Drive.at(90)))

    for number in range(44):
        harness.script.at(start + number * INTERVAL, Heartbeat())
        if number >= 4:
            # At another query each time, so that each query is hit.
            harness.script.at(start + (number + 0.05 * number) * INTERVAL, harness.fault(to_drop=1))
    reports = run_for(harness, start + 45 * INTERVAL, settings)
    # Three lost replies in a row would make the board silent.
    replying = itertools.takewhile(lambda report: not isinstance(report, NotResponding), reports)
    fired = [
        one
        for one in samples(replying, LatchedStatus)
        if one.uart & UartError.TIMEOUT and one.time > start + 0.9
    ]
    survives = survives_a_loss(settings.line, tenths / 10, harness.transport.latency)
    assert not (survives and fired)
    if baud == 1200 and tenths == 1:  # nobody is promised what cannot be kept
        assert fired
        assert not survives


@pytest.mark.parametrize("ahead", [0.0, 0.1])
def test_reply_lost_after_arming_lets_no_timeout_fire(ahead: float) -> None:
    """The first reply and the safety check are included."""

    def run(seconds: float, armed_at: float = math.inf) -> SessionHarness:
        harness, settings = create_harness()
        harness.transport.latency = 0.3  # as over a network
        set_timeout(harness, 5)
        assert survives_a_loss(settings.line, 0.5, harness.transport.latency)
        if armed_at < seconds:
            lose_a_byte = harness.fault(to_drop=1)
            harness.script.at(armed_at, Arm()).at(armed_at, SetMotor(1, Drive.at(90)))
            harness.script.at(armed_at, lose_a_byte)
            for beat in range(1, 4):
                harness.script.at(armed_at + beat * INTERVAL, Heartbeat())
        run_for(harness, seconds, settings)
        return harness

    query = Framing().encode(GetParameter(parameter_number(ParameterKey.SERIAL_TIMEOUT)))
    start = opening(19200) + 1.0
    written = run(start + 1.1).transport.written
    check = next(time for time, data in written if data == query and time > start)
    reports = run(check + 1.0, check - ahead).reports
    fired = [
        one.time - check
        for one in samples(reports, LatchedStatus)
        if one.uart & UartError.TIMEOUT and one.time > check
    ]
    assert fired == []


def test_too_slow_polls_follow_from_size_and_baud_rate() -> None:
    assert too_slow(LineSettings(1200), 0.1) == {Raw}
    assert too_slow(LineSettings(1200), 0.2) == frozenset()
    assert too_slow(LineSettings(2400), 0.1) == frozenset()
    assert too_slow(LineSettings(1200), 0) == frozenset()
    # Ten bytes of the reply and one of the next query, ten bits each, and the margin.
    assert silence(LineSettings(1200), GetRawChannels()) == pytest.approx(11 / 120 + 0.015)


def test_every_rate_leaves_polls_that_fit_100_ms_timeout() -> None:
    for baud, detection, stop_bits in itertools.product(baud_rates(), Detection, (1, 2)):
        line = LineSettings(baud, detection, stop_bits)
        left_out = too_slow(line, 0.1)
        needed = {Currents, Control, LatchedStatus, ModeSample}
        assert needed.isdisjoint(left_out), line.text()
