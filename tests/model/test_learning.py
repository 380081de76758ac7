"""Learning on a simulated board: the steps, what stops them, and what they leave behind."""

import sys
from collections.abc import Callable, Iterator
from dataclasses import replace

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice
from tests.support.transmitter import Stick, Transmitter
from trex_gui.learning.problems import Kind
from trex_gui.link.settings import LinkSettings
from trex_gui.link.writing import Written
from trex_gui.model.device import Device, Link
from trex_gui.model.learning import Learning, Step
from trex_gui.protocol.errors import NoReply, TrexError

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)

pytestmark = pytest.mark.timeout(180)  # a busy computer may take its time


UNPROVED = "not sure that the motors stand"


class Bench:
    """A device with somebody who learns its channels."""

    def __init__(self, simulator: SimulatedDevice, qtbot: QtBot) -> None:
        self.simulator = simulator
        self.device = Device()
        self.learning = Learning(self.device)
        self.person = Transmitter(
            simulator, {1: Stick(), 2: Stick(rest=1520, forward_is_down=True)}
        )
        self._qtbot = qtbot
        failures: list[str] = []
        self.device.failed.connect(failures.append)
        self.device.connect_to(LinkSettings(simulator.url))
        self.until(lambda: self.device.link is Link.UP or bool(failures))
        assert not failures, (failures, simulator.show()["power"], simulator.show()["active_uart"])
        self.until(lambda: self.person.rests(self.device.telemetry.raw_of))

    def until(self, condition: Callable[[], bool], timeout: int = 30_000) -> None:
        self._qtbot.waitUntil(condition, timeout=timeout)

    def until_step(self, step: Step) -> None:
        """Wait for a step, as a person does: on a busy machine a stop may not be proved at once."""

        def is_there() -> bool:
            learning = self.learning
            unproved = learning.step is Step.FAILED and UNPROVED in learning.trouble
            if unproved and step is not Step.FAILED:
                learning.again()
            return learning.step is step

        self.until(is_there)

    def go_to_travel(self, *channels: int) -> None:
        self.learning.begin(channels or (1, 2))
        self.until_step(Step.NEUTRAL)
        self.learning.next()
        self.until_step(Step.TRAVEL)

    def push_all(self) -> None:
        """Hold every stick at each end until it was seen there, then let go."""
        for position in (1.0, -1.0):
            for channel in self.person.sticks:
                self.person.put(channel, position)
            self.hold()
        self.person.let_go()
        self.hold()

    def to_review(self, *channels: int) -> None:
        self.go_to_travel(*channels)
        self.push_all()
        self.learning.next()

    def write(self) -> None:
        self.device.apply()
        self.until(lambda: not self.device.applying)

    def hold(self) -> None:
        """Wait for as many measurements as make an end, on a busy computer too."""
        inputs = self.device.telemetry.inputs
        start = inputs.times[-1]
        self.until(lambda: float(inputs.times[-1]) > start + 0.4)
        before = self.device.telemetry.samples
        self.until(lambda: self.device.telemetry.samples > before + 60)


@pytest.fixture
def bench(qtbot: QtBot, quick_simulator: SimulatedDevice) -> Iterator[Bench]:
    bench = Bench(quick_simulator, qtbot)
    yield bench
    bench.learning.cancel()
    qtbot.waitUntil(bench.device.shut_down)


def test_two_channels_are_learned_at_once_as_one_step_to_undo(bench: Bench) -> None:
    taken: list[bool] = []
    bench.learning.taken.connect(lambda: taken.append(True))
    bench.go_to_travel()
    bench.push_all()
    bench.learning.next()
    assert bench.learning.step is Step.REVIEW
    assert bench.learning.can_take
    assert bench.device.pending == 0
    bench.learning.take()
    assert taken == [True]
    second = bench.device.calibrations.shown(2)
    assert second is not None
    assert abs(second.neutral - 3800) <= 2
    assert bench.device.parameters.value_of("reversed_channels") == 0b10
    assert bench.device.pending == 3
    assert "Learn channels" in bench.device.undo.undoText()
    bench.device.undo.undo()
    assert bench.device.pending == 0


def test_motors_that_run_are_stopped_first(bench: Bench) -> None:
    bench.device.motors.arm()
    bench.device.motors.set_speed(1, 60)
    bench.until(lambda: bench.simulator.show()["motors"][0]["speed"] == 60)
    bench.learning.begin((1,))
    assert bench.learning.step is Step.STOPPING
    bench.until_step(Step.NEUTRAL)
    assert not bench.device.motors.armed
    assert not bench.device.may_move
    assert bench.simulator.show()["motors"][0]["target_direction"] == "brake"


