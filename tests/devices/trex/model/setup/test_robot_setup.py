"""Setup assistant with a simulated robot."""

from collections.abc import Callable, Iterator
from itertools import groupby

import pytest
from pytestqt.qtbot import QtBot

from tests.support.robots import Robot
from tests.support.simulator import SimulatedDevice
from trex_gui.core.resource_files import resource
from trex_gui.devices.trex.model.learning.channels import Choice, LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning, LearningStep
from trex_gui.devices.trex.model.setup.pulses import PAUSE, PULSE, STRONGER, WEAK
from trex_gui.devices.trex.model.setup.robot_setup import LIMITS, Preset, RobotSetup, SetupStep
from trex_gui.devices.trex.model.setup.wiring import Driver, Movement, Rewiring, Side, Wiring
from trex_gui.devices.trex.protocol.calibration import Calibration
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.devices.trex.protocol.parameters import ParameterKey
from trex_gui.devices.trex.settings.reader import read_settings
from trex_gui.ui.runtime import now, runtime


@pytest.fixture
def robot(quick_simulator: SimulatedDevice, qtbot: QtBot) -> Iterator[Robot]:
    robot = Robot(quick_simulator, qtbot)
    robot.connect()
    yield robot
    qtbot.waitUntil(robot.device.shut_down)


def record_movements(robot: Robot, first: Movement, second: Movement) -> None:
    """Answer which wheel each motor turns, and in which direction."""
    robot.setup.record_movement(1, first)
    robot.setup.record_movement(2, second)


def lose_replies(robot: Robot, *commands: str) -> None:
    """Mute the board until it counts as lost. Run commands, then let the board reply again."""
    robot.simulator.do("line mute on")
    robot.wait(lambda: not robot.device.is_connected)
    robot.simulator.do(*commands, "line mute off")
    robot.wait(lambda: robot.device.is_connected)


# --- Wiring -----------------------------------------------------------------------------


def find_rewiring(robot: Robot, driver: Driver) -> Rewiring:
    """Show the sticks, find the motors, and return the changes that the wires need."""
    robot.setup.select_driver(driver)
    if driver is not Driver.COMPUTER:
        robot.show_sticks()
    robot.go_to(SetupStep.MOTORS)
    robot.find_motors()
    assert robot.setup.wiring is not None
    return robot.setup.wiring.rewiring(driver)


@pytest.mark.parametrize(
    ("swapped", "reversed_", "pushed"),
    [(False, False, 2000), (False, True, 1000), (True, False, 1000), (True, True, 2000)],
)
def test_directions_of_one_stick_are_corrected_by_reversing(
    robot: Robot, swapped: bool, reversed_: bool, pushed: int
) -> None:
    """Both motors are connected in the same direction."""
    robot.pushed = pushed
    if swapped:
        robot.exchange_motors()
    if reversed_:
        robot.directions = {Side.LEFT: -1, Side.RIGHT: -1}
    assert not find_rewiring(robot, Driver.ONE_STICK)
    falls = pushed == 1000
    expected = (1 if (swapped != reversed_) != falls else 0) | (2 if reversed_ != falls else 0)
    robot.setup.next()
    assert robot.device.parameters.values.value_of(ParameterKey.REVERSED_CHANNELS) == expected

    assert not robot.device.motors.armed  # another step was opened
    robot.apply()
    robot.start_in_rc_mode()
    assert robot.turns_when_pushed(2) == {Side.LEFT: 1, Side.RIGHT: 1}
    assert robot.turns_when_pushed(1) == {Side.LEFT: 1, Side.RIGHT: -1}


@pytest.mark.parametrize(("swapped", "reversed_"), [(False, True), (True, False), (True, True)])
def test_two_sticks_are_corrected_after_motors_are_exchanged(
    robot: Robot, swapped: bool, reversed_: bool
) -> None:
    if swapped:
        robot.exchange_motors()
    if reversed_:
        robot.exchange_wires(Side.LEFT)
    setup = robot.setup
    assert find_rewiring(robot, Driver.TWO_STICKS).exchange_motors is swapped
    if swapped:
        assert setup.edits == {}  # edits made now would be wrong after the exchange
        robot.exchange_motors()
        setup.clear_movements()
        robot.find_motors()
    setup.next()
    expected = 1 if reversed_ else 0
    assert robot.device.parameters.values.value_of(ParameterKey.REVERSED_CHANNELS) == expected

    robot.apply()
    robot.start_in_rc_mode()
    assert robot.turns_when_pushed(1) == {Side.LEFT: 1, Side.RIGHT: 0}
    assert robot.turns_when_pushed(2) == {Side.LEFT: 0, Side.RIGHT: 1}


