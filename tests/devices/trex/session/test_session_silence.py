"""Boards that stop responding, and their return."""

import pytest

from tests.devices.trex.session.helpers import (
    commands,
    create_harness,
    motor_commands_in,
    of_type,
    on_write,
    outcomes,
    packet,
    read_at,
    run_for,
    samples,
    timed_run,
)
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import NoReply, PortUnavailable
from trex_gui.core.session import Close, Closed
from trex_gui.devices.trex.client.telemetry import Currents
from trex_gui.devices.trex.driving.requests import Arm, SetAuxiliary, SetMotor, Stop
from trex_gui.devices.trex.protocol.commands import STOP, GetMode
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.session.messages import (
    Batch,
    Connected,
    NotResponding,
    ReadReason,
    Reload,
    Write,
    Written,
)

# --- Silence ----------------------------------------------------------------------------


@pytest.mark.parametrize(("baud", "latency"), [(9600, 0.06), (115200, 0.005), (115200, 0.06)])
def test_power_loss_is_detected_within_500_ms(baud: int, latency: float) -> None:
    harness, settings = create_harness(baud)
    harness.transport.latency = latency
    harness.script.at(2.0, harness.board.power_off).at(4.0, Close())
    timed = timed_run(harness, settings)
    (time,) = [time for time, report in timed if isinstance(report, NotResponding)]
    assert 2.0 < time < 2.5


def test_unresponsive_board_is_reported_once_and_polled_slowly(harness: SessionHarness) -> None:
    harness.script.at(1.0, harness.board.power_off)
    sent = [read_at(harness, moment, lambda: len(harness.transport.sent)) for moment in (2, 3, 8)]
    reports = run_for(harness, 8.1)
    (silent,) = of_type(reports, NotResponding)
    assert not of_type(reports[reports.index(silent) :], Batch)
    assert reports[-1] == Closed(None), "the session continues"
    times = [sample.time for sample in samples(reports, Currents)]
    assert max(times) == pytest.approx(1.0, abs=0.02), "earlier samples are delivered"
    (early,), (middle,), (late,) = sent
    assert 15 <= late - middle <= 22
    assert set(map(type, commands(harness.transport.sent[early:]))) == {GetMode}


# --- Return -----------------------------------------------------------------------------


def test_returned_board_is_read_again_within_one_second(harness: SessionHarness) -> None:
    def set_jumper() -> None:
        harness.board.mode_jumper = "rc"

    harness.script.at(1.0, harness.board.power_off).at(1.5, set_jumper)
    harness.script.at(5.0, harness.board.power_on).at(7.0, Close())
    timed = timed_run(harness, harness.client().settings)
    changes = [
        (time, type(report))
        for time, report in timed
        if isinstance(report, Connected | NotResponding)
    ]
    assert [kind for _, kind in changes] == [Connected, NotResponding, Connected]
    assert changes[2][0] - 5.0 < 1.0
    reports = [report for _, report in timed]
    first, second = of_type(reports, Connected)
    assert (first.occasion, second.occasion) == (ReadReason.OPENED, ReadReason.RETURNED)
    assert second.occasion.power_cycled
    assert (first.state.mode.is_serial, second.state.mode.is_serial) == (True, False)
    assert max(sample.time for sample in samples(reports, Currents)) > 6.9


def test_board_reconnects_after_power_loss_during_reread(harness: SessionHarness) -> None:
    harness.script.at(1.0, harness.board.power_off).at(3.0, harness.board.power_on)
    harness.script.at(5.0, harness.board.power_on)

    def power_off_at_second_signature(packet: bytes) -> None:
        if packet == b"\x81" and 3.0 < harness.line.now < 5.0:
            harness.board.power_off()

    on_write(harness, after=power_off_at_second_signature)
    run_for(harness, 7.0)
    assert len(of_type(harness.reports, NotResponding)) == 1
    assert len(of_type(harness.reports, Connected)) == 2
    assert harness.reports[-1] == Closed(None)