def test_a_stop_that_is_not_proved_ends_it(bench: Bench) -> None:
    bench.simulator.do("line mute on")
    bench.learning.begin((1,))
    bench.until_step(Step.FAILED)
    assert bench.learning.trouble


def test_a_board_whose_sticks_drive_is_refused_with_what_to_do(bench: Bench) -> None:
    bench.simulator.do("jumper mode rc")
    bench.simulator.do("power cycle")
    bench.until(lambda: bench.device.state is not None and not bench.device.state.mode.is_serial)
    bench.learning.begin((1,))
    assert bench.learning.step is Step.FAILED
    assert "sticks drive the motors" in bench.learning.trouble
    assert "take the mode jumper off" in bench.learning.trouble


def test_override_does_not_make_moving_sticks_safe(bench: Bench) -> None:
    bench.simulator.do("jumper mode rc")
    bench.simulator.do("power cycle")
    bench.until(lambda: bench.device.state is not None and not bench.device.state.mode.is_serial)
    bench.until(lambda: bench.device.telemetry.serial_controls is False)
    bench.simulator.do("channel 5 1000us")
    bench.until(lambda: bench.device.telemetry.serial_controls is True)
    bench.learning.begin_test((1,))
    assert bench.learning.step is Step.FAILED
    assert "with the next move of its switch the sticks drive the motors" in bench.learning.trouble


def test_a_board_in_analog_mode_is_refused_too(bench: Bench) -> None:
    bench.simulator.do("jumper mode analog")
    bench.simulator.do("power cycle")
    bench.until(lambda: bench.device.state is not None and not bench.device.state.mode.is_serial)
    bench.learning.begin((1,))
    assert bench.learning.step is Step.FAILED
    assert "in analog mode: the sticks drive the motors" in bench.learning.trouble


def test_in_joint_mode_the_motor_is_stopped_and_sticks_move_nothing(bench: Bench) -> None:
    bench.simulator.do("eeprom motor_mode 1")
    bench.simulator.do("power off")
    bench.until(lambda: bench.device.link is Link.SILENT)
    bench.simulator.do("power on")
    bench.until(lambda: bench.device.link is Link.UP and bench.device.is_joint)
    bench.until(lambda: bench.device.motors.can_arm)
    bench.device.motors.arm()
    bench.device.motors.set_speed(1, 60)
    bench.until(lambda: bench.simulator.show()["motors"][0]["speed"] == 60)
    bench.go_to_travel()
    assert bench.simulator.show()["motors"][0]["target_direction"] == "brake"
    bench.push_all()
    assert bench.simulator.show()["motors"][0]["target_direction"] == "brake"
    assert bench.learning.step is Step.TRAVEL


def test_a_current_that_goes_on_after_the_stop_has_to_be_looked_at(bench: Bench) -> None:
    bench.simulator.do("current 2 3.0")
    bench.learning.begin((1,))
    bench.until_step(Step.DOUBT)
    assert "motor 2 draws 3.0 A" in bench.learning.trouble
    assert "cut its power" in bench.learning.trouble
    bench.learning.again()
    bench.until_step(Step.STOPPING)
    bench.until_step(Step.DOUBT)
    assert bench.learning.can_go_on
    bench.learning.next()  # a person has looked
    bench.until_step(Step.NEUTRAL)


def test_a_current_that_ends_a_moment_after_the_stop_holds_nothing_up(bench: Bench) -> None:
    bench.simulator.do("current 1 2.0")
    bench.learning.begin_test((1,))
    bench.until(lambda: not bench.device.may_move)
    assert bench.learning.step is Step.STOPPING
    bench.simulator.do("current 1 auto")
    bench.until_step(Step.TEST)


def test_nobody_connected_is_said(bench: Bench) -> None:
    bench.device.disconnect_line()
    bench.until(lambda: bench.device.link is Link.NONE)
    assert bench.learning.why_not() == "Connect to a board first."


def test_arming_the_motors_meanwhile_ends_it(bench: Bench) -> None:
    bench.go_to_travel()
    bench.device.motors.arm()
    assert bench.learning.step is Step.FAILED
    assert "armed" in bench.learning.trouble
    bench.device.motors.stop()