def test_driving_by_computer_needs_the_wires_exchanged(robot: Robot) -> None:
    robot.exchange_motors()
    robot.exchange_wires(Side.LEFT)
    setup = robot.setup
    rewiring = find_rewiring(robot, Driver.COMPUTER)
    assert rewiring == Rewiring(exchange_motors=True, reverse=frozenset({Side.LEFT}))
    robot.exchange_motors()
    robot.exchange_wires(Side.LEFT)
    setup.clear_movements()
    robot.find_motors()
    assert setup.wiring == Wiring(swapped=False, backward=frozenset())
    setup.next()
    assert robot.device.draft.pending == 0


def test_single_reversed_motor_of_one_stick_is_rewired() -> None:
    wiring = Wiring(swapped=True, backward=frozenset({Side.LEFT}))
    assert wiring.rewiring(Driver.ONE_STICK).reverse == {Side.LEFT}
    assert wiring.channels_to_reverse(Driver.ONE_STICK) == {1}


def test_reversing_needs_known_sticks_and_consistent_movements(robot: Robot) -> None:
    setup = robot.setup
    assert setup.record_pushed((1, 2)) == (1, 2)  # both sticks are at neutral
    robot.go_to(SetupStep.MOTORS)
    record_movements(robot, Movement.LEFT_BACKWARD, Movement.RIGHT_BACKWARD)
    assert setup.edits == {}
    setup.rises.update({1: True, 2: True})
    assert setup.edits == {ParameterKey.REVERSED_CHANNELS: 3}

    for contradicting in (Movement.LEFT_FORWARD, Movement.NOTHING):
        setup.record_movement(2, contradicting)
        assert setup.wiring is None
        assert setup.edits == {}


def test_learned_stick_directions_are_used(robot: Robot) -> None:
    learning = Learning(robot.device)
    robot.setup = setup = RobotSetup(robot.device, learning)
    learning.channels = tuple(
        LearnedChannel(robot.device, number, InputSource.RC) for number in (1, 2)
    )
    for channel in learning.channels:
        channel.choice = Choice(Calibration(2400, 3700, 5100, 80), reversed_=channel.number == 1)
    learning.step = LearningStep.REVIEW
    assert setup.rises == {}
    learning.use_values()
    assert setup.rises == {1: False, 2: True}
    record_movements(robot, Movement.LEFT_FORWARD, Movement.RIGHT_FORWARD)
    while setup.step is not SetupStep.MOTORS:
        setup.skip()
    assert setup.edits == {}  # learning has corrected the directions
    record_movements(robot, Movement.LEFT_BACKWARD, Movement.RIGHT_BACKWARD)
    assert setup.edits == {ParameterKey.REVERSED_CHANNELS: 0b10}


# --- Open steps -------------------------------------------------------------------------


def test_skipped_steps_stay_open_until_they_have_a_result(robot: Robot) -> None:
    setup, parameters = robot.setup, robot.device.parameters
    setup.select_driver(Driver.ONE_STICK)
    robot.go_to(SetupStep.REVIEW)
    all_open = [SetupStep.JUMPERS, SetupStep.STICKS, SetupStep.MOTORS, SetupStep.LIMITS]
    assert setup.open_steps == all_open
    assert SetupStep.TIMEOUT not in setup.steps

    setup.go_to(SetupStep.JUMPERS)
    setup.next()
    setup.next()  # the directions of the sticks are still unknown
    record_movements(robot, Movement.RIGHT_FORWARD, Movement.LEFT_FORWARD)
    setup.next()
    setup.select_preset(Preset.TANK)
    setup.next()
    assert setup.step is SetupStep.REVIEW
    assert setup.open_steps == [SetupStep.STICKS, SetupStep.MOTORS]
    setup.rises.update({1: True, 2: True})
    assert setup.open_steps == [SetupStep.MOTORS]  # the edit of this step needed the sticks
    setup.go_to(SetupStep.MOTORS)
    setup.next()
    setup.next()
    assert parameters.values.value_of(ParameterKey.REVERSED_CHANNELS) == 1
    assert setup.open_steps == []
    robot.device.draft.undo.undo()
    assert setup.open_steps == [SetupStep.MOTORS]
    setup.select_driver(Driver.TWO_STICKS)  # two sticks need other wires and another jumper
    assert setup.open_steps == all_open[:3]
    robot.device.disconnect_line()
    robot.wait(lambda: setup.open_steps == all_open)


