"""Restarts while motors run. No reply reports them."""

from collections.abc import Callable
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

FREE, LOADED = 0.0, 3.0  # current in A that the load adds to the friction
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
    seconds: float, baud: int = 19200, model: str = "trex", *, ramp: int = 0
) -> tuple[SessionHarness, list[tuple[float, object]]]:
    """Return a harness and the steps of a script that drives motor 1 from 2 s on."""
    harness, _ = create_harness(baud, model=model)
    harness.board.eeprom.write("motor1_acceleration", ramp)
    harness.board.power_cycle()
    harness.transport.latency = latency_of("/dev/ttyUSB0")
    setpoint = SetMotor(1, Drive.at(38), accelerate=bool(ramp))
    steps: list[tuple[float, object]] = [(2.0, Arm()), (2.0, setpoint)]
    steps += [(2.0 + beat * 0.1, Heartbeat()) for beat in range(round(seconds * 10))]
    return harness, steps


@pytest.mark.parametrize(("gap", "moment", "baud", "load", "model"), sampled(CASES, every=5))
def test_restart_while_driving_disarms_the_motors(
    gap: float, moment: float, baud: int, load: float, model: str
) -> None:
    harness, steps = driving(3.5, baud, model)
    harness.board.physics[0].load = load
    steps += [(2.0 + moment, harness.board.power_off), (2.0 + moment + gap, harness.board.power_on)]
    schedule(harness, steps)
    stopped = read_at(harness, 5.4, lambda: is_stopped(harness.board))
    reports = run_for(harness, 5.5, create_harness(baud)[1])
    reasons = [stop.reason for stop in of_type(reports, MotorsStopped) if stop.confirmed]
    assert reasons == [ErrorCode.MAY_HAVE_RESTARTED] or of_type(reports, NotResponding)
    assert stopped == [True]


@pytest.mark.parametrize("ramp", [3, 20])
def test_restart_during_a_ramp_leaves_the_motors_stopped(ramp: int) -> None:
    harness, steps = driving(5.0, ramp=ramp)
    schedule(harness, [*steps, (5.0, harness.board.power_cycle)])
    stopped = read_at(harness, 5.5, lambda: is_stopped(harness.board))
    reports = run_for(harness, 6.0)
    assert stopped == [True]
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
    last = of_type(run_for(harness, 5.0), Connected)[-1]
    assert (last.occasion, last.may_move) == (ReadReason.RESTARTED, False)
    assert stopped == [True]


@pytest.mark.parametrize(
    "disturbances",
    [
        lambda harness: [
            (3.0 + step * 0.12, partial(harness.board.force_current, 1, current))
            for step, current in enumerate([0.48, 0.15] * 7)
        ],
        # A motor that turns downhill may draw no current for any time.
        lambda harness: [
            (3.0, partial(harness.board.force_current, 1, 0.0)),
            (3.6, partial(harness.board.force_current, 1, None)),
        ],
        lambda harness: [(3.0, harness.fault(to_drop=1))],
    ],
    ids=["fluctuating current", "no current", "lost reply"],
)
def test_disturbance_is_not_taken_for_a_restart(
    disturbances: Callable[[SessionHarness], list[tuple[float, object]]],
) -> None:
    harness, steps = driving(3.0)
    schedule(harness, steps + disturbances(harness))
    speed = read_at(harness, 4.9, lambda: harness.board.motors[0].speed)
    assert not of_type(run_for(harness, 5.0), MotorsStopped)
    assert speed == [38]


def schedule(harness: SessionHarness, steps: list[tuple[float, object]]) -> None:
    for moment, step in sorted(steps, key=lambda timed: timed[0]):
        harness.script.at(moment, step)  # type: ignore[arg-type] # requests and functions