def test_who_looks_at_the_result_may_drive_but_not_move_sticks_meanwhile(bench: Bench) -> None:
    bench.go_to_travel()
    bench.push_all()
    bench.learning.next()
    bench.device.motors.arm()
    bench.until_step(Step.REVIEW)
    bench.learning.back()
    bench.until_step(Step.FAILED)
    assert "armed" in bench.learning.trouble
    bench.device.motors.stop()


def test_the_curve_under_review_follows_stick_and_choice(bench: Bench) -> None:
    bench.go_to_travel()
    bench.push_all()
    bench.learning.next()
    first, second = bench.learning.channels
    before, after = second.curve_before, second.curve_after
    assert before is not None
    assert after is not None
    assert not before.reversed_
    assert after.reversed_
    bench.person.put(1, 1.0)
    bench.until(lambda: first.raw == 5000)
    times, counts, now = bench.learning.trace(1)
    assert len(times) == len(counts)
    assert now >= times[-1]
    assert second.choice is not None
    bad = type(second.choice.calibration)(4000, 3750, 5000, 10)
    bench.learning.choose(2, bad, reversed_=False)
    assert second.curve_after is None
    assert second.curve_before == before


@pytest.mark.parametrize("step", [Step.TRAVEL, Step.TEST])
def test_a_board_whose_power_fails_ends_it_and_can_be_begun_again(bench: Bench, step: Step) -> None:
    if step is Step.TRAVEL:
        bench.go_to_travel()
    else:
        bench.learning.begin_test((1, 2))
        bench.until_step(Step.TEST)
    bench.simulator.do("power off")
    bench.until_step(Step.FAILED)
    assert "The board has stopped answering" in bench.learning.trouble
    kept = "Nothing was changed" if step is Step.TRAVEL else "The test has ended"
    assert kept in bench.learning.trouble
    assert ("Nothing was changed" in bench.learning.trouble) is (step is Step.TRAVEL)
    bench.learning.again()
    assert bench.learning.trouble == "Connect to a board first."
    bench.simulator.do("power on")
    bench.until(lambda: bench.device.link is Link.UP)
    bench.learning.again()
    bench.until_step(Step.NEUTRAL if step is Step.TRAVEL else Step.TEST)


def test_a_board_that_is_started_in_another_mode_meanwhile_ends_it(bench: Bench) -> None:
    bench.go_to_travel()
    bench.simulator.do("jumper mode rc")
    bench.simulator.do("power cycle")
    bench.until_step(Step.FAILED)
    assert "Nothing was changed" in bench.learning.trouble


def test_a_channel_without_rest_is_left_behind(bench: Bench) -> None:
    bench.simulator.do("channel 2 silent")
    bench.learning.begin((1, 2))
    bench.until_step(Step.NEUTRAL)
    first, second = bench.learning.channels
    bench.until(lambda: [p.kind for p in second.rest_problems] == [Kind.NO_SIGNAL])
    bench.learning.next()
    bench.until(lambda: bench.learning.has_sampled)
    bench.until_step(Step.NEUTRAL)
    assert first.is_at_rest
    bench.learning.next()
    bench.until_step(Step.TRAVEL)
    assert second.travel is None


def test_going_back_from_the_review_keeps_the_ends(bench: Bench) -> None:
    bench.go_to_travel()
    bench.push_all()
    bench.learning.next()
    bench.learning.back()
    bench.until_step(Step.TRAVEL)
    assert all(c.travel is not None and c.travel.is_enough for c in bench.learning.channels)
    bench.learning.again()
    assert not any(c.travel is not None and c.travel.is_enough for c in bench.learning.channels)
    bench.learning.back()
    bench.until_step(Step.NEUTRAL)


def test_values_that_the_board_would_refuse_cannot_be_taken(bench: Bench) -> None:
    bench.go_to_travel()
    bench.push_all()
    bench.learning.next()
    (first, _) = bench.learning.channels
    assert first.choice is not None
    good = first.choice.calibration
    bench.learning.choose(1, type(good)(good.maximum + 1, good.neutral, good.maximum, 10))
    assert not bench.learning.can_take
    assert [problem.kind for problem in first.result_problems] == [Kind.REFUSED]
    bench.learning.choose(1, included=False)
    bench.until(lambda: bench.learning.can_take)
    bench.learning.take()
    assert bench.device.calibrations.shown(1) == bench.device.calibrations.stored(1)


