"""Restarts of a board while its motors run, which no reply reports."""

from functools import partial

import pytest

from tests.devices.trex.session.helpers import create_harness, is_stopped, of_type, read_at, run_for
from tests.support.matrix import sampled
from tests.support.virtual import SessionHarness
from trex_gui.core.transport.serial_port import latency_of
from trex_gui.devices.trex.driving.requests import Arm, Heartbeat, MotorsStopped, SetMotor
from trex_gui.devices.trex.protocol.driving import Drive
from trex_gui.devices.trex.protocol.errors import ErrorCode
from trex_gui.devices.trex.session.messages import Connected, NotResponding, ReadReason

FREE, LOADED = 0.0, 3.0  # load in A beyond the friction
CASES = [
    # seconds without power, moment, baud rate, load, model
    (0.0, 1.00, 19200, FREE, "trex"),
    (0.0, 1.37, 115200, LOADED, "trex"),
    (0.0, 0.62, 57600, FREE, "trexjr"),
    (0.0, 0.93, 9600, FREE, "trex"),
    (0.001, 1.11, 19200, LOADED, "trex"),
    (0.002, 1.48, 115200, FREE, "trexjr"),
    (0.005, 0.71, 19200, FREE, "trex"),
    (0.01, 1.83, 38400, LOADED, "trex"),
    (0.02, 1.25, 19200, FREE, "trexjr"),
    (0.05, 0.87, 4800, FREE, "trex"),
    (0.07, 1.52, 115200, LOADED, "trex"),
    (0.1, 1.03, 19200, FREE, "trex"),
    (0.15, 1.19, 57600, LOADED, "trexjr"),
    (0.2, 1.66, 19200, FREE, "trex"),
]


def driving(
    seconds: float, baud: int = 19200, model: str = "trex", *, begin: float = 2.0, ramp: int = 0
) -> tuple[SessionHarness, list[tuple[float, object]]]:
    """Return a stage whose motor is driven along a ramp, and the steps of its script."""
    harness, _ = create_harness(baud, model=model)
    harness.board.eeprom.write("motor1_acceleration", ramp)
    harness.board.power_cycle()
    harness.transport.latency = latency_of("/dev/ttyUSB0")
    setpoint = SetMotor(1, Drive.at(38), accelerate=bool(ramp))
    steps: list[tuple[float, object]] = [(begin, Arm()), (begin, setpoint)]
    steps += [(begin + beat * 0.1, Heartbeat()) for beat in range(round(seconds * 10))]
    return harness, steps


@pytest.mark.parametrize(("gap", "moment", "baud", "load", "model"), sampled(CASES, every=5))
def test_restart_while_driving_is_found_and_disarms(
    gap: float, moment: float, baud: int, load: float, model: str
) -> None:
    harness, steps = driving(3.5, baud, model)
    harness.board.physics[0].load = load
    steps += [(2.0 + moment, harness.board.power_off), (2.0 + moment + gap, harness.board.power_on)]
    plan(harness, steps)
    rest = read_at(harness, 5.4, lambda: is_stopped(harness.board))
    reports = run_for(harness, 5.5, create_harness(baud)[1])
    found = [one for one in of_type(reports, MotorsStopped) if one.confirmed]
    is_said = [one.reason for one in found] == [ErrorCode.MAY_HAVE_RESTARTED]
    assert is_said or of_type(reports, NotResponding)
    assert rest == [True]


@pytest.mark.parametrize("ramp", [3, 20])
def test_restart_on_a_ramp_starts_no_motor_again(ramp: int) -> None:
    harness, steps = driving(5.0, ramp=ramp)
    plan(harness, [*steps, (5.0, harness.board.power_cycle)])
    rest = read_at(harness, 5.5, lambda: is_stopped(harness.board))
    reports = run_for(harness, 6.0)
    assert rest == [True]
    assert of_type(reports, MotorsStopped)[0].reason is ErrorCode.MAY_HAVE_RESTARTED


def test_mode_change_stops_motors_and_drops_setpoints(harness: SessionHarness) -> None:

    def restart() -> None:
        harness.board.eeprom.write("channel_input_source", 1)
        harness.board.power_cycle()

    harness.script.at(1.0, Arm())
    for step in range(60):
        if step == 10:
            harness.script.at(1.5, restart)
        harness.script.at(1.0 + step / 20, SetMotor(1, Drive.at(60 + step % 40)))
    stopped = read_at(harness, 4.5, lambda: is_stopped(harness.board))
    reports = of_type(run_for(harness, 5.0), Connected)
    assert [(one.occasion, one.may_move) for one in reports][-1] == (ReadReason.RESTARTED, False)
    assert stopped == [True]


def test_current_that_comes_and_goes_is_no_restart() -> None:
    harness, steps = driving(3.0)
    force = harness.board.force_current
    steps += [
        (3.0 + step * 0.12, partial(force, 1, 0.15 if step % 2 else 0.48)) for step in range(14)
    ]
    plan(harness, steps)
    assert not of_type(run_for(harness, 4.9), MotorsStopped)


def test_motor_without_current_keeps_running() -> None:
    """Downhill, no current flows for an unknown time."""
    harness, steps = driving(3.0)
    force = harness.board.force_current
    steps += [(3.0, lambda: force(1, 0.0)), (3.6, lambda: force(1, None))]
    plan(harness, steps)
    speed = read_at(harness, 4.9, lambda: harness.board.motors[0].speed)
    assert not of_type(run_for(harness, 5.0), MotorsStopped)
    assert speed == [38]


def test_lost_reply_is_no_restart() -> None:
    harness, steps = driving(3.0)
    plan(harness, [*steps, (3.0, harness.fault(to_drop=1))])
    speed = read_at(harness, 4.9, lambda: harness.board.motors[0].speed)
    assert not of_type(run_for(harness, 5.0), MotorsStopped)
    assert speed == [38]


def plan(harness: SessionHarness, steps: list[tuple[float, object]]) -> None:
    for at, step in sorted(steps, key=lambda one: one[0]):
        harness.script.at(at, step)  # type: ignore[arg-type] # requests and functions