@pytest.mark.parametrize("mix", ["on", "off"])
def test_wrong_mix_jumper_leaves_its_step_open(robot: Robot, mix: str) -> None:
    robot.simulator.do(f"jumper mix {mix}")
    robot.push(2)
    robot.wait(lambda: robot.device.mix_jumper.is_on is not None)
    for driver in (Driver.ONE_STICK, Driver.TWO_STICKS, Driver.COMPUTER):
        robot.setup.select_driver(driver)
        robot.go_to(SetupStep.JUMPERS)
        robot.setup.next()
        is_open = SetupStep.JUMPERS in robot.setup.open_steps
        assert is_open is ((driver, mix) in {(Driver.ONE_STICK, "off"), (Driver.TWO_STICKS, "on")})


def test_stop_by_the_assistant_has_a_reason(robot: Robot) -> None:
    reasons: list[str] = []
    motors = robot.device.motors
    motors.stop_requested.connect(lambda: reasons.append(motors.stop_reason))
    for act in (
        robot.setup.next,
        robot.setup.stop,
        lambda: robot.setup.pulses.confirm_wheels(False),
    ):
        robot.go_to(SetupStep.MOTORS)
        robot.wait(lambda: not motors.locked_for)
        robot.arm()
        act()
        assert not robot.setup.pulses.wheels_are_free
    assert reasons == [
        "Another step of the assistant was opened.",
        "The assistant was closed.",
        "The wheels may touch the ground.",
    ]


# --- Pulses -----------------------------------------------------------------------------


def test_pulses_drive_only_one_motor(robot: Robot) -> None:
    robot.arm()
    pulses, motors = robot.setup.pulses, robot.device.motors
    motors.set_linked(True)
    assert pulses.start(2)
    assert not pulses.start(1)
    start, speeds = now(), []
    while now() - start < 3 * (PULSE + PAUSE):
        speeds.append(robot.speeds())
        robot.pass_time(0.02)
    assert set(speeds) == {(0, 0), (0, WEAK)}
    lengths = [len(list(group)) for (_, speed), group in groupby(speeds) if speed]
    assert len(lengths) == 3
    assert max(lengths) * 0.02 <= 0.5
    pulses.release()
    robot.wait(lambda: robot.speeds() == (0, 0))
    assert motors.armed
    assert motors.linked
    assert motors.accelerate


def test_stronger_pulse_jumps_to_its_speed_below_the_ceiling(robot: Robot) -> None:
    """With a slow ramp, a pulse would end before the motor turns."""
    robot.device.parameters.edit("motor1_acceleration", 1)
    robot.apply()
    robot.arm()
    assert robot.setup.pulses.start(1, stronger=True)
    robot.wait(lambda: robot.speeds() == (STRONGER, 0))
    robot.setup.pulses.release()
    robot.device.motors.set_ceiling(10)
    assert robot.setup.pulses.start(1)
    robot.wait(lambda: robot.speeds() == (10, 0))


BLOCKERS: dict[str, tuple[Callable[[Robot], object], str]] = {
    "the wheels are not confirmed": (
        lambda robot: robot.setup.pulses.confirm_wheels(False),
        "Lift the robot",
    ),
    "a stop has locked the motors": (lambda robot: robot.device.motors.press_stop(), "locked"),
    "the motors are not armed": (lambda robot: robot.device.motors.stop(), "arm the motors"),
    "the other motor runs": (lambda robot: robot.device.motors.set_speed(2, 30), "motor 2 +30"),
    "another control is held": (lambda robot: robot.device.motors.acquire("pad"), "Another"),
}


@pytest.mark.parametrize("case", BLOCKERS)
def test_pulse_is_blocked(robot: Robot, case: str) -> None:
    robot.arm()
    act, words = BLOCKERS[case]
    act(robot)
    pulses = robot.setup.pulses
    assert words in pulses.blocker
    assert not pulses.start(1)
    robot.pass_time(0.2)
    assert robot.speeds()[0] == 0


def test_pulses_do_not_continue_after_the_board_was_silent(robot: Robot) -> None:
    robot.go_to(SetupStep.MOTORS)
    robot.arm()
    assert robot.setup.pulses.start(1)
    robot.wait(lambda: robot.speeds() == (WEAK, 0))
    lose_replies(robot)
    assert robot.setup.pulses.motor == 0
    assert not robot.setup.pulses.wheels_are_free
    robot.pass_time(2)
    assert robot.speeds() == (0, 0)


