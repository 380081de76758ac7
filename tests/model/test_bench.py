"""Bench tests with a simulated board: its motors do what the profile says, and stop in time."""

import sys
from collections.abc import Callable, Iterator
from dataclasses import replace
from itertools import pairwise
from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.bench.figures import figures
from trex_gui.bench.profile import Profile, Shape
from trex_gui.bench.run import End, Run
from trex_gui.emulator.physics import CONSTANTS, MotorPhysics
from trex_gui.link.settings import LinkSettings
from trex_gui.model.bench import Bench, Phase, Plan
from trex_gui.model.device import Device, Link
from trex_gui.runtime import now

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)

TRIES = 4
"""How often is tried what a computer that stands still for a moment spoils."""

LATE = 0.35
"""Seconds by which a simulated motor may follow its command on a machine with much else to do."""


class Person:
    """Somebody with a board on blocks, and a finger on the button."""

    def __init__(self, qtbot: QtBot, simulator: SimulatedDevice) -> None:
        self.device = Device()
        self.bench = Bench(self.device)
        self.simulator = simulator
        self.finished: list[Run] = []
        self.bench.finished.connect(self.finished.append)
        self._qtbot = qtbot

    def until(self, condition: Callable[[], bool]) -> None:
        self._qtbot.waitUntil(condition)

    def connect(self) -> None:
        self.device.connect_to(LinkSettings(self.simulator.url))
        self.until(lambda: self.device.link is Link.UP)
        self.until(lambda: self.device.telemetry.motor_currents is not None)

    def plan(self, shape: Shape = Shape.STEP, **values: Any) -> None:
        profile: dict[str, Any] = {"speed": 60, "duration": 1.0, "period": 1.0, "shape": shape}
        profile |= {name: values.pop(name) for name in tuple(values) if name in profile}
        self.bench.set_plan(Plan(profile=Profile(**profile), **values))

    def arm(self) -> None:
        self.device.motors.arm()
        assert self.device.motors.armed

    def run(self) -> Run:
        """Hold the button until the test is over."""
        assert self.bench.begin(), self.bench.obstacle
        return self.result()

    def result(self) -> Run:
        self.until(lambda: self.bench.phase is Phase.IDLE)
        return self.finished[-1]

    def speed(self, motor: int = 1) -> int:
        """What the simulated output does: signed speed; 0 while it brakes."""
        shown = self.simulator.show()["motors"][motor - 1]
        sign = {"forward": 1, "reverse": -1, "brake": 0}[shown["direction"]]
        return int(sign * shown["speed"])

    def brakes(self, motor: int = 1) -> bool:
        shown = self.simulator.show()["motors"][motor - 1]
        return bool(shown["direction"] == "brake" and shown["speed"] == 127)


