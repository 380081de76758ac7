"""Board that stops responding and returns."""

import pytest

from tests.devices.trex.session.helpers import (
    commands,
    create_harness,
    motor_commands_in,
    of_type,
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


def off_and_on(harness: SessionHarness, off: float, on: float) -> None:
    """Schedule a power cut."""
    harness.script.at(off, harness.board.power_off).at(on, harness.board.power_on)


# --- Falling silent ---------------------------------------------------------------------


@pytest.mark.parametrize(("baud", "latency"), [(9600, 0.06), (115200, 0.005), (115200, 0.06)])
def test_power_loss_is_detected_within_500_ms(baud: int, latency: float) -> None:
    harness, settings = create_harness(baud)
    harness.transport.latency = latency
    harness.script.at(2.0, harness.board.power_off).at(4.0, Close())
    (at,) = [at for at, report in timed_run(harness, settings) if isinstance(report, NotResponding)]
    assert 2.0 < at < 2.5


def test_unresponsive_board_is_reported_once_and_polled_slowly(harness: SessionHarness) -> None:
    harness.script.at(1.0, harness.board.power_off)
    sent = [read_at(harness, moment, lambda: len(harness.transport.sent)) for moment in (2, 3, 8)]
    reports = run_for(harness, 8.1)
    (silent,) = of_type(reports, NotResponding)
    assert not of_type(reports[reports.index(silent) :], Batch)
    assert reports[-1] == Closed(None), "the session goes on"
    times = [one.time for one in samples(reports, Currents)]
    assert max(times) == pytest.approx(1.0, abs=0.02), "what came before is delivered"
    (early,), (middle,), (late,) = sent
    assert 15 <= late - middle <= 22
    assert set(map(type, commands(harness.transport.sent[early:]))) == {GetMode}


def test_single_lost_reply_keeps_board_responding(harness: SessionHarness) -> None:
    for moment in (1.0, 1.5, 2.0, 2.5):
        harness.script.at(moment, harness.fault(to_drop=1))
    run_for(harness, 3.0)
    assert not of_type(harness.reports, NotResponding)
    assert of_type(harness.reports, Batch)[-1].counters.missing == 4
    assert not motor_commands_in(harness.transport.sent)


# --- Coming back ------------------------------------------------------------------------


def test_returning_board_is_found_within_one_second_and_read_again(harness: SessionHarness) -> None:
    def set_jumper() -> None:
        harness.board.mode_jumper = "rc"

    harness.script.at(1.0, harness.board.power_off).at(1.5, set_jumper)
    harness.script.at(5.0, harness.board.power_on).at(7.0, Close())
    timed = timed_run(harness, harness.client().settings)
    seen = [(at, one) for at, one in timed if isinstance(one, Connected | NotResponding)]
    assert [type(one) for _, one in seen] == [Connected, NotResponding, Connected]
    assert seen[2][0] - 5.0 < 1.0
    reports = [report for _, report in timed]
    first, second = of_type(reports, Connected)
    assert (first.occasion, second.occasion) == (ReadReason.OPENED, ReadReason.RETURNED)
    assert second.occasion.power_cycled
    assert (first.state.mode.is_serial, second.state.mode.is_serial) == (True, False)
    assert max(one.time for one in samples(reports, Currents)) > 6.9


def test_board_reconnects_after_power_loss_during_reread(harness: SessionHarness) -> None:
    off_and_on(harness, 1.0, 3.0)
    harness.script.at(5.0, harness.board.power_on)
    send = harness.transport.write

    def fail_at_the_second_signature(data: bytes) -> None:
        send(data)
        if data == b"\x81" and 3.0 < harness.line.now < 5.0:
            harness.board.power_off()

    harness.transport.write = fail_at_the_second_signature  # type: ignore[method-assign] # a knob
    run_for(harness, 7.0)
    assert len(of_type(harness.reports, NotResponding)) == 1
    assert len(of_type(harness.reports, Connected)) == 2
    assert harness.reports[-1] == Closed(None)


# --- Requests meanwhile -----------------------------------------------------------------


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
    assert speeds == [90], "what comes after the return is sent"


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
    (at, outcome) = next(
        (at, outcomes([report])[1])
        for at, report in timed_run(harness, harness.client().settings)
        if outcomes([report])
    )
    assert at < 3.0
    assert outcome.error is None
    assert isinstance(outcome.value, Written)
    results = outcome.value.results
    assert sorted(one.key for one in results) == sorted(keys)
    assert all(isinstance(one.error, NoReply) for one in results)


def test_port_loss_with_unresponsive_board_ends_session(harness: SessionHarness) -> None:
    gone = PortUnavailable("The line is gone.")

    def unplug() -> None:
        harness.transport.fail = gone

    harness.script.at(1.0, harness.board.power_off).at(3.0, unplug)
    assert run_for(harness, 9.0)[-1] == Closed(gone)
    assert harness.line.now < 3.5


def test_silence_while_reading_new_mode_is_reported(harness: SessionHarness) -> None:
    def rearrange() -> None:
        harness.board.mode_jumper = "analog"
        harness.board.power_cycle()

    send = harness.transport.write

    def die_at_the_second_signature(data: bytes) -> None:
        send(data)
        harness.line.faults.mute = harness.line.faults.mute or (
            data == b"\x81" and harness.line.now > 1.0
        )

    harness.transport.write = die_at_the_second_signature  # type: ignore[method-assign] # a knob
    harness.script.at(1.0, rearrange)
    reports = run_for(harness, 5.0)
    assert len(of_type(reports, NotResponding)) == 1
    assert reports[-1] == Closed(None)


def test_reload_after_power_loss_counts_as_power_cycle(harness: SessionHarness) -> None:
    off_and_on(harness, 1.0, 3.0)
    harness.script.at(3.0, Reload(1))
    run_for(harness, 4.0)
    assert [one.occasion for one in of_type(harness.reports, Connected)][1].power_cycled
