"""The board as the window sees it: a real thread, a real line, a simulated board."""

import math
import sys
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from tests.support.simulator import SimulatedDevice, StartSimulator
from trex_gui.link.settings import LinkSettings
from trex_gui.link.writing import Written
from trex_gui.model.device import Device, Link
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.flags import Status, UartError
from trex_gui.protocol.line_settings import LineSettings
from trex_gui.runtime import now

if sys.platform == "win32":
    pytest.skip("has no pseudo-terminals", allow_module_level=True)

LEARNED = Calibration(2400, 3700, 5100, 80)

TRIES = 4
"""How often is tried what a computer that stands still for a moment spoils."""


class Watched:
    """A device, and what it announced."""

    def __init__(self, qtbot: QtBot) -> None:
        self.device = Device()
        self.links: list[Link] = []
        self.failures: list[str] = []
        self.results: list[tuple[Written, ...]] = []
        self.steps: list[tuple[int, int, str]] = []
        self.device.link_changed.connect(self._on_link_changed)
        self.device.failed.connect(self.failures.append)
        self.device.applied.connect(self.results.append)
        self.device.progressed.connect(self._on_progressed)
        self.qtbot = qtbot

    def _on_link_changed(self) -> None:
        self.links.append(self.device.link)

    def _on_progressed(self, done: int, total: int, what: str) -> None:
        self.steps.append((done, total, what))

    def until(self, condition: Callable[[], bool]) -> None:
        self.qtbot.waitUntil(condition)

    def until_link(self, link: Link) -> None:
        self.until(lambda: self.device.link is link)

    def connect(self, url: str, *, again: bool = False) -> None:
        self.device.connect_to(LinkSettings(url))
        if again:
            self.until(lambda: self.device.link is not Link.UP)
        failed = len(self.failures)
        self.until(lambda: self.device.link is Link.UP or len(self.failures) > failed)
        assert self.device.link is Link.UP, self.failures[failed:]

    def edit(self, key: str, wire: int) -> None:
        assert self.device.parameters.setData(self.device.parameters.index_of(key), wire)

    def apply(self) -> tuple[Written, ...]:
        """Apply every edit; return how it went."""
        before = len(self.results)
        self.device.apply()
        self.until(lambda: len(self.results) > before)
        return self.results[-1]


@pytest.fixture
def watched(qtbot: QtBot) -> Iterator[Watched]:
    watched = Watched(qtbot)
    yield watched
    qtbot.waitUntil(watched.device.shut_down)  # no thread lives on


@pytest.fixture
def up(watched: Watched, quick_simulator: SimulatedDevice) -> Watched:
    """A device that is connected to `quick_simulator`."""
    watched.connect(quick_simulator.url)
    return watched


# --- Connecting -------------------------------------------------------------------------


def test_before_a_connection_nothing_is_known(watched: Watched) -> None:
    device = watched.device
    assert device.link is Link.NONE
    assert device.state is None
    assert device.settings is None
    assert not device.motors.can_arm


def test_a_connection_brings_everything(up: Watched, quick_simulator: SimulatedDevice) -> None:
    device = up.device
    assert up.links == [Link.OPENING, Link.UP]
    assert "Connected to TReX 1.2" in device.status
    assert device.state is not None
    assert device.state.parameters == quick_simulator.show()["parameters"]
    assert device.calibrations.stored(1) == device.state.calibrations[1]
    assert device.telemetry.serial_controls is True
    assert device.motors.can_arm
    assert not device.motors.armed
    assert not device.echo
    assert up.steps[-1][0] == up.steps[-1][1]
    assert up.failures == []


def test_values_come_in_by_themselves(up: Watched, quick_simulator: SimulatedDevice) -> None:
    quick_simulator.do("channel 1 2000us")
    quick_simulator.do("current 1 3.0")
    telemetry = up.device.telemetry
    up.until(lambda: telemetry.raw_of(1) == 5000)
    up.until(lambda: telemetry.motor_currents == pytest.approx((3.0, 0.0)))
    up.until(lambda: telemetry.remapped_of(1) == 127)
    assert len(telemetry.currents) > 0
    assert up.device.counters.requests > 0


def test_the_rs232_side_is_known(watched: Watched, start_simulator: StartSimulator) -> None:
    watched.connect(start_simulator("--echo").url)
    assert watched.device.echo


def test_a_port_that_is_not_there_is_told(watched: Watched) -> None:
    watched.device.connect_to(LinkSettings("/dev/ttyNothing9"))
    watched.until_link(Link.NONE)
    assert watched.links == [Link.OPENING, Link.NONE]
    assert len(watched.failures) == 1
    assert "There is no port /dev/ttyNothing9" in watched.failures[0]
    assert watched.device.status == "Not connected."