@pytest.fixture
def person(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[Person]:
    person = Person(qtbot, quick_simulator)
    person.connect()
    yield person
    qtbot.waitUntil(person.device.shut_down)  # no thread lives on


@pytest.fixture
def armed(person: Person) -> Person:
    person.arm()
    return person


# --- What stands in the way -------------------------------------------------------------


def test_without_a_board_there_is_nothing_to_test(qtbot: QtBot) -> None:
    bench = Bench(Device())
    assert "Connect to a board" in bench.obstacle
    assert not bench.begin()
    assert bench.phase is Phase.IDLE


def test_nothing_runs_before_the_motors_are_armed(person: Person) -> None:
    person.plan()
    assert "press Run motor" in person.bench.obstacle
    assert not person.bench.begin()
    assert person.speed() == 0


def test_motors_that_run_already_are_brought_to_rest_first(armed: Person) -> None:
    armed.device.motors.set_speed(2, 20)
    assert "motor 2 +20" in armed.bench.obstacle
    assert not armed.bench.begin()


def test_what_another_control_holds_is_not_taken(armed: Person) -> None:
    armed.device.motors.hold("pad")
    assert "Another control" in armed.bench.obstacle
    assert not armed.bench.begin()


def test_after_stop_the_lock_is_named(armed: Person) -> None:
    armed.device.motors.press_stop()
    assert "locked for" in armed.bench.obstacle


def test_joint_motors_are_not_tested_for_nothing_measures_their_current(person: Person) -> None:
    person.device.parameters.edit("motor_mode", 1)
    person.device.apply()
    person.until(lambda: not person.device.applying and person.device.pending == 0)
    person.device.note_power_cycled()
    person.arm()
    assert "joint mode" in person.bench.obstacle


# --- The motors follow ------------------------------------------------------------------


@pytest.mark.timeout(180)
@pytest.mark.parametrize(
    ("shape", "motor"),
    [(Shape.RAMP, 1), (Shape.SINE, 2), (Shape.REVERSE, 1), (Shape.STEP, 2)],
)
def test_the_simulated_motor_follows_the_profile(armed: Person, shape: Shape, motor: int) -> None:
    armed.plan(shape, speed=-100, duration=2.0, period=2.0, motor=motor, abort_current=40.0)
    strays = ["not tried"]
    for _ in range(5 * TRIES):  # each takes two seconds, in none of which anybody may stand still
        if not (strays := strays_from_the_profile(armed, motor)):
            break
    assert strays == []


def strays_from_the_profile(armed: Person, motor: int) -> list[str]:
    """Run a test; return where the simulated motor was somewhere else than it should have been."""
    profile = armed.bench.plan.profile
    seen: list[tuple[float, float, int]] = []
    before_it = now()
    assert armed.bench.begin()
    after_it = now()

    def look() -> bool:
        before = now()
        speed = armed.speed(motor)
        seen.append((before - after_it - LATE, now() - before_it, speed))
        return armed.bench.phase is not Phase.DRIVING

    armed.until(look)
    armed.until(lambda: armed.brakes(motor))
    assert armed.speed(3 - motor) == 0
    armed.result()
    inside = [(low, high, speed) for low, high, speed in seen if low > 0 and high < 1.95]
    strays = [] if len(inside) > 10 else [f"looked at {len(inside)} times"]
    for low, high, speed in inside:
        asked = [profile.speed_at(low + (high - low) * part / 200) for part in range(201)]
        if not min(asked) <= speed <= max(asked):
            strays.append(f"{speed} between {low:.2f} and {high:.2f} s")
    if max((abs(speed) for *_, speed in inside), default=0) < 90:
        strays.append("never fast")
    return strays


def test_a_test_that_is_over_leaves_the_motor_braked_and_armed(armed: Person) -> None:
    def lasts() -> float:
        run = armed.run()
        assert run.end is End.COMPLETE
        armed.until(armed.brakes)
        assert armed.device.motors.armed
        assert armed.device.motors.holder == ""
        return run.ended

    armed.plan(speed=60, duration=0.6, abort_current=40.0)
    assert any(0.6 <= lasts() < 0.6 + LATE for _ in range(TRIES))


def test_a_profile_is_asked_for_at_most_fifty_times_a_second(armed: Person) -> None:
    armed.plan(Shape.SINE, speed=127, duration=1.0, abort_current=40.0)
    counts = [len(armed.run().wishes)]
    while counts[-1] < 10 and len(counts) < TRIES:
        counts.append(len(armed.run().wishes))
    assert counts[-1] >= 10
    assert max(counts) <= 51


def test_no_speed_goes_beyond_the_ceiling(armed: Person) -> None:
    armed.device.motors.set_ceiling(30)
    armed.plan(Shape.SINE, speed=100, duration=0.6, period=0.6, abort_current=40.0)
    runs = [armed.run()]
    while highest(runs) < 30 and len(runs) < TRIES:
        runs.append(armed.run())
    assert highest(runs) == 30
    assert runs[0].profile.speed == 30


def highest(runs: list[Run]) -> int:
    """Return the highest speed that was asked for in any of several tests."""
    return max((abs(speed) for run in runs for _, speed in run.wishes), default=0)


def test_options_of_the_other_controls_are_as_before(armed: Person) -> None:
    motors = armed.device.motors
    motors.accelerate = True
    motors.set_linked(True)
    armed.plan(duration=30.0, accelerate=False, abort_current=40.0)
    assert armed.bench.begin()
    armed.until(lambda: armed.speed(1) == 60)
    assert armed.speed(2) == 0  # the test is of one motor
    armed.bench.let_go()
    armed.result()
    assert motors.accelerate
    assert motors.linked


# --- The numbers are the simulated motor's ----------------------------------------------


def rush_in(load: float, share: float) -> tuple[float, float]:
    """Return the peak and the steady current in A of the simulated motor at a step.

    A reading is an average over the time since the last one, 80 times a second.
    """
    motor = MotorPhysics(CONSTANTS["trex"], 0.15, seed=1)
    motor.load = load
    readings: list[float] = []
    for _ in range(80):
        charge = 0.0
        for _ in range(50):
            step = 1 / 80 / 50
            charge += motor.current_at(12.0 * share) * step
            motor.advance(step, 12.0 * share, 0.0)
        readings.append(charge * 80)
    return max(readings), readings[-1]


def gapless(person: Person) -> Run:
    """Return a test in which wishes and readings followed each other closely.

    A computer that stands still for a moment holds them up, and then there are other figures.
    """
    for _ in range(TRIES):
        run = person.run()
        begun = run.wishes[0][0] < 0.05
        times = [0.0, *(time for time, _ in run.currents if time <= run.ended), run.ended]
        if begun and max(later - earlier for earlier, later in pairwise(times)) < 0.15:
            break
    return run


def test_peak_and_steady_current_are_those_of_the_motor_model(armed: Person) -> None:
    armed.simulator.do("load 1 6")
    armed.plan(speed=64, duration=1.5, accelerate=False, abort_current=38.0)
    found = figures(gapless(armed))
    peak, steady = rush_in(6.0, 64 / 127)
    assert steady == pytest.approx(6.0, abs=0.1)
    assert found.steady == pytest.approx(steady, abs=0.15)
    assert found.peak is not None
    assert 1.3 * steady < found.peak < 1.1 * peak  # a slow line misses the very top of it
    assert found.mean is not None
    assert found.charge is not None
    assert found.charge == pytest.approx(found.mean * 1.5 / 3.6, rel=0.1)
    assert found.delay is not None
    assert 0 < found.delay < LATE
    assert found.settled is not None
    assert found.settled < 0.6  # time constant 60 ms, and what the line adds


def test_a_ramp_of_the_board_tames_the_rush_in_and_the_figures_show_it(armed: Person) -> None:
    armed.simulator.do("load 1 3")
    armed.plan(speed=120, duration=1.2, accelerate=True, abort_current=38.0)
    hard = figures(gapless(armed))
    armed.device.parameters.edit("motor1_acceleration", 20)  # 120 takes 0.6 s
    armed.device.apply()
    armed.until(lambda: not armed.device.applying and armed.device.pending == 0)
    soft_run = gapless(armed)
    soft = figures(soft_run)
    assert hard.peak is not None
    assert soft.peak is not None
    assert soft.peak < 0.7 * hard.peak
    assert dict(soft_run.settings)["Motor 1 Acceleration"].startswith("20")
    assert len(armed.bench.runs) == len(armed.finished) >= 2


# --- Letting go and what ends a test ----------------------------------------------------


@pytest.fixture
def driving(armed: Person) -> Person:
    """A long test that runs."""
    armed.plan(speed=60, duration=30.0, abort_current=20.0)
    assert armed.bench.begin()
    armed.until(lambda: armed.speed() == 60)
    return armed


def test_letting_go_brakes_the_motor(driving: Person) -> None:
    driving.bench.let_go()
    driving.until(driving.brakes)
    run = driving.result()
    assert run.end is End.LET_GO
    assert run.ended < 30
    assert driving.device.motors.armed


def test_after_letting_go_the_next_test_can_begin_at_once(driving: Person) -> None:
    driving.bench.let_go()
    assert driving.bench.begin()
    driving.until(lambda: driving.speed() == 60)
    assert len(driving.finished) == 1
    driving.bench.let_go()
    driving.until(driving.brakes)


def aborted(person: Person) -> Run:
    """Wait for the end; the simulated motor stands and nothing is armed."""
    run = person.result()
    person.until(lambda: person.speed() == 0)
    assert run.end is End.ABORTED
    assert not person.device.motors.armed
    assert person.bench.phase is Phase.IDLE
    return run


def test_too_high_a_current_stops_everything(driving: Person) -> None:
    driving.simulator.do("current 1 21")
    run = aborted(driving)
    assert "Motor 1 drew 21.00 A, more than the 20 A to abort at" in run.reason
    assert driving.device.motors.stop_reason == run.reason
    driving.simulator.do("current 1 auto")


def test_a_stalled_motor_is_let_go_within_a_moment(armed: Person) -> None:
    def lasts() -> float:
        if not armed.device.motors.armed:
            armed.until(lambda: armed.device.motors.locked_for == 0)
            armed.arm()
            armed.until(lambda: not armed.bench.obstacle)
        assert armed.bench.begin()
        return aborted(armed).ended

    armed.simulator.do("load 1 25")  # more than it can turn at this speed
    armed.plan(speed=100, duration=30.0, abort_current=15.0, accelerate=False)
    assert any(lasts() < 1.0 for _ in range(TRIES))


def test_the_other_motors_current_is_not_the_tests_business(driving: Person) -> None:
    driving.simulator.do("current 2 25")
    driving.until(lambda: (driving.device.telemetry.motor_currents or (0, 0))[1] > 24)
    assert driving.bench.phase is Phase.DRIVING
    driving.bench.let_go()
    driving.until(driving.brakes)


def test_a_fault_of_the_driver_stops_everything(driving: Person) -> None:
    driving.simulator.do("fault 1 on")
    assert "reported a fault" in aborted(driving).reason


@pytest.mark.parametrize("wanted", [False, True])
def test_the_boards_own_limit_ends_a_test_if_that_is_wanted(armed: Person, *, wanted: bool) -> None:
    armed.device.parameters.edit("motor1_current_limit", 20)  # 6 A
    armed.device.apply()
    armed.until(lambda: not armed.device.applying and armed.device.pending == 0)
    armed.simulator.do("current 1 7")
    duration = 15.0 if wanted else 1.0
    armed.plan(speed=60, duration=duration, abort_current=20.0, abort_at_limit=wanted)
    run = armed.run()
    assert (run.end is End.ABORTED) is wanted
    assert ("current limit" in run.reason) is wanted


def test_a_stop_ends_a_test_and_locks(driving: Person) -> None:
    driving.device.motors.press_stop()
    assert aborted(driving).reason == "Stop was pressed."
    assert not driving.bench.begin()


def test_a_board_that_falls_silent_ends_a_test(driving: Person) -> None:
    driving.simulator.do("line mute on")
    run = driving.result()
    assert run.end is End.ABORTED
    assert "stopped answering" in run.reason or "No current was read" in run.reason
    assert not driving.device.motors.armed
    driving.simulator.do("line mute off")
    driving.until(lambda: driving.speed() == 0)


def test_a_cable_that_is_pulled_ends_a_test(driving: Person) -> None:
    driving.simulator.do("line unplug")
    run = driving.result()
    assert run.end is End.ABORTED
    assert "line was closed" in run.reason or "stopped answering" in run.reason


def test_disconnecting_ends_a_test_and_stops_the_motor(driving: Person) -> None:
    driving.device.disconnect_line()
    run = driving.result()
    assert run.end is End.ABORTED
    assert run.reason == "The line was closed."
    driving.until(lambda: driving.speed() == 0)


def test_channels_that_take_over_end_a_test(qtbot: QtBot, start_simulator: StartSimulator) -> None:
    person = Person(qtbot, start_simulator("--unpaced", "--mode", "rc"))
    for channel in (1, 2, 3, 4, 5):
        person.simulator.do(f"channel {channel} 1500us")
    person.until(lambda: not person.simulator.show()["safe_start"])
    person.simulator.do("channel 5 1000us")  # hands the motors to the serial port
    person.connect()
    person.until(lambda: person.device.motors.can_arm)
    person.arm()
    person.plan(speed=60, duration=30.0, abort_current=40.0)
    assert person.bench.begin()
    person.until(lambda: person.speed() == 60)
    person.simulator.do("channel 5 2000us")
    run = aborted(person)
    assert "do not control the motors" in run.reason
    person.until(person.device.shut_down)


def test_a_plan_that_changes_meanwhile_is_for_the_next_test(driving: Person) -> None:
    driving.bench.set_plan(replace(driving.bench.plan, motor=2))
    assert driving.speed(1) == 60
    assert driving.speed(2) == 0
    driving.bench.let_go()
    driving.until(lambda: driving.brakes(1))
    assert driving.result().motor == 1


def test_what_runs_can_be_looked_at(driving: Person) -> None:
    driving.until(lambda: len((driving.bench.current or driving.finished[0]).currents) > 10)
    run = driving.bench.current
    assert run is not None
    assert run.wishes[0][1] == 60
    assert 0 < run.ended < 30
    driving.bench.let_go()
    driving.until(driving.brakes)