def test_what_was_taken_and_written_asks_for_a_test(bench: Bench) -> None:
    stored: list[bool] = []
    bench.learning.stored.connect(lambda: stored.append(True))
    bench.go_to_travel()
    bench.push_all()
    bench.learning.next()
    bench.learning.take()
    bench.device.apply()
    bench.until(lambda: bool(stored))
    bench.learning.begin_test(bench.learning.numbers)
    bench.until_step(Step.TEST)
    assert bench.learning.tests is not None
    tests = bench.learning.tests
    assert not tests.passed
    bench.push_all()
    bench.until(lambda: tests.passed)
    assert "would release the motors" in tests.safe_start_text
    bench.person.put(1, 0.5)
    bench.until(lambda: "channel 1 gives +" in tests.safe_start_text)


def test_a_gap_in_the_measurements_is_said_and_is_no_rest(bench: Bench) -> None:
    bench.learning.begin((1,))
    bench.until_step(Step.NEUTRAL)
    bench.device.telemetry.blockSignals(True)
    bench.learning.next()
    bench.until(lambda: bench.learning.stalled)
    assert not bench.learning.can_go_on
    bench.device.telemetry.blockSignals(False)
    bench.until_step(Step.TRAVEL)


def test_whoever_stops_the_motors_is_told_once_whether_it_is_proved(bench: Bench) -> None:
    told: list[TrexError | None] = []
    bench.device.stop_motors(told.append)
    bench.until(lambda: bool(told))
    assert told == [None]
    bench.device.motors.stop()
    bench.until(lambda: not bench.device.may_move)
    bench.device.disconnect_line()
    bench.until(lambda: bench.device.link is Link.NONE)
    bench.device.stop_motors(told.append)
    assert len(told) == 2
    assert "No board is connected" in str(told[1])


# --- What was taken waits for being stored ----------------------------------------------


@pytest.fixture
def asked(bench: Bench) -> list[tuple[int, ...]]:
    """The channels whose test was asked for."""
    found: list[tuple[int, ...]] = []
    bench.learning.stored.connect(lambda: found.append(bench.learning.numbers))
    return found


def test_an_unrelated_apply_after_an_undo_asks_for_no_test(
    bench: Bench, asked: list[tuple[int, ...]]
) -> None:
    bench.to_review(1)
    bench.learning.take()
    bench.device.undo.undo()
    bench.device.parameters.edit("serial_timeout", 9)
    bench.write()
    assert bench.device.parameters.stored_of("serial_timeout") == 9
    assert asked == []


def test_discarding_what_was_taken_forgets_it_too(
    bench: Bench, asked: list[tuple[int, ...]]
) -> None:
    bench.to_review(1)
    bench.learning.take()
    bench.device.discard_edits()
    bench.device.parameters.edit("serial_timeout", 9)
    bench.write()
    assert asked == []


def test_an_apply_that_leaves_it_out_asks_for_no_test_and_a_later_one_does(
    bench: Bench, asked: list[tuple[int, ...]]
) -> None:
    bench.to_review(1)
    bench.learning.take()
    bench.device.parameters.edit("serial_timeout", 9)
    bench.device.apply({"serial_timeout"})
    bench.until(lambda: not bench.device.applying)
    assert asked == []
    bench.write()
    assert asked == [(1,)]


def test_another_line_forgets_what_was_taken(bench: Bench, asked: list[tuple[int, ...]]) -> None:
    bench.to_review(1)
    bench.learning.take()
    bench.device.disconnect_line()
    bench.until(lambda: bench.device.link is Link.NONE)
    bench.device.connect_to(LinkSettings(bench.simulator.url))
    bench.until(lambda: bench.device.link is Link.UP)
    assert bench.device.pending
    bench.write()
    assert bench.device.pending == 0
    assert asked == []


def test_motors_that_run_by_then_are_not_stopped(
    bench: Bench, asked: list[tuple[int, ...]]
) -> None:
    bench.to_review(1)
    bench.learning.take()
    bench.device.motors.arm()
    bench.device.motors.set_speed(1, 40)
    bench.until(lambda: bench.simulator.show()["motors"][0]["speed"] == 40)
    bench.write()
    assert asked == [(1,)]
    assert bench.learning.motors_armed  # whoever asks for the test has to be asked
    assert bench.learning.step is Step.ENDED
    assert bench.simulator.show()["motors"][0]["speed"] == 40
    bench.device.motors.stop()