def test_a_board_without_power_is_told(watched: Watched, quick_simulator: SimulatedDevice) -> None:
    quick_simulator.do("power off")
    watched.device.connect_to(LinkSettings(quick_simulator.url))
    watched.until_link(Link.NONE)
    assert "No TReX answers" in watched.failures[0]


def test_errors_of_the_board_are_counted(up: Watched, quick_simulator: SimulatedDevice) -> None:
    def count(bit: Status | UartError) -> int:
        return next(one.count for one in up.device.errors.entries if one.bit is bit)

    seen = 0
    for _ in range(2):
        quick_simulator.do("fault 2 on")
        quick_simulator.do("fault 2 off")  # as often as it was looked at meanwhile, it counts
        up.until(lambda: count(Status.MOTOR2_FAULT) > seen)  # noqa: B023
        seen = count(Status.MOTOR2_FAULT)
    assert count(Status.MOTOR1_FAULT) == 0


# --- Editing ----------------------------------------------------------------------------


def test_an_edit_is_applied_and_proved(up: Watched, quick_simulator: SimulatedDevice) -> None:
    up.edit("serial_timeout", 15)
    up.device.calibrations.edit(2, LEARNED)
    assert up.device.pending == 2
    results = up.apply()
    assert set(results) == {Written("channel 2", LEARNED), Written("serial_timeout", 15)}
    assert up.device.pending == 0
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 15
    assert up.device.calibrations.stored(2) == LEARNED


def test_what_the_board_stored_is_kept_before_it_is_changed(up: Watched) -> None:
    up.edit("serial_timeout", 15)
    up.edit("motor_mode", 1)
    up.apply()
    (snapshot,) = up.device.history.snapshots()
    assert snapshot.product == "TReX"
    assert snapshot.reason == "Apply of 2 settings"
    assert snapshot.adapter
    kept = up.device.history.load(snapshot)
    assert kept.parameters["serial_timeout"] == 0
    assert kept.parameters["motor_mode"] == 0
    assert len(kept.calibrations) == 5


def test_without_a_snapshot_nothing_is_written(
    up: Watched, quick_simulator: SimulatedDevice, tmp_path: Path
) -> None:
    (tmp_path / "taken").write_text("a file where the folder should be", encoding="utf-8")
    up.device.history.folder = tmp_path / "taken"
    up.edit("serial_timeout", 15)
    up.device.apply()
    assert "Nothing was written" in up.failures[-1]
    assert up.device.pending == 1
    assert not up.device.applying
    assert quick_simulator.show()["parameters"]["serial_timeout"] == 0


def test_nothing_to_apply_is_nothing_done(up: Watched) -> None:
    up.device.apply()
    up.device.reload()
    steps = len(up.steps)
    up.until(lambda: len(up.steps) > steps and up.steps[-1][0] == up.steps[-1][1])
    assert up.results == []


def test_a_refused_write_stays_an_edit_and_says_why(
    watched: Watched, start_simulator: StartSimulator
) -> None:
    watched.connect(start_simulator("--mode", "rc").url)
    watched.edit("serial_timeout", 15)
    (result,) = watched.apply()
    assert "remove the mode jumper" in str(result.error)
    assert watched.device.pending == 1


def test_reading_again_shows_what_somebody_else_has_written(
    up: Watched, start_simulator: StartSimulator
) -> None:
    up.edit("serial_timeout", 15)
    up.apply()
    up.device.reload()
    states: list[object] = []
    up.device.state_changed.connect(lambda: states.append(up.device.state))
    up.until(lambda: bool(states))
    assert up.device.parameters.stored_of("serial_timeout") == 15


def test_what_is_asked_without_a_board_fails_in_words(watched: Watched) -> None:
    watched.device.reload()
    assert watched.failures == ["No board is connected."]


def test_edits_are_discarded_together(up: Watched) -> None:
    up.edit("serial_timeout", 15)
    up.device.calibrations.edit(2, LEARNED)
    counts: list[int] = []
    up.device.pending_changed.connect(counts.append)
    up.device.discard_edits()
    assert counts[-1] == 0
    assert up.device.pending == 0


# --- Power ------------------------------------------------------------------------------


def test_what_waits_for_the_power_acts_after_a_power_cycle(
    up: Watched, quick_simulator: SimulatedDevice
) -> None:
    up.edit("motor_mode", 1)
    up.apply()
    assert up.device.parameters.waiting_for_power == ("Motor Mode",)
    assert up.device.parameters.active_of("motor_mode") == 0
    quick_simulator.do("power off")
    up.until_link(Link.SILENT)
    waiting = [up.device.parameters.waiting_for_power]
    quick_simulator.do("power on")
    up.until_link(Link.UP)
    waiting.append(up.device.parameters.waiting_for_power)
    assert waiting == [("Motor Mode",), ()]
    assert up.device.parameters.active_of("motor_mode") == 1
    assert up.failures == []


