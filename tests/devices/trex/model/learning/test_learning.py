"""Learning of channels with a simulated board."""

from collections.abc import Callable, Iterator
from dataclasses import replace

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.model.device_setup import DeviceSetup
from tests.support.simulator import SimulatedDevice
from tests.support.transmitter import Stick, Transmitter
from trex_gui.core.errors import NoReply
from trex_gui.devices.trex.board import WriteResult
from trex_gui.devices.trex.calibration.problems import ProblemKind
from trex_gui.devices.trex.client.telemetry import Control
from trex_gui.devices.trex.model.learning.channels import Choice, LearnedChannel
from trex_gui.devices.trex.model.learning.learning import Learning, LearningStep
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.runtime import now

LEARNED = Calibration(2400, 3700, 5100, 80)


class LearningSetup(DeviceSetup):
    """Device that learns its channels from a simulated transmitter."""

    def __init__(self, qtbot: QtBot, simulator: SimulatedDevice) -> None:
        super().__init__(qtbot, simulator)
        self.learning = Learning(self.device)
        self.transmitter = Transmitter(
            simulator, {1: Stick(), 2: Stick(rest=1520, forward_is_down=True)}
        )
        self.requested_tests: list[tuple[int, ...]] = []  # channels of each test
        self.connect()
        self.until(lambda: self.transmitter.is_at_rest(self.device.telemetry.raw_of))
        self.learning.stored.connect(self._on_stored)

    def _on_stored(self) -> None:
        self.requested_tests.append(self.learning.numbers)

    def until_step(self, step: LearningStep) -> None:
        """Wait for a step. Repeat the previous step while its stop is not confirmed."""

        def is_reached() -> bool:
            learning = self.learning
            has_failed = learning.step is LearningStep.FAILED and learning.step is not step
            if has_failed and "the stop of the motors is not confirmed" in learning.problem:
                learning.repeat()
            return learning.step is step

        self.until(is_reached)

    def run_motor(self, speed: int) -> None:
        """Arm the motors, and drive motor 1."""
        self.device.motors.arm()
        self.device.motors.set_speed(1, speed)
        self.until(lambda: self.simulator.show()["motors"][0]["speed"] == speed)

    def restart_in_mode(self, mode: str) -> None:
        """Set the mode jumper and cycle the power."""
        self.simulator.do(f"jumper mode {mode}", "power cycle")
        self.until(lambda: self.device.state is not None and not self.device.state.mode.is_serial)

    def go_to_travel(self, *channels: int) -> None:
        self.learning.start(channels or (1, 2))
        self.until_step(LearningStep.NEUTRAL)
        self.learning.next()
        self.until_step(LearningStep.TRAVEL)

    def push_all(self) -> None:
        """Push every stick to both ends, hold it there, and release it."""
        for position in (1.0, -1.0):
            for channel in self.transmitter.sticks:
                self.transmitter.put(channel, position)
            self.hold()
        self.transmitter.release()
        self.hold()

    def go_to_review(self, *channels: int) -> None:
        self.go_to_travel(*channels)
        self.push_all()
        self.learning.next()

    def review(self, *channels: int, calibration: Calibration = LEARNED) -> None:
        """Review channels with this learned calibration."""
        learned = [LearnedChannel(self.device, number, InputSource.RC) for number in channels]
        for channel in learned:
            channel.choice = Choice(calibration, reversed_=False)
        self.learning.channels = tuple(learned)
        self.learning.step = LearningStep.REVIEW

    def use_values(self, *channels: int, calibration: Calibration = LEARNED) -> None:
        """Edit the settings as after learning these channels."""
        self.review(*channels, calibration=calibration)
        self.learning.use_values()

    def hold(self) -> None:
        """Wait for as many samples as an end needs."""
        inputs = self.device.telemetry.inputs
        start = inputs.times[-1]
        self.until(lambda: float(inputs.times[-1]) > start + 0.4)
        count = self.device.telemetry.samples
        self.until(lambda: self.device.telemetry.samples > count + 60)