def test_of_two_channels_the_one_that_was_written_gets_its_test(
    bench: Bench, asked: list[tuple[int, ...]]
) -> None:
    bench.to_review(1, 2)
    bench.learning.take()
    bench.device.apply({"rc_channel_2"})
    bench.until(lambda: not bench.device.applying)
    assert asked == [(2,)]
    bench.write()
    assert asked == [(2,), (1,)]


@pytest.mark.parametrize(
    ("failed", "expected"), [((2,), (1,)), ((1, 2), None), ((), (1, 2))], ids=str
)
def test_what_was_not_written_gets_no_test(
    bench: Bench,
    asked: list[tuple[int, ...]],
    failed: tuple[int, ...],
    expected: tuple[int, ...] | None,
) -> None:
    bench.to_review(1, 2)
    values = {c.number: c.choice.calibration for c in bench.learning.channels if c.choice}
    bench.learning.take()
    results = tuple(
        Written(f"channel {number}", error=NoReply("no answer"))
        if number in failed
        else Written(f"channel {number}", value)
        for number, value in values.items()
    )
    bench.device.calibrations.take_results(results)
    bench.device.applied.emit(results)
    assert asked == ([] if expected is None else [expected])


def test_values_that_are_stored_already_go_to_the_test_at_once(
    bench: Bench, asked: list[tuple[int, ...]]
) -> None:
    taken: list[bool] = []
    bench.learning.taken.connect(lambda: taken.append(True))
    bench.to_review(1)
    (channel,) = bench.learning.channels
    assert channel.stored is not None
    bench.learning.choose(1, channel.stored, reversed_=False)
    bench.learning.take()
    assert taken == []
    assert asked == [(1,)]
    bench.learning.begin_test(bench.learning.numbers)
    bench.until_step(Step.TEST)
    assert bench.learning.news == "These values are stored already."
    bench.learning.cancel()
    bench.learning.begin_test((1,))
    assert bench.learning.news == ""


def test_what_was_is_what_the_board_stores_whatever_edit_waits(bench: Bench) -> None:
    stored = bench.device.calibrations.stored(1)
    assert stored is not None
    bench.device.calibrations.edit(1, replace(stored, neutral=3800))
    bench.device.parameters.edit("reversed_channels", 1)
    bench.device.parameters.edit("serial_timeout", 9)
    bench.to_review(1)
    (channel,) = bench.learning.channels
    assert channel.stored == stored
    assert not channel.reversed_now
    assert channel.curve_before is not None
    assert not channel.curve_before.reversed_
    assert bench.learning.has_edit(1)
    assert bench.learning.other_edits == 1
    bench.device.parameters.edit("reversed_channels", 0b101)  # that of channel 3 stays
    assert bench.learning.other_edits == 2


@pytest.mark.parametrize("how", ["link", "mode", "motors"])
def test_a_test_that_ends_after_values_were_written_does_not_deny_them(
    bench: Bench, asked: list[tuple[int, ...]], how: str
) -> None:
    bench.to_review(1)
    bench.learning.take()
    bench.write()
    assert asked
    bench.learning.begin_test(bench.learning.numbers)
    bench.until_step(Step.TEST)
    if how == "motors":
        bench.device.motors.arm()
    elif how == "mode":
        bench.simulator.do("jumper mode rc")
        bench.simulator.do("power cycle")
    else:
        bench.simulator.do("line mute on")
    bench.until_step(Step.FAILED)
    assert "Nothing was changed" not in bench.learning.trouble
    assert "The test has ended; it changes nothing in the board" in bench.learning.trouble
    bench.device.motors.stop()


@pytest.mark.parametrize("step", [Step.NEUTRAL, Step.TRAVEL, Step.REVIEW, Step.TEST])
def test_a_board_that_was_without_power_is_stopped_again_before_it_goes_on(
    bench: Bench, step: Step
) -> None:
    if step is Step.TEST:
        bench.learning.begin_test((1,))
    elif step is Step.REVIEW:
        bench.to_review(1)
    elif step is Step.TRAVEL:
        bench.go_to_travel(1)
    else:
        bench.learning.begin((1,))
    bench.until_step(step)
    bench.simulator.do("power off")
    bench.until_step(Step.FAILED)
    bench.simulator.do("power on")
    bench.until(lambda: bench.device.link is Link.UP)
    assert not bench.learning.can_go_on
    assert not bench.learning.can_take
    bench.learning.again()
    assert bench.learning.step is Step.STOPPING
    bench.until_step(Step.TEST if step is Step.TEST else Step.NEUTRAL)
