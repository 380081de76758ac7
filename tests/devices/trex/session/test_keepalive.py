"""Polls that prevent the serial timeout of the board while motors are armed."""

import itertools
import math
from collections.abc import Iterable

import pytest

from tests.devices.trex.session.helpers import create_harness, of_type, read_at, run_for, samples
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness
from trex_gui.core.session import Outcome
from trex_gui.core.transport.serial_port import latency_of
from trex_gui.devices.trex.client.telemetry import Control, Currents, LatchedStatus, ModeSample, Raw
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, SetAuxiliary, SetMotor, Stop
from trex_gui.devices.trex.protocol.commands import GetParameter, GetRawChannels
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import UartError
from trex_gui.devices.trex.protocol.framing import Framing
from trex_gui.devices.trex.protocol.line_settings import Detection, LineSettings, baud_rates
from trex_gui.devices.trex.protocol.parameters import ParameterKey, parameter_number
from trex_gui.devices.trex.session.messages import NotResponding, Report, Write
from trex_gui.devices.trex.session.polling import silence, survives_a_loss, too_slow


def reading_time(baud: int) -> float:
    """Return the seconds in which a session reads the whole board."""
    return 1.0 + 4.0 * 1200 / baud


def set_timeout(harness: SessionHarness, tenths: int) -> None:
    """Store and activate a serial timeout."""
    harness.board.eeprom.write("serial_timeout", tenths)
    harness.board.memory.load()


INTERVAL = 0.25  # seconds between two heartbeats


def schedule_slow_heartbeats(harness: SessionHarness, start: float, count: int) -> None:
    for number in range(count):
        harness.script.at(start + number * INTERVAL, Heartbeat())


def timeouts(reports: Iterable[Report], start: float) -> list[LatchedStatus]:
    """Return the samples after `start` that report a serial timeout."""
    latched = samples(reports, LatchedStatus)
    return [sample for sample in latched if sample.uart & UartError.TIMEOUT and sample.time > start]


@pytest.mark.parametrize(
    ("baud", "detection"), sampled(itertools.product(baud_rates(), Detection), every=9)
)
def test_100_ms_timeout_never_fires_while_armed(baud: int, detection: Detection) -> None:
    harness, settings = create_harness(baud, detection)
    set_timeout(harness, 1)
    start = reading_time(baud)
    harness.script.at(start, Arm()).at(start, SetMotor(1, Drive.at(90)))
    schedule_slow_heartbeats(harness, start, 12)
    speeds = read_at(harness, start + 3.0, lambda: harness.board.motors[0].speed)
    reports = run_for(harness, start + 3.1, settings)
    assert speeds == [90]
    assert not timeouts(reports, start + 0.5)


def test_slow_line_omits_long_polls_while_armed() -> None:
    harness, settings = create_harness(1200)
    set_timeout(harness, 1)
    start = reading_time(1200)
    harness.script.at(start, Arm())
    schedule_slow_heartbeats(harness, start, 20)
    harness.script.at(start + 5.0, Stop(1))
    reports = run_for(harness, start + 8.0, settings)
    times = [sample.time for sample in samples(reports, Raw)]
    assert not [time for time in times if start + 0.2 < time < start + 5.0]
    assert [time for time in times if time > start + 5.5], "the stop restores all polls"


def test_timeout_written_while_connected_applies_at_once() -> None:
    harness, settings = create_harness(1200)
    start = reading_time(1200)
    harness.script.at(start, Write(1, (("serial_timeout", 1),)))
    harness.script.at(start + 1.0, Arm())
    schedule_slow_heartbeats(harness, start + 1.0, 16)
    reports = run_for(harness, start + 4.0, settings)
    assert of_type(reports, Outcome)[0].error is None
    assert max(sample.time for sample in samples(reports, Raw)) <= start + 1.2


@pytest.mark.parametrize(("baud", "tenths"), [(1200, 1), (2400, 2), (115200, 1)])
def test_lost_reply_fires_timeout_only_where_predicted(baud: int, tenths: int) -> None:
    harness, settings = create_harness(baud)
    harness.transport.latency = latency_of("/dev/ttyUSB0")
    set_timeout(harness, tenths)
    start = reading_time(baud)
    harness.script.at(start, Arm()).at(start, SetMotor(1, Drive.at(90)))

    for number in range(44):
        harness.script.at(start + number * INTERVAL, Heartbeat())
        if number >= 4:
            # The time shifts from beat to beat, so that each query loses a reply.
            harness.script.at(start + (number + 0.05 * number) * INTERVAL, harness.fault(to_drop=1))
    reports = run_for(harness, start + 45 * INTERVAL, settings)
    # After three lost replies in a row, the board counts as not responding.
    responding = itertools.takewhile(lambda report: not isinstance(report, NotResponding), reports)
    fired = timeouts(responding, start + 0.9)
    survives = survives_a_loss(settings.line, tenths / 10, harness.transport.latency)
    assert not (survives and fired)
    if baud == 1200 and tenths == 1:
        assert fired
        assert not survives


@pytest.mark.parametrize("echo", [False, True])
@pytest.mark.parametrize("lead", [0.0, 0.1])
def test_reply_lost_after_arming_fires_no_timeout(lead: float, *, echo: bool) -> None:
    """`lead`: seconds from arming to the check of the safety parameters."""

    def run(seconds: float, armed_at: float = math.inf) -> SessionHarness:
        harness, settings = create_harness(echo=echo)
        harness.transport.latency = 0.3  # the latency of a network
        set_timeout(harness, 5)
        assert survives_a_loss(settings.line, 0.5, harness.transport.latency)
        if armed_at < seconds:
            harness.script.at(armed_at, Arm())
            speed = Drive.at(90)
            for setpoint in (SetMotor(1, speed), SetMotor(2, speed), SetAuxiliary(90)):
                harness.script.at(armed_at, setpoint)  # all run, so that no refresh is sent
            harness.script.at(armed_at, harness.fault(to_drop=1))
            schedule_slow_heartbeats(harness, armed_at + INTERVAL, 3)
        run_for(harness, seconds, settings)
        return harness

    query = Framing().encode(GetParameter(parameter_number(ParameterKey.SERIAL_TIMEOUT)))
    start = reading_time(19200) + 1.0
    written = run(start + 1.1).transport.written
    check = next(time for time, data in written if data == query and time > start)
    reports = run(check + 1.0, check - lead).reports
    assert not timeouts(reports, check)


def test_size_and_baud_rate_decide_which_polls_are_too_slow() -> None:
    assert too_slow(LineSettings(1200), 0.1) == {Raw}
    assert too_slow(LineSettings(1200), 0.2) == frozenset()
    assert too_slow(LineSettings(2400), 0.1) == frozenset()
    assert too_slow(LineSettings(1200), 0) == frozenset()
    # The reply has ten bytes, the next query one, each with ten bits. 15 ms are the margin.
    assert silence(LineSettings(1200), GetRawChannels()) == pytest.approx(11 / 120 + 0.015)


def test_polls_for_safety_fit_100_ms_timeout_at_every_baud_rate() -> None:
    for baud, detection, stop_bits in itertools.product(baud_rates(), Detection, (1, 2)):
        line = LineSettings(baud, detection, stop_bits)
        safety = {Currents, Control, LatchedStatus, ModeSample}
        assert safety.isdisjoint(too_slow(line, 0.1)), line.text()