def test_a_board_without_power_can_neither_be_driven_nor_edited(
    up: Watched, quick_simulator: SimulatedDevice
) -> None:
    up.device.motors.arm()
    quick_simulator.do("power off")
    up.until_link(Link.SILENT)
    assert not up.device.motors.armed
    assert not up.device.motors.can_arm
    model = up.device.parameters
    assert not model.setData(model.index_of("serial_timeout"), 9)
    assert up.device.telemetry.raw is None
    assert "power" in up.device.status


def test_edits_outlive_a_power_cycle(up: Watched, quick_simulator: SimulatedDevice) -> None:
    up.edit("serial_timeout", 15)
    quick_simulator.do("power off")
    up.until_link(Link.SILENT)
    quick_simulator.do("power on")
    up.until_link(Link.UP)
    assert up.device.parameters.pending == (("serial_timeout", 15),)


def test_another_mode_is_noticed(up: Watched, quick_simulator: SimulatedDevice) -> None:
    quick_simulator.do("jumper mode rc")
    quick_simulator.do("power cycle")
    up.until(lambda: up.device.state is not None and not up.device.state.mode.is_serial)
    assert up.device.telemetry.serial_controls is False


# --- Motors -----------------------------------------------------------------------------


def speed(simulator: SimulatedDevice) -> tuple[str, int]:
    motor = simulator.show()["motors"][0]
    return motor["direction"], motor["speed"]


def test_armed_motors_obey_and_a_stop_brakes_them(
    up: Watched, quick_simulator: SimulatedDevice
) -> None:
    motors = up.device.motors
    motors.accelerate = False
    motors.arm()
    motors.set_speed(1, 90)
    up.until(lambda: speed(quick_simulator) == ("forward", 90))
    motors.stop()
    up.until(lambda: speed(quick_simulator) == ("brake", 127))
    assert up.failures == []


def test_a_stop_without_arming_is_sent_as_well(
    up: Watched, quick_simulator: SimulatedDevice
) -> None:
    before = quick_simulator.show()["motors"][1]["speed"]
    up.device.motors.stop()
    up.until(lambda: quick_simulator.show()["motors"][1]["speed"] == 127)
    assert before != 127 or up.failures == []


def test_a_stop_that_nobody_answers_is_told(up: Watched, quick_simulator: SimulatedDevice) -> None:
    quick_simulator.do("power off")
    up.device.motors.stop()
    up.until(lambda: bool(up.failures))
    assert "cut its power" in up.failures[0]


def test_a_stop_without_a_line_does_no_harm(watched: Watched) -> None:
    watched.device.motors.stop()
    assert watched.failures == []


def test_disconnecting_stops_the_motors(up: Watched, quick_simulator: SimulatedDevice) -> None:
    motors = up.device.motors
    motors.accelerate = False
    motors.arm()
    motors.set_speed(1, 90)
    up.until(lambda: speed(quick_simulator) == ("forward", 90))
    up.device.disconnect_line()
    assert not motors.armed
    up.until_link(Link.NONE)
    up.until(lambda: speed(quick_simulator) == ("brake", 127))


def test_motors_that_the_channels_drive_cannot_be_armed(
    watched: Watched, start_simulator: StartSimulator
) -> None:
    watched.connect(start_simulator("--mode", "rc").url)
    assert not watched.device.motors.can_arm
    watched.device.motors.arm()
    assert not watched.device.motors.armed
    assert "The RC channels control the motors" in watched.device.control_text


def test_driven_motors_may_move_until_a_stop_is_proved(
    up: Watched, quick_simulator: SimulatedDevice
) -> None:
    moving: list[bool] = [up.device.may_move]
    up.device.motors.arm()
    up.device.motors.set_speed(1, 90)
    moving.append(up.device.may_move)
    up.device.motors.stop()
    up.until(lambda: not up.device.may_move)
    assert moving == [False, True]


def test_motors_that_ran_when_the_cable_was_pulled_are_stopped_first_of_all(
    up: Watched, quick_simulator: SimulatedDevice
) -> None:
    motors = up.device.motors
    motors.accelerate = False
    motors.arm()
    motors.set_speed(1, 90)
    up.until(lambda: speed(quick_simulator) == ("forward", 90))
    quick_simulator.do("line unplug")
    up.until_link(Link.NONE)
    assert up.device.may_move
    assert speed(quick_simulator) == ("forward", 90)
    up.connect(quick_simulator.do("line plug").split()[-1])
    assert speed(quick_simulator) == ("brake", 127)
    up.until(lambda: not up.device.may_move)


# --- The end of a line ------------------------------------------------------------------


