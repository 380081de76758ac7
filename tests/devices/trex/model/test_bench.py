"""Bench tests with a simulated board."""

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.conftest import STOPPED, motor
from tests.devices.trex.model.device_setup import DeviceSetup
from tests.support.pages.motors import signed_speeds
from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.devices.trex.bench.run import End, Plan, Profile, Run, Shape, figures
from trex_gui.devices.trex.model.bench import Bench, Phase
from trex_gui.devices.trex.model.device import Device
from trex_gui.ui.runtime import now

STEP = 0.02  # seconds between two setpoints of a profile
MAX_DELAY = STEP + 0.01  # the board updates its outputs every 0.01 s (CMD10 0xC4)


class BenchSetup(DeviceSetup):
    """Bench of a device that is connected to a simulated board."""

    def __init__(self, qtbot: QtBot, simulator: SimulatedDevice) -> None:
        super().__init__(qtbot, simulator)
        self.bench = Bench(self.device)
        self.finished: list[Run] = []
        self.bench.finished.connect(self.finished.append)

    def connect(self, url: str = "") -> None:
        super().connect(url)
        self.until(lambda: self.device.telemetry.motor_currents is not None)

    def plan(self, shape: Shape = Shape.STEP, **values: Any) -> None:
        profile: dict[str, Any] = {"speed": 60, "duration": 1.0, "period": 1.0, "shape": shape}
        profile |= {name: values.pop(name) for name in tuple(values) if name in profile}
        self.bench.set_plan(Plan(profile=Profile(**profile), **values))

    def arm(self) -> None:
        self.device.motors.arm()
        assert self.device.motors.armed

    def store(self, key: str, wire: int) -> None:
        """Write a parameter, and wait for the end."""
        self.device.parameters.edit(key, wire)
        self.write()

    def run(self) -> Run:
        """Run a bench test to its end."""
        assert self.bench.start(), self.bench.blocker
        return self.result()

    def result(self) -> Run:
        self.until(lambda: self.bench.phase is Phase.IDLE)
        return self.finished[-1]

    def speed(self, motor: int = 1) -> int:
        """Return the signed speed of the simulated output. 0 while braking."""
        return signed_speeds(self.simulator)[motor - 1]

    def brakes(self, number: int = 1) -> bool:
        return motor(self.simulator, number) == STOPPED


@pytest.fixture
def connected(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[BenchSetup]:
    setup = BenchSetup(qtbot, quick_simulator)
    setup.connect()
    yield setup
    setup.shut_down()


@pytest.fixture
def armed(connected: BenchSetup) -> BenchSetup:
    connected.arm()
    return connected


# --- Blockers ---------------------------------------------------------------------------


def test_bench_needs_a_connected_board(qtbot: QtBot) -> None:
    bench = Bench(Device())
    assert "Connect to a board" in bench.blocker
    assert not bench.start()
    assert bench.phase is Phase.IDLE


@pytest.mark.parametrize(("model", "default"), [("trex", 15.0), ("trexjr", 4.0)])
def test_abort_current_follows_the_model(
    qtbot: QtBot, start_simulator: StartSimulator, model: str, default: float
) -> None:
    setup = BenchSetup(qtbot, start_simulator("--unpaced", "--model", model))
    setup.connect()
    second = Bench(setup.device)
    assert setup.bench.plan.abort_current == second.plan.abort_current == default
    second.set_plan(replace(second.plan, abort_current=2.0))
    setup.device.state_changed.emit()
    assert second.plan.abort_current == 2.0, "a typed value is retained"
    setup.shut_down()


def test_running_motors_block_the_test(armed: BenchSetup) -> None:
    armed.device.motors.set_speed(2, 20)
    assert "motor 2 +20" in armed.bench.blocker
    assert not armed.bench.start()


def test_joint_mode_blocks_the_test(connected: BenchSetup) -> None:
    connected.store("motor_mode", 1)
    connected.device.record_power_cycled()
    connected.arm()
    assert "joint mode" in connected.bench.blocker


# --- Setpoints --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("shape", "motor"),
    [(Shape.RAMP, 1), (Shape.SINE, 2), (Shape.REVERSE, 1)],
)
def test_simulated_motor_follows_the_profile(armed: BenchSetup, shape: Shape, motor: int) -> None:
    armed.plan(shape, speed=-100, duration=1.0, period=1.0, motor=motor, abort_current=40.0)
    profile = armed.bench.plan.profile
    speeds: list[tuple[float, int]] = []
    start = now()
    assert armed.bench.start()

    def has_ended() -> bool:
        speeds.append((now() - start, armed.speed(motor)))
        return armed.bench.phase is not Phase.DRIVING

    armed.until(has_ended)
    armed.until(lambda: armed.brakes(motor))
    assert armed.speed(3 - motor) == 0
    armed.result()
    inside = [(time, speed) for time, speed in speeds if MAX_DELAY < time < profile.duration]
    for time, speed in inside:
        expected = [profile.speed_at(time - MAX_DELAY * part / 200) for part in range(201)]
        assert min(expected) <= speed <= max(expected), f"{time:.3f} s"
    assert max(abs(speed) for _, speed in inside) >= 90