def test_board_in_rc_mode_gets_neither_pulses_nor_edits(
    start_simulator: Callable[..., SimulatedDevice], qtbot: QtBot
) -> None:
    robot = Robot(start_simulator("--unpaced", "--mode", "rc"), qtbot)
    robot.device.connect_to(ConnectionSettings(robot.simulator.url))
    robot.wait(lambda: robot.device.board.serial_controls is not None)
    robot.setup.pulses.confirm_wheels(True)
    assert "in RC mode" in robot.setup.pulses.blocker
    assert not robot.setup.pulses.start(1)
    robot.go_to(SetupStep.LIMITS)
    robot.setup.select_preset(Preset.TANK)
    assert robot.setup.edits == {}
    robot.go_to(SetupStep.JUMPERS)
    robot.setup.next()
    assert SetupStep.JUMPERS in robot.setup.open_steps, "the mode jumper is still set"
    qtbot.waitUntil(robot.device.shut_down)


def test_answers_are_cleared_for_another_model(
    robot: Robot, start_simulator: Callable[..., SimulatedDevice]
) -> None:
    """The models have different units of current."""
    setup = robot.setup
    setup.select_preset(Preset.TANK)
    setup.rises.update({1: True, 2: True})
    setup.record_movement(1, Movement.LEFT_FORWARD)
    second = start_simulator("--unpaced", "--model", "trexjr")
    robot.device.connect_to(ConnectionSettings(second.url))
    robot.wait(lambda: robot.device.parameters.model_key == "trexjr")
    assert setup.current_limit is None
    assert setup.preset is None
    assert not setup.movements
    assert not setup.rises


@pytest.mark.parametrize("number", [7, 9])
def test_answers_are_cleared_for_another_board_after_silence(robot: Robot, number: int) -> None:
    setup = robot.setup
    setup.record_movement(1, Movement.LEFT_FORWARD)
    setup.rises.update({1: True, 2: True})
    lose_replies(robot, f"eeprom device_number {number}")
    assert bool(setup.movements) is bool(setup.rises) is (number == 7)


def test_pulses_end_when_the_window_hangs(robot: Robot) -> None:
    robot.arm()
    assert robot.setup.pulses.start(1)
    robot.wait(lambda: robot.speeds() == (WEAK, 0))
    runtime().sleep(0.7)
    assert robot.speeds() == (0, 0)
    robot.wait(lambda: not robot.device.motors.armed)
    robot.pass_time(2)
    assert robot.speeds() == (0, 0)
    assert robot.setup.pulses.motor == 0


# --- Other steps ------------------------------------------------------------------------


@pytest.mark.parametrize("preset", Preset)
@pytest.mark.parametrize("model", ["trex", "trexjr"])
def test_preset_equals_its_sample_file(preset: Preset, model: str) -> None:
    path = resource("samples") / preset.value
    sample, _ = read_settings(path.read_bytes())
    values = preset.values(model)
    assert {key: sample.parameters[key] for key in values} == values
    assert {"motor1_acceleration", "motor2_brake_duration"} <= values.keys()
    assert (set(LIMITS) <= values.keys()) is (sample.product.key == model)


def test_limits_and_timeout_each_become_one_undo_step(robot: Robot) -> None:
    setup, parameters = robot.setup, robot.device.parameters
    setup.select_driver(Driver.COMPUTER)
    robot.go_to(SetupStep.LIMITS)
    assert setup.edits == {}
    setup.select_preset(Preset.AUTONOMOUS)
    setup.select_current_limit(20)
    setup.next()
    steps = [setup.step]
    assert [parameters.values.value_of(key) for key in LIMITS] == [20, 20]
    assert parameters.values.value_of("motor2_acceleration") == 25
    setup.skip()
    assert not parameters.values.is_modified(ParameterKey.SERIAL_TIMEOUT)
    setup.back()
    setup.next()
    assert parameters.values.value_of(ParameterKey.SERIAL_TIMEOUT) == 5
    assert [*steps, setup.step] == [SetupStep.TIMEOUT, SetupStep.REVIEW]
    assert SetupStep.STICKS not in setup.steps

    stored = robot.simulator.show()["parameters"]
    assert stored["serial_timeout"] == 0  # Apply has not written yet
    robot.device.draft.undo.undo()
    robot.device.draft.undo.undo()
    assert robot.device.draft.pending == 0