def test_disconnecting_is_no_failure(up: Watched) -> None:
    up.device.disconnect_line()
    up.device.disconnect_line()
    assert up.device.link is Link.CLOSING
    up.until_link(Link.NONE)
    assert up.links.count(Link.NONE) == 1
    assert up.failures == []
    assert up.device.state is None
    assert up.device.status == "Not connected."
    assert up.device.telemetry.raw is None
    assert up.device.parameters.rowCount() > 0  # still to be looked at


def test_a_pulled_cable_is_told_at_once(up: Watched, quick_simulator: SimulatedDevice) -> None:
    def take() -> float:
        up.device.motors.arm()
        quick_simulator.do("line unplug")
        begun = now()
        up.until_link(Link.NONE)
        took = now() - begun
        assert len(up.failures) == 1
        assert "Plug it in, then connect again" in up.failures.pop()
        assert not up.device.motors.can_arm
        up.connect(quick_simulator.do("line plug").split()[-1])
        return took

    assert any(take() < 0.5 for _ in range(TRIES))


def test_a_pulled_cable_during_a_write_keeps_the_edits(
    up: Watched, quick_simulator: SimulatedDevice
) -> None:
    for key in ("serial_timeout", "motor1_acceleration", "motor2_acceleration"):
        up.edit(key, 15)
    quick_simulator.do("line unplug")
    up.device.apply()
    up.until_link(Link.NONE)
    assert any("Plug it in, then connect again" in failure for failure in up.failures)
    assert up.device.pending == 3
    assert not up.device.applying


def test_a_cable_that_is_plugged_in_again_can_be_connected_to(
    up: Watched, quick_simulator: SimulatedDevice
) -> None:
    up.edit("serial_timeout", 15)
    quick_simulator.do("line unplug")
    up.until_link(Link.NONE)
    url = quick_simulator.do("line plug").split()[-1]
    up.connect(url)
    assert up.device.parameters.pending == (("serial_timeout", 15),)
    assert up.apply() == (Written("serial_timeout", 15),)


def test_one_line_is_closed_before_another_is_opened(
    up: Watched,
    quick_simulator: SimulatedDevice,
    start_simulator: StartSimulator,
) -> None:
    up.edit("serial_timeout", 15)
    other = start_simulator("--model", "trexjr")
    up.connect(other.url, again=True)
    assert up.links == [Link.OPENING, Link.UP, Link.CLOSING, Link.OPENING, Link.UP]
    assert up.device.state is not None
    assert up.device.state.signature.model.key == "trexjr"
    assert up.device.parameters.pending == ()
    assert up.failures == []
    fresh = Watched(up.qtbot)
    fresh.connect(quick_simulator.url)  # nobody holds it any more
    fresh.until(fresh.device.shut_down)


def test_the_last_choice_of_several_is_connected_to(
    up: Watched, start_simulator: StartSimulator
) -> None:
    other = start_simulator("--model", "trexjr")
    up.device.connect_to(LinkSettings("/dev/ttyNothing9"))
    up.connect(other.url, again=True)
    assert up.device.settings == LinkSettings(other.url)
    assert up.failures == []


def test_a_wrong_choice_after_a_good_one_is_told(up: Watched) -> None:
    up.device.connect_to(LinkSettings("/dev/ttyNothing9"))
    up.until_link(Link.NONE)
    assert "There is no port" in up.failures[0]


def test_shutting_down_ends_within_a_second(up: Watched, quick_simulator: SimulatedDevice) -> None:
    def take() -> float:
        if up.device.link is Link.NONE:
            up.connect(quick_simulator.url)
        motors = up.device.motors
        motors.accelerate = False
        motors.arm()
        motors.set_speed(1, 90)
        up.until(lambda: speed(quick_simulator) == ("forward", 90))
        begun = now()
        in_time = up.device.shut_down()
        took = now() - begun
        assert up.device.link is Link.NONE
        up.until(up.device.shut_down)
        up.until(lambda: speed(quick_simulator) == ("brake", 127))
        return took if in_time else math.inf

    assert any(take() < 1.0 for _ in range(TRIES))


def test_shutting_down_without_a_line_is_done_at_once(watched: Watched) -> None:
    assert watched.device.shut_down()
    assert watched.links == []


def test_what_a_closed_line_still_reports_changes_nothing(up: Watched, qtbot: QtBot) -> None:
    up.until(up.device.shut_down)
    links = list(up.links)
    states: list[None] = []
    up.device.telemetry.updated.connect(lambda: states.append(None))
    with pytest.raises(qtbot.TimeoutError):
        qtbot.waitUntil(lambda: up.links != links or bool(states), timeout=200)
    assert up.links == links
    assert up.failures == []
    assert up.device.state is None


def test_line_settings_reach_the_line(watched: Watched, quick_simulator: SimulatedDevice) -> None:
    watched.device.connect_to(LinkSettings(quick_simulator.url, LineSettings(9600)))
    watched.until_link(Link.NONE)
    assert "9600 baud" in watched.failures[0]