def test_completed_test_leaves_the_motor_braked_and_armed(armed: BenchSetup) -> None:
    armed.plan(speed=60, duration=0.6, abort_current=40.0)
    run = armed.run()
    assert run.end is End.COMPLETE
    assert 0.6 <= run.ended < 0.6 + STEP
    assert armed.brakes()
    assert armed.device.motors.armed
    assert armed.device.motors.holder == ""


def test_profile_is_limited_to_ceiling_and_setpoint_rate(armed: BenchSetup) -> None:
    armed.device.motors.set_ceiling(30)
    armed.plan(Shape.SINE, speed=100, duration=1.0, period=0.6, abort_current=40.0)
    run = armed.run()
    assert 30 <= len(run.setpoints) <= 51
    assert max(abs(speed) for _, speed in run.setpoints) == 30
    assert run.profile.speed == 30


def test_bench_test_does_not_change_the_motor_options(armed: BenchSetup) -> None:
    motors = armed.device.motors
    motors.accelerate = True
    motors.set_linked(True)
    armed.plan(duration=30.0, accelerate=False, abort_current=40.0)
    assert armed.bench.start()
    armed.until(lambda: armed.speed(1) == 60)
    assert armed.speed(2) == 0  # a bench test drives one motor
    armed.bench.release()
    armed.result()
    assert motors.accelerate
    assert motors.linked


# --- Measurements -----------------------------------------------------------------------


def test_board_ramp_lowers_the_measured_inrush_current(armed: BenchSetup) -> None:
    armed.simulator.do("load 1 3")
    armed.plan(speed=120, duration=1.2, accelerate=True, abort_current=38.0)
    hard = figures(armed.run())
    armed.store("motor1_acceleration", 20)
    soft_run = armed.run()
    soft = figures(soft_run)
    assert hard.peak is not None
    assert soft.peak is not None
    assert soft.peak < 0.7 * hard.peak
    assert dict(soft_run.settings)["Motor 1 Acceleration"].startswith("0.64 s")
    assert len(armed.bench.runs) == len(armed.finished) == 2


# --- Release and abort ------------------------------------------------------------------


@pytest.fixture
def driving(armed: BenchSetup) -> BenchSetup:
    """Bench during a long bench test."""
    armed.plan(speed=60, duration=30.0, abort_current=20.0)
    assert armed.bench.start()
    armed.until(lambda: armed.speed() == 60)
    return armed


def test_releasing_the_button_brakes_the_motor(driving: BenchSetup) -> None:
    driving.bench.release()
    driving.until(driving.brakes)
    run = driving.result()
    assert run.end is End.RELEASED
    assert run.ended < 30
    assert driving.device.motors.armed


def test_next_test_can_start_right_after_release(driving: BenchSetup) -> None:
    driving.bench.release()
    assert driving.bench.start()
    driving.until(lambda: driving.speed() == 60)
    assert len(driving.finished) == 1