# --- Requests during silence ------------------------------------------------------------


def test_setpoints_for_unresponsive_board_are_discarded(harness: SessionHarness) -> None:
    harness.script.at(1.0, harness.board.power_off)
    harness.script.at(2.0, SetMotor(1, Drive.at(100))).at(2.1, SetMotor(2, Drive.at(100)))
    harness.script.at(2.9, SetAuxiliary(100))
    harness.script.at(3.0, harness.board.power_on)
    before = read_at(harness, 4.9, lambda: len(harness.transport.sent))
    harness.script.at(5.0, Arm()).at(5.0, SetMotor(1, Drive.at(90)))
    speeds = read_at(harness, 5.1, lambda: harness.board.motors[0].speed)
    run_for(harness, 5.2)
    assert len(of_type(harness.reports, Connected)) == 2
    assert motor_commands_in(harness.transport.sent[: before[0]]) == []
    assert speeds == [90], "a setpoint after the return is sent"


def test_stop_is_sent_to_unresponsive_board(harness: SessionHarness) -> None:
    harness.script.at(1.0, harness.board.power_off).at(2.0, Stop(1))
    run_for(harness, 3.0)
    assert isinstance(outcomes(harness.reports)[1].error, NoReply)
    assert motor_commands_in(harness.transport.sent).count(STOP[0]) >= 10


def test_requests_to_unresponsive_board_fail(harness: SessionHarness) -> None:
    harness.script.at(1.0, harness.board.power_off)
    harness.script.at(2.0, packet(1, GetMode())).at(2.0, Reload(2))
    run_for(harness, 4.0)
    found = outcomes(harness.reports)
    assert isinstance(found[1].error, NoReply)
    assert isinstance(found[2].error, NoReply)


def test_write_to_unresponsive_board_fails_soon_for_each_key(harness: SessionHarness) -> None:
    harness.script.at(1.0, harness.board.power_off)
    keys = [spec.key for spec in harness.board.memory.parameters.readable]
    harness.script.at(2.0, Write(1, tuple((key, 0) for key in keys)))
    harness.script.at(4.0, Close())
    (time, outcome) = next(
        (time, outcomes([report])[1])
        for time, report in timed_run(harness, harness.client().settings)
        if outcomes([report])
    )
    assert time < 3.0
    assert outcome.error is None
    assert isinstance(outcome.value, Written)
    results = outcome.value.results
    assert sorted(result.key for result in results) == sorted(keys)
    assert all(isinstance(result.error, NoReply) for result in results)


def test_port_loss_with_unresponsive_board_ends_session(harness: SessionHarness) -> None:
    lost = PortUnavailable("The port is lost.")

    def unplug() -> None:
        harness.transport.fail = lost

    harness.script.at(1.0, harness.board.power_off).at(3.0, unplug)
    assert run_for(harness, 9.0)[-1] == Closed(lost)
    assert harness.line.now < 3.5


def test_silence_while_reading_the_new_mode_is_reported_once(harness: SessionHarness) -> None:
    def change_mode() -> None:
        harness.board.mode_jumper = "analog"
        harness.board.power_cycle()

    def mute_at_second_signature(packet: bytes) -> None:
        if packet == b"\x81" and harness.line.now > 1.0:
            harness.line.faults.mute = True

    on_write(harness, after=mute_at_second_signature)
    harness.script.at(1.0, change_mode)
    reports = run_for(harness, 5.0)
    assert len(of_type(reports, NotResponding)) == 1
    assert reports[-1] == Closed(None)


def test_reload_after_power_loss_counts_as_power_cycle(harness: SessionHarness) -> None:
    harness.script.at(1.0, harness.board.power_off).at(3.0, harness.board.power_on)
    harness.script.at(3.0, Reload(1))
    run_for(harness, 4.0)
    assert of_type(harness.reports, Connected)[1].occasion.power_cycled
