"""Closed ports, outcomes of requests and stopped motors at the end of a session."""

import logging
from collections.abc import Callable
from itertools import count

import pytest
from hypothesis import given
from hypothesis import strategies as st

from tests.devices.trex.session.helpers import (
    commands,
    create_harness,
    is_stopped,
    latch_fault,
    motor_commands_in,
    of_type,
    on_write,
    outcomes,
    packet,
    read_at,
    run_for,
    samples,
)
from tests.support.matrix import examples
from tests.support.virtual import SessionHarness
from trex_gui.core.errors import PortUnavailable, StudioError
from trex_gui.core.session import Close, Closed
from trex_gui.core.transport.serial_port import latency_of
from trex_gui.devices.trex.client.telemetry import LatchedStatus
from trex_gui.devices.trex.driving.requests import Arm, SetAuxiliary, SetMotor, Stop
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.commands import (
    STOP,
    DriveMotor,
    GetMode,
    GetParameter,
    GetSignature,
    GetStatus,
)
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.flags import Status
from trex_gui.devices.trex.session.messages import (
    Connected,
    ReadReason,
    Reload,
    Request,
    SendPacket,
    Write,
    Written,
)
from trex_gui.devices.trex.session.open_line import SampleBatcher
from trex_gui.devices.trex.simulator.firmware import Board
from trex_gui.devices.trex.simulator.line import BoardStation
from trex_gui.devices.trex.simulator.motors import MotorDirection

LOST = PortUnavailable("The port is lost.")


# --- Closing ----------------------------------------------------------------------------


@pytest.mark.parametrize(
    "setpoint",
    [SetMotor(1, Drive.at(100)), SetMotor(2, Drive.at(-100), accelerate=True), SetAuxiliary(100)],
    ids=str,
)
def test_driven_motors_are_stopped_on_close(harness: SessionHarness, setpoint: Request) -> None:
    harness.script.at(1.0, setpoint)
    assert run_for(harness, 2.0)[-1] == Closed(None, may_move=False)
    last = [*STOP, GetStatus(), *STOP, GetStatus(), GetSignature()]
    assert commands(harness.transport.sent)[-7:] == last
    assert is_stopped(harness.board)


def test_board_of_another_model_does_not_confirm_the_stop(harness: SessionHarness) -> None:
    def replace_board() -> None:
        harness.line.stations = (BoardStation(Board("trexjr", "1.2"), harness.line),)

    harness.script.at(1.0, SetMotor(1, Drive.at(100))).at(1.5, replace_board)
    assert run_for(harness, 1.5)[-1] == Closed(None, may_move=True)


def test_stop_is_transmitted_before_port_is_closed() -> None:
    harness, settings = create_harness(1200)
    harness.script.at(5.0, SetMotor(1, Drive.at(100)))
    run_for(harness, 6.0, settings)
    assert harness.line.backlog == 0.0
    assert harness.board.motors[0].direction is MotorDirection.BRAKE


def test_close_does_not_wait_for_queued_requests(harness: SessionHarness) -> None:
    keys = [spec.key for spec in harness.board.memory.parameters.readable]
    harness.script.at(1.0, Write(1, tuple((key, 1) for key in keys)))
    harness.script.at(1.0, Reload(2)).at(1.0, packet(3, GetMode()))
    reports = run_for(harness, 1.05)
    assert harness.line.now < 1.15
    assert reports[-1] == Closed(None)
    found = outcomes(reports)
    assert sorted(found) == [1, 2, 3]
    assert found[1].error is None  # a write has a result for each key
    assert all(
        "closed before the request was complete" in str(found[number].error) for number in (2, 3)
    )