def aborted(setup: BenchSetup) -> Run:
    """Wait until the test is aborted, the motor is stopped and the motors are disarmed."""
    run = setup.result()
    setup.until(lambda: setup.speed() == 0)
    assert run.end is End.ABORTED
    assert not setup.device.motors.armed
    assert setup.bench.phase is Phase.IDLE
    return run


def test_current_above_abort_limit_aborts_and_disarms(driving: BenchSetup) -> None:
    driving.simulator.do("current 1 21")
    run = aborted(driving)
    assert "Motor 1 drew 21.00 A, more than the abort current of 20 A" in run.reason
    assert driving.device.motors.stop_reason == run.reason
    assert driving.device.motors.locked_for
    assert not driving.device.motors.can_arm


def test_stalled_motor_is_stopped_within_one_second(armed: BenchSetup) -> None:
    armed.simulator.do("load 1 25")  # the load stalls the motor at this speed
    armed.plan(speed=100, duration=30.0, abort_current=15.0, accelerate=False)
    assert armed.bench.start()
    assert aborted(armed).ended < 1.0


def test_current_of_the_other_motor_does_not_abort_the_test(driving: BenchSetup) -> None:
    driving.simulator.do("current 2 25")
    driving.until(lambda: (driving.device.telemetry.motor_currents or (0, 0))[1] > 24)
    assert driving.bench.phase is Phase.DRIVING


@pytest.mark.parametrize(
    ("act", "reason"),
    [
        (lambda setup: setup.simulator.do("fault 1 on"), "reported a fault"),
        (lambda setup: setup.simulator.do("line mute on"), "The board does not respond."),
        (lambda setup: setup.device.motors.press_stop(), "Stop was pressed."),
        (lambda setup: setup.device.disconnect_line(), "The connection was closed."),
    ],
)
def test_end_of_driving_aborts_the_test_and_disarms(
    driving: BenchSetup, act: Callable[[BenchSetup], object], reason: str
) -> None:
    act(driving)
    assert reason in aborted(driving).reason
    assert not driving.bench.start()


@pytest.mark.parametrize("enabled", [False, True])
def test_board_current_limit_aborts_only_when_enabled(armed: BenchSetup, *, enabled: bool) -> None:
    armed.store("motor1_current_limit", 20)  # 6 A
    armed.simulator.do("current 1 7")
    duration = 15.0 if enabled else 1.0
    armed.plan(speed=60, duration=duration, abort_current=20.0, abort_at_limit=enabled)
    run = armed.run()
    assert (run.end is End.ABORTED) is enabled
    assert ("current limit" in run.reason) is enabled


def test_channel_takeover_aborts_the_test(qtbot: QtBot, start_simulator: StartSimulator) -> None:
    setup = BenchSetup(qtbot, start_simulator("--unpaced", "--mode", "rc"))
    for channel in (1, 2, 3, 4, 5):
        setup.simulator.do(f"channel {channel} 1500us")
    setup.until(lambda: not setup.simulator.show()["safe_start"])
    setup.simulator.do("channel 5 1000us")  # lets the serial port control the motors
    setup.connect()
    setup.until(lambda: setup.device.motors.is_available)
    setup.arm()
    setup.plan(speed=60, duration=30.0, abort_current=40.0)
    assert setup.bench.start()
    setup.until(lambda: setup.speed() == 60)
    setup.simulator.do("channel 5 2000us")
    run = aborted(setup)
    assert "no longer reach the motors" in run.reason
    setup.shut_down()


def test_plan_changed_during_a_run_applies_to_the_next_test(driving: BenchSetup) -> None:
    driving.bench.set_plan(replace(driving.bench.plan, motor=2))
    driving.until(lambda: len((driving.bench.latest_run or driving.finished[0]).currents) > 10)
    run = driving.bench.latest_run
    assert run is not None
    assert run.setpoints[0][1] == 60
    assert 0 < run.ended < 30
    assert driving.speed(1) == 60
    assert driving.speed(2) == 0
    driving.bench.release()
    driving.until(lambda: driving.brakes(1))
    assert driving.result().motor == 1