@pytest.fixture
def setup(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[LearningSetup]:
    setup = LearningSetup(qtbot, quick_simulator)
    yield setup
    setup.learning.cancel()
    setup.shut_down()


def test_learning_two_channels_is_one_undo_step(setup: LearningSetup) -> None:
    edits: list[bool] = []
    setup.learning.edited.connect(lambda: edits.append(True))
    setup.go_to_review(1, 2)
    assert setup.learning.step is LearningStep.REVIEW
    assert setup.learning.can_use_values
    assert setup.device.draft.pending == 0
    setup.learning.use_values()
    assert edits == [True]
    second = setup.device.calibrations.shown(2)
    assert second is not None
    assert abs(second.neutral - 3800) <= 2
    assert setup.device.parameters.values.value_of("reversed_channels") == 0b10
    assert setup.device.draft.pending == 3
    assert "Learn channels" in setup.device.draft.undo.undoText()
    setup.device.draft.undo.undo()
    assert setup.device.draft.pending == 0


def test_running_motors_are_stopped_before_learning(setup: LearningSetup) -> None:
    setup.run_motor(60)
    setup.learning.start((1,))
    assert setup.learning.step is LearningStep.STOPPING
    setup.until_step(LearningStep.NEUTRAL)
    assert not setup.device.motors.armed
    assert not setup.device.may_move
    assert setup.simulator.show()["motors"][0]["target_direction"] == "brake"


def test_cancelled_learning_does_not_continue_after_the_stop(setup: LearningSetup) -> None:
    setup.run_motor(60)
    setup.learning.start((1,))
    setup.learning.cancel()
    setup.pass_time(4)
    assert setup.learning.step is LearningStep.ENDED


def test_learning_fails_if_the_stop_is_unconfirmed(setup: LearningSetup) -> None:
    setup.simulator.do("line mute on")
    setup.learning.start((1,))
    setup.until_step(LearningStep.FAILED)
    assert "the stop of the motors is not confirmed" in setup.learning.problem


@pytest.mark.parametrize(
    ("mode", "remedy"), [("rc", "remove the mode jumper"), ("analog", "in analog mode")]
)
def test_learning_fails_in_a_mode_in_which_sticks_drive(
    setup: LearningSetup, mode: str, remedy: str
) -> None:
    setup.restart_in_mode(mode)
    setup.learning.start((1,))
    assert setup.learning.step is LearningStep.FAILED
    assert "sticks drive the motors" in setup.learning.problem
    assert remedy in setup.learning.problem


def test_learning_fails_while_the_channels_are_in_control(setup: LearningSetup) -> None:
    """The known mode may be outdated after a short power cut."""
    setup.device.telemetry.newest.update(Control(now(), by_serial=False))
    steps: list[LearningStep] = []
    setup.learning.changed.connect(lambda: steps.append(setup.learning.step))
    setup.learning.start((1,))
    assert setup.learning.step is LearningStep.FAILED
    assert "the channels are in control" in setup.learning.problem
    setup.pass_time(2)
    assert set(steps) <= {LearningStep.STOPPING, LearningStep.FAILED}
    setup.learning.repeat()
    setup.until_step(LearningStep.NEUTRAL)


def test_stick_test_fails_in_rc_mode_despite_the_override(setup: LearningSetup) -> None:
    setup.restart_in_mode("rc")
    setup.until(lambda: setup.device.board.serial_controls is False)
    setup.simulator.do("channel 5 1000us")
    setup.until(lambda: setup.device.board.serial_controls is True)
    setup.learning.start_test((1,))
    assert setup.learning.step is LearningStep.FAILED
    assert "when its switch moves again, the sticks drive the motors" in setup.learning.problem


def test_joint_mode_motor_stays_stopped_while_sticks_move(setup: LearningSetup) -> None:
    setup.cycle_power("eeprom motor_mode 1")
    assert setup.device.board.is_joint
    setup.until(lambda: setup.device.motors.is_available)
    setup.run_motor(60)
    setup.go_to_travel()
    assert setup.simulator.show()["motors"][0]["target_direction"] == "brake"
    setup.push_all()
    assert setup.simulator.show()["motors"][0]["target_direction"] == "brake"
    assert setup.learning.step is LearningStep.TRAVEL


def test_current_after_the_stop_needs_a_check_by_the_user(setup: LearningSetup) -> None:
    setup.simulator.do("current 2 3.0")
    setup.learning.start((1,))
    setup.until_step(LearningStep.DOUBT)
    assert "motor 2 draws 3.0 A" in setup.learning.problem
    assert "cut its power" in setup.learning.problem
    setup.learning.repeat()
    setup.until_step(LearningStep.STOPPING)
    setup.until_step(LearningStep.DOUBT)
    assert setup.learning.can_go_on
    setup.learning.next()  # the user has checked the motors
    setup.until_step(LearningStep.NEUTRAL)


def test_stick_test_starts_once_the_current_has_ended(setup: LearningSetup) -> None:
    setup.simulator.do("current 1 2.0")
    setup.learning.start_test((1,))
    count = setup.device.telemetry.samples
    setup.until(lambda: setup.device.telemetry.samples > count + 60)
    assert setup.learning.step is LearningStep.STOPPING
    setup.simulator.do("current 1 auto")
    setup.until_step(LearningStep.TEST)


def test_arming_is_allowed_in_review_but_not_in_travel(setup: LearningSetup) -> None:
    setup.go_to_review(1, 2)
    setup.device.motors.arm()
    setup.until_step(LearningStep.REVIEW)
    setup.learning.back()
    setup.until_step(LearningStep.FAILED)
    assert "armed" in setup.learning.problem


def test_review_curves_follow_stick_and_selected_values(setup: LearningSetup) -> None:
    setup.go_to_review(1, 2)
    first, second = setup.learning.channels
    before, after = second.curve_before, second.curve_after
    assert before is not None
    assert after is not None
    assert not before.reversed_
    assert after.reversed_
    setup.transmitter.put(1, 1.0)
    setup.until(lambda: first.raw == 5000)
    assert second.choice is not None
    invalid = Calibration(4000, 3750, 5000, 10)
    setup.learning.set_choice(2, calibration=invalid, reversed_=False)
    assert second.curve_after is None
    assert second.curve_before == before


def test_learning_fails_after_a_restart_in_another_mode(setup: LearningSetup) -> None:
    setup.go_to_travel()
    setup.simulator.do("jumper mode rc", "power cycle")
    setup.until_step(LearningStep.FAILED)
    assert "Nothing was changed" in setup.learning.problem


def test_channel_without_signal_is_skipped(setup: LearningSetup) -> None:
    setup.simulator.do("channel 2 silent")
    setup.learning.start((1, 2))
    setup.until_step(LearningStep.NEUTRAL)
    first, second = setup.learning.channels
    setup.until(
        lambda: [problem.kind for problem in second.rest_problems] == [ProblemKind.NO_SIGNAL]
    )
    setup.learning.next()
    setup.until(lambda: setup.learning.has_sampled)
    setup.until_step(LearningStep.NEUTRAL)
    assert first.is_at_rest
    setup.learning.next()
    setup.until_step(LearningStep.TRAVEL)
    assert second.travel is None


def test_going_back_from_review_retains_the_travel(setup: LearningSetup) -> None:
    setup.go_to_review(1, 2)
    setup.learning.back()
    setup.until_step(LearningStep.TRAVEL)
    travels = [channel.travel for channel in setup.learning.channels]
    assert all(travel is not None and travel.is_enough for travel in travels)
    setup.learning.repeat()
    travels = [channel.travel for channel in setup.learning.channels]
    assert not any(travel is not None and travel.is_enough for travel in travels)
    setup.learning.back()
    setup.until_step(LearningStep.NEUTRAL)


def test_invalid_values_cannot_be_accepted(setup: LearningSetup) -> None:
    setup.go_to_review(1, 2)
    (first, _) = setup.learning.channels
    assert first.choice is not None
    valid = first.choice.calibration
    invalid = replace(valid, minimum=valid.maximum + 1, deadband=10)
    setup.learning.set_choice(1, calibration=invalid)
    assert not setup.learning.can_use_values
    assert [problem.kind for problem in first.result_problems] == [ProblemKind.REFUSED]
    setup.learning.set_choice(1, included=False)
    setup.until(lambda: setup.learning.can_use_values)
    setup.learning.use_values()
    assert setup.device.calibrations.shown(1) == setup.device.calibrations.stored(1)


def test_written_values_request_a_test(setup: LearningSetup) -> None:
    setup.go_to_review(1, 2)
    setup.learning.use_values()
    setup.write()
    assert setup.requested_tests == [(1, 2)]
    setup.learning.start_test(setup.learning.numbers)
    setup.until_step(LearningStep.TEST)
    assert setup.learning.tests is not None
    tests = setup.learning.tests
    assert not tests.passed
    setup.push_all()
    setup.until(lambda: tests.passed)
    assert "would release the motors" in tests.safe_start_text
    setup.transmitter.put(1, 0.5)
    setup.until(lambda: "Channel 1 is " in tests.safe_start_text)


def test_gap_in_telemetry_stalls_the_neutral_step(setup: LearningSetup) -> None:
    setup.learning.start((1,))
    setup.until_step(LearningStep.NEUTRAL)
    setup.device.telemetry.blockSignals(True)
    setup.learning.next()
    setup.until(lambda: setup.learning.inputs.stalled)
    assert not setup.learning.can_go_on
    setup.device.telemetry.blockSignals(False)
    setup.until_step(LearningStep.TRAVEL)


# --- Test of learned values -------------------------------------------------------------


@pytest.mark.parametrize("method", ["undo", "discard"])
def test_discarded_values_do_not_request_a_test(setup: LearningSetup, method: str) -> None:
    setup.use_values(1)
    draft = setup.device.draft
    (draft.undo.undo if method == "undo" else draft.discard_edits)()
    setup.device.calibrations.edit(1, LEARNED)  # not by learning
    setup.write()
    assert setup.device.calibrations.stored(1) == LEARNED
    assert setup.requested_tests == []


def test_reconnecting_clears_the_pending_test(setup: LearningSetup) -> None:
    setup.use_values(1)
    setup.disconnect()
    setup.connect()
    assert setup.device.draft.pending
    setup.write()
    assert setup.device.draft.pending == 0
    assert setup.requested_tests == []


def test_requesting_a_test_does_not_stop_running_motors(setup: LearningSetup) -> None:
    setup.use_values(1)
    setup.run_motor(40)
    setup.write()
    assert setup.requested_tests == [(1,)]
    assert setup.learning.motors_armed  # the user confirms before the test begins
    assert setup.learning.step is LearningStep.ENDED
    assert setup.simulator.show()["motors"][0]["speed"] == 40


def test_each_written_channel_requests_its_own_test(setup: LearningSetup) -> None:
    setup.use_values(1, 2)
    setup.write("rc_channel_2")
    assert setup.requested_tests == [(2,)]
    setup.write()
    assert setup.requested_tests == [(2,), (1,)]


def test_test_is_requested_once_the_direction_is_written_too(setup: LearningSetup) -> None:
    setup.review(1)
    setup.learning.set_choice(1, reversed_=True)
    setup.learning.use_values()
    for key, expected in (("rc_channel_1", []), ("reversed_channels", [(1,)])):
        setup.write(key)
        assert setup.requested_tests == expected


@pytest.mark.parametrize(("failed", "expected"), [((2,), (1,)), ((1, 2), None)], ids=str)
def test_only_written_channels_request_a_test(
    setup: LearningSetup, failed: tuple[int, ...], expected: tuple[int, ...] | None
) -> None:
    setup.use_values(1, 2)
    results = tuple(
        WriteResult(CalibrationKey.of(InputSource.RC, number), error=NoReply("no answer"))
        if number in failed
        else WriteResult(CalibrationKey.of(InputSource.RC, number), LEARNED)
        for number in (1, 2)
    )
    setup.device.calibrations.record_stored(dict.fromkeys({1, 2} - set(failed), LEARNED))
    setup.device.applied.emit(results)
    assert setup.requested_tests == ([] if expected is None else [expected])


def test_already_stored_values_request_the_test_at_once(setup: LearningSetup) -> None:
    edits: list[bool] = []
    setup.learning.edited.connect(lambda: edits.append(True))
    stored = setup.device.calibrations.stored(1)
    assert stored is not None
    setup.use_values(1, calibration=stored)
    assert edits == []
    assert setup.requested_tests == [(1,)]
    setup.learning.start_test(setup.learning.numbers)
    setup.until_step(LearningStep.TEST)
    assert setup.learning.test_message == "These values are already stored."
    setup.learning.cancel()
    setup.learning.start_test((1,))
    assert setup.learning.test_message == ""


def test_old_values_in_review_come_from_the_board(setup: LearningSetup) -> None:
    stored = setup.device.calibrations.stored(1)
    assert stored is not None
    setup.device.calibrations.edit(1, replace(stored, neutral=3800))
    setup.device.parameters.edit("reversed_channels", 1)
    setup.device.parameters.edit("serial_timeout", 9)
    setup.review(1)
    (channel,) = setup.learning.channels
    assert not channel.reversed_now
    assert channel.curve_before is not None
    assert channel.curve_before.calibration == stored
    assert not channel.curve_before.reversed_
    assert setup.learning.pending.has_edit(1)
    assert setup.learning.other_edits == 1
    setup.device.parameters.edit("reversed_channels", 0b101)  # channel 3 is not learned
    assert setup.learning.other_edits == 2


@pytest.mark.parametrize("cause", ["mode", "motors"])
def test_failed_test_reports_the_written_values_as_unchanged(
    setup: LearningSetup, cause: str
) -> None:
    setup.use_values(1)
    setup.write()
    assert setup.requested_tests
    setup.learning.start_test(setup.learning.numbers)
    setup.until_step(LearningStep.TEST)
    if cause == "motors":
        setup.device.motors.arm()
    else:
        setup.simulator.do("jumper mode rc", "power cycle")
    setup.until_step(LearningStep.FAILED)
    assert "Nothing was changed" not in setup.learning.problem
    assert "The test has ended. Nothing in the board was changed" in setup.learning.problem


@pytest.mark.parametrize(
    ("step", "go_to"),
    [
        (LearningStep.NEUTRAL, lambda setup: setup.learning.start((1,))),
        (LearningStep.TRAVEL, lambda setup: setup.go_to_travel(1)),
        (LearningStep.REVIEW, lambda setup: setup.go_to_review(1)),
        (LearningStep.TEST, lambda setup: setup.learning.start_test((1,))),
    ],
)
def test_restart_after_power_loss_stops_the_motors_again(
    setup: LearningSetup, step: LearningStep, go_to: Callable[[LearningSetup], None]
) -> None:
    is_test = step is LearningStep.TEST
    go_to(setup)
    setup.until_step(step)
    setup.simulator.do("power off")
    setup.until_step(LearningStep.FAILED)
    assert "The board does not respond" in setup.learning.problem
    assert ("Nothing was changed" in setup.learning.problem) is not is_test
    assert ("The test has ended" in setup.learning.problem) is is_test
    setup.learning.repeat()
    assert setup.learning.problem == "Connect to a board first."
    setup.simulator.do("power on")
    setup.until_link(ConnectionState.CONNECTED)
    assert not setup.learning.can_go_on
    assert not setup.learning.can_use_values
    setup.learning.repeat()
    assert setup.learning.step is LearningStep.STOPPING
    setup.until_step(LearningStep.TEST if is_test else LearningStep.NEUTRAL)