@pytest.mark.parametrize("delay", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("drive", [True, False])
def test_unanswered_stop_delays_close_by_less_than_a_second(
    harness: SessionHarness, delay: float, *, drive: bool
) -> None:
    """The window waits for only one second. A thread that runs longer would still use the port."""
    harness.transport.latency = latency_of("/dev/ttyUSB0")
    if drive:
        harness.script.at(0.9, SetMotor(1, Drive.at(60)))
    harness.script.at(1.0, harness.fault(mute=True)).at(1.1, Stop(1))
    harness.script.at(1.1 + delay, Close())
    reports = harness.run()
    assert harness.line.now < 1.1 + delay + 0.9
    assert outcomes(reports)[1].error is not None
    assert of_type(reports, Closed) == [Closed(None, may_move=drive)]
    motor = harness.board.motors[0]
    assert (motor.target_direction.value, motor.target_speed) == ("brake", 127)


def test_unanswered_stop_is_confirmed_by_stop_on_close(harness: SessionHarness) -> None:
    harness.script.at(1.0, SetMotor(1, Drive.at(60))).at(1.1, harness.fault(mute=True))
    harness.line.timeline.at(1.35, harness.fault(mute=False))
    harness.script.at(1.1, Stop(1))
    assert run_for(harness, 1.2)[-1] == Closed(None, may_move=False)
    assert outcomes(harness.reports)[1].error is None


# --- Line loss --------------------------------------------------------------------------

REQUESTS: list[Request] = [
    packet(1, GetMode()),
    packet(2, GetParameter(7)),
    Write(3, (("serial_timeout", 4), ("motor_mode", 1), ("nonsense", 1))),
    SetMotor(1, Drive.at(50)),
    Stop(4),
    Reload(5),
    SetAuxiliary(20),
    Write(6, (), ((CalibrationKey.RC_CHANNEL_1, Calibration(2400, 3750, 5000, 75)),)),
    packet(7, DriveMotor(2, Drive.at(9))),
    Stop(8),
]


def failing_harness(calls: int, failure: Exception, requests: list[Request]) -> SessionHarness:
    """Return a harness whose transport fails after some calls."""
    harness, calls_left = SessionHarness(Board()), count(calls, -1)

    def limited(call: Callable[..., object]) -> Callable[..., object]:
        def limited_call(*arguments: object) -> object:
            if next(calls_left) <= 0:
                raise failure
            return call(*arguments)

        return limited_call

    for name in ("write", "read", "discard"):
        setattr(harness.transport, name, limited(getattr(harness.transport, name)))
    for number, request in enumerate(requests):
        harness.script.at(0.5 + number * 0.03, request)
    harness.script.at(2.0, Close())
    return harness


@examples(25)
@given(calls=st.integers(0, 700), requests=st.permutations(REQUESTS))
def test_each_request_has_one_outcome_when_port_is_lost(
    calls: int, requests: list[Request]
) -> None:
    harness = failing_harness(calls, LOST, requests)
    reports = harness.run()
    requested = {
        request.id
        for request in requests
        if isinstance(request, SendPacket | Stop | Write | Reload)
    }
    if harness.line.now > 1.0:  # an earlier end leaves requests in the inbox
        assert set(outcomes(reports)) == requested
    assert set(outcomes(reports)) <= requested
    (closed,) = of_type(reports, Closed)
    assert closed.error is LOST
    assert reports[-1] is closed
    assert harness.transport.closed


def test_requests_fail_with_error_of_lost_port(harness: SessionHarness) -> None:
    def unplug() -> None:
        harness.transport.fail = LOST

    harness.script.at(1.0, unplug).at(1.0, packet(1, GetMode())).at(1.0, Write(2)).at(1.0, Stop(3))
    reports = run_for(harness, 2.0)
    assert [outcomes(reports)[number].error for number in (1, 2, 3)] == [LOST] * 3


def test_status_read_before_line_loss_is_reported(harness: SessionHarness) -> None:
    harness.script.at(1.0, SetMotor(1, Drive.at(1)))  # the session has to send a stop at the end
    harness.script.at(1.2, lambda: latch_fault(harness.board, 1))

    def lose_line_after_status(_packet: bytes) -> None:
        if not harness.board.serial.status and harness.line.now > 1.2:
            harness.transport.fail = LOST

    on_write(harness, before=lose_line_after_status)
    faults = samples(run_for(harness, 2.0), LatchedStatus)
    assert Status.MOTOR1_FAULT in [sample.status for sample in faults]


# --- Internal errors --------------------------------------------------------------------


@pytest.mark.parametrize("calls", [0, 150])
def test_internal_error_ends_session_and_closes_port(
    calls: int, caplog: pytest.LogCaptureFixture
) -> None:
    harness = failing_harness(calls, RuntimeError("a bug"), [])
    reports = harness.run()
    closed = reports[-1]
    assert isinstance(closed, Closed)
    assert isinstance(closed.error, StudioError)
    assert "the line session failed" in caplog.text
    assert "Traceback" in caplog.text
    assert "Internal error" in str(closed.error)
    assert "a bug" in str(closed.error)
    assert harness.transport.closed


def test_port_is_closed_when_last_samples_cannot_be_sent(
    harness: SessionHarness, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    def fail(*_: object) -> None:
        raise RuntimeError("no receiver")

    harness.script.at(1.0, lambda: monkeypatch.setattr(SampleBatcher, "flush", fail))
    with caplog.at_level(logging.CRITICAL):
        reports = harness.run()
    assert isinstance(reports[-1], Closed)
    assert harness.transport.closed


def test_internal_error_stops_driven_motors(
    harness: SessionHarness, caplog: pytest.LogCaptureFixture
) -> None:
    def fail() -> None:
        raise RuntimeError("a bug")

    harness.script.at(1.0, SetMotor(1, Drive.at(100))).at(1.5, fail)
    with caplog.at_level(logging.CRITICAL):
        reports = run_for(harness, 2.0)
    assert isinstance(reports[-1], Closed)
    assert harness.transport.closed
    assert motor_commands_in(harness.transport.sent)[-2:] == list(STOP)
    assert harness.board.motors[0].direction is MotorDirection.BRAKE


@pytest.mark.parametrize(
    "request_",
    [packet(1, GetMode()), Reload(1), Write(1, (("serial_timeout", 1),)), Stop(1)],
    ids=str,
)
def test_internal_error_completes_the_current_request(
    harness: SessionHarness, request_: Request, caplog: pytest.LogCaptureFixture
) -> None:
    def fail() -> None:
        harness.transport.fail = RuntimeError("a bug")

    harness.script.at(1.0, fail).at(1.0, request_)
    with caplog.at_level(logging.CRITICAL):
        reports = run_for(harness, 2.0)
    assert set(outcomes(reports)) == {1}
    assert isinstance(reports[-1], Closed)


# --- Outcomes ---------------------------------------------------------------------------


def test_each_kind_of_request_gets_an_outcome(harness: SessionHarness) -> None:
    harness.script.at(1.0, packet(1, GetParameter(0))).at(1.0, Reload(2)).at(1.0, Stop(3))
    harness.script.at(1.0, Write(4, (("serial_timeout", 9),)))
    reports = run_for(harness, 2.0)
    found = outcomes(reports)
    assert sorted(found) == [1, 2, 3, 4]
    assert all(outcome.error is None for outcome in found.values())
    assert found[1].value == b"\x07"
    assert found[2].value is None
    written = found[4].value
    assert isinstance(written, Written)
    assert [(result.key, result.stored) for result in written.results] == [("serial_timeout", 9)]


def test_reload_is_reported_before_its_outcome(harness: SessionHarness) -> None:
    harness.script.at(1.0, Reload(2))
    reports = run_for(harness, 2.0)
    reloaded = of_type(reports, Connected)[1]
    assert reloaded.occasion is ReadReason.RELOADED
    assert reports.index(reloaded) < reports.index(outcomes(reports)[2])


def test_unanswered_request_gets_an_outcome(harness: SessionHarness) -> None:
    harness.script.at(1.1, packet(2, GetMode()))
    harness.script.at(1.2, packet(3, GetParameter(0x60))).at(1.4, packet(4, GetMode()))
    found = outcomes(run_for(harness, 2.0))
    assert "No reply to 9F 60" in str(found[3].error)
    assert (found[2].error, found[4].error) == (None, None)


@pytest.mark.parametrize("setpoint", [SetAuxiliary(300), SetMotor(3, Drive.at(5))], ids=str)
def test_invalid_setpoint_has_no_effect_even_on_noisy_line(
    harness: SessionHarness, setpoint: Request
) -> None:
    harness.script.at(1.0, Arm()).at(1.0, SetMotor(1, Drive.at(50))).at(1.1, setpoint)
    harness.script.at(1.2, harness.fault(to_drop=1))
    speeds = read_at(harness, 1.5, lambda: harness.board.motors[0].speed)
    assert run_for(harness, 1.6)[-1] == Closed(None)
    assert speeds == [50]
