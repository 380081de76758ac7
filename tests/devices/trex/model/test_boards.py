"""Several boards on one line."""

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any
from urllib.parse import quote

import pytest
from pytestqt.qtbot import QtBot

from tests.devices.trex.model.device_setup import DeviceSetup
from tests.support.pads import PAD, HeldPads
from tests.support.pages.motors import is_stopped
from tests.support.simulator import SimulatedDevice, StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.devices.trex.bench.run import Plan, Profile
from trex_gui.devices.trex.model.apply_to_boards import ApplyToBoards, BoardStep
from trex_gui.devices.trex.model.bench import Bench
from trex_gui.devices.trex.model.boards import BoardList, Presence
from trex_gui.devices.trex.model.gamepad import Gamepad
from trex_gui.devices.trex.model.learning.learning import Learning, LearningStep
from trex_gui.devices.trex.model.setup.robot_setup import RobotSetup
from trex_gui.devices.trex.model.setup.wiring import Movement
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.protocol.device_table import device_table
from trex_gui.devices.trex.settings.document import Settings
from trex_gui.devices.trex.simulator.line import SimulatedBoards
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.preferences import Preferences


class LineHarness(DeviceSetup):
    """Device on a line with several boards, and its messages."""

    def __init__(self, qtbot: QtBot, simulator: SimulatedDevice) -> None:
        super().__init__(qtbot, simulator)
        self.boards = BoardList(self.device)
        self.errors: list[str] = []
        self.infos: list[str] = []
        self.device.notifier.error.connect(self.errors.append)
        self.device.notifier.info.connect(self.infos.append)

    @property
    def line(self) -> SimulatedBoards:
        assert isinstance(self.simulator, VirtualSimulator)
        line = self.simulator.line
        assert isinstance(line, SimulatedBoards)
        return line

    def connect_number(self, number: int | None) -> None:
        self.device.connect_to(ConnectionSettings(self.simulator.url, device_number=number))
        self.until(lambda: self.device.is_connected and self.device.motors.is_available)

    def connect_known(self, number: int, *known: int) -> None:
        """Connect to a board. An earlier scan has found it and the `known` boards."""
        key = f"boards/{quote(self.simulator.url, safe='')}"
        Preferences().set(key, ",".join(map(str, (number, *known))))
        self.connect_number(number)

    def scan(self) -> None:
        self.boards.scan()
        self.until(lambda: self.boards.scanned is None and not self.boards.is_selecting)

    def select(self, number: int) -> None:
        done: list[object] = []
        self.boards.select(number, done.append)
        self.until(lambda: done)

    def stored(self, key: str) -> list[int]:
        """Return the stored value of a parameter of each board."""
        return [board.eeprom[key] for board in self.line.boards]

    def show(self, number: int) -> dict[str, Any]:
        return self.simulator.show(f"@{number}" if len(self.line.boards) > 1 else "")

    def is_stopped(self, number: int) -> bool:
        return is_stopped(self.simulator, f"@{number}")

    @property
    def presences(self) -> dict[int, Presence]:
        return {board.number: board.presence for board in self.boards.boards}


@pytest.fixture
def new_line(
    start_simulator: StartSimulator, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> Iterator[Callable[..., LineHarness]]:
    """Return a function that creates a line of boards with these numbers, below 16."""
    lines: list[LineHarness] = []

    def new_line(*boards: str) -> LineHarness:
        monkeypatch.setattr("trex_gui.devices.trex.model.boards.NUMBERS", 16)
        options = [word for board in boards for word in ("--device", board)]
        lines.append(LineHarness(qtbot, start_simulator("--unpaced", *options)))
        return lines[-1]

    yield new_line
    for line in lines:
        line.shut_down()
        line.device.edit_backup.files.shut_down()


NewLine = Callable[..., LineHarness]


# --- Scan -------------------------------------------------------------------------------


def test_scan_finds_each_board_by_number(new_line: NewLine) -> None:
    harness = new_line("3", "7", "12:trexjr")
    harness.connect_number(7)
    assert not harness.boards.has_several
    harness.scan()
    assert harness.presences == {
        3: Presence.RESPONDING,
        7: Presence.SELECTED,
        12: Presence.RESPONDING,
    }
    assert [str(board.signature) for board in harness.boards.boards] == [
        "TReX 1.2",
        "TReX 1.2",
        "TReX Jr 1.2",
    ]
    assert harness.infos == ["3 boards on this line."]
    assert not harness.device.board.quality.is_noisy


def test_presence_follows_a_board_that_is_switched_off_and_on(new_line: NewLine) -> None:
    harness = new_line("3", "7")
    harness.connect_known(7, 3)
    harness.simulator.do("@3 power off")
    harness.until(lambda: harness.presences[3] is Presence.SILENT)
    harness.simulator.do("@3 power on")
    harness.until(lambda: harness.presences[3] is Presence.RESPONDING)
    harness.disconnect()
    assert set(harness.presences.values()) == {Presence.UNKNOWN}


def test_boards_of_a_scan_are_listed_at_the_next_start(new_line: NewLine) -> None:
    harness = new_line("3", "7")
    harness.connect_number(7)
    harness.scan()
    harness.boards = BoardList(harness.device)
    harness.connect_number(3)
    assert harness.presences == {3: Presence.SELECTED, 7: Presence.UNKNOWN}
    harness.until(lambda: harness.presences[7] is Presence.RESPONDING)


def test_connection_without_a_number_expects_a_single_board(new_line: NewLine) -> None:
    harness = new_line("3", "7")
    harness.connect_known(7, 3)
    harness.simulator.do("@3 power off")
    harness.connect_number(None)
    assert not harness.presences
    assert harness.device.motors.can_arm


def test_scan_of_a_single_board_explains_missing_boards(new_line: NewLine) -> None:
    harness = new_line("7")
    harness.connect_number(None)
    harness.scan()
    assert not harness.boards.has_several
    assert "No other board replies" in harness.infos[-1]
    assert harness.device.settings is not None
    assert harness.device.settings.device_number is None


def test_commands_have_a_number_after_a_scan_finds_two_boards(new_line: NewLine) -> None:
    harness = new_line("7", "9")
    harness.simulator.do("@9 power off")
    harness.connect_number(None)
    harness.simulator.do("@9 power on")
    harness.scan()
    assert harness.device.settings is not None
    assert harness.device.settings.device_number == 7
    harness.until(lambda: harness.device.motors.is_available)
    harness.device.motors.arm()
    harness.device.motors.set_speed(1, 20)
    harness.until(lambda: harness.show(7)["motors"][0]["target_speed"])
    assert not harness.show(9)["motors"][0]["target_speed"]


def test_nothing_is_sent_to_several_boards_at_once(new_line: NewLine) -> None:
    harness = new_line("3", "7", "9")
    device = harness.device
    harness.simulator.do("@3 power off", "@9 power off")
    harness.connect_number(None)
    harness.simulator.do("@3 power on", "@9 power on")
    harness.boards.scan()
    harness.until(lambda: harness.boards.has_several)
    assert not device.motors.can_arm
    harness.boards.cancel_scan()
    harness.until(lambda: harness.boards.can_scan)
    assert not device.motors.can_arm
    assert not device.writer.can_apply
    device.writer.set_serial_timeout(2)
    device.parameters.edit("motor1_acceleration", 9)
    device.writer.apply()
    device.writer.reset_to_factory()
    assert not device.writer.running
    harness.until(lambda: len(harness.errors) == 3)
    assert all("the write would reach every board" in error for error in harness.errors)
    # A review selects a board by its number.
    ApplyHarness(harness).review_and_wait(settings_of(serial_timeout=5), 7)
    assert device.settings is not None
    assert device.settings.device_number == 7
    harness.until(lambda: device.motors.can_arm)
    assert device.writer.can_apply


def test_scan_probes_every_number(new_line: NewLine) -> None:
    harness = new_line("0", "7", "9")
    harness.connect_number(7)
    harness.boards.scan()
    harness.until(lambda: harness.boards.scanned == 1)
    harness.boards.cancel_scan()
    harness.boards.boards = ()
    harness.scan()
    assert set(harness.presences) == {0, 7, 9}
    # The scan is complete even if it starts while the presence of a board is probed.
    harness.simulator.do("@9 power off")
    harness.until(lambda: harness.boards.is_probing)
    harness.scan()
    assert set(harness.presences) == {0, 7}


def test_arming_ends_a_scan_and_prevents_another(new_line: NewLine) -> None:
    harness = new_line("7", "9")
    harness.connect_number(7)
    harness.boards.scan()
    harness.until(lambda: (harness.boards.scanned or 0) > 10)
    harness.device.motors.arm()
    assert harness.boards.scanned is None
    harness.boards.scan()
    assert harness.boards.scanned is None
    assert harness.device.motors.armed


# --- Selection --------------------------------------------------------------------------


def test_selecting_another_board_ends_held_controls(new_line: NewLine) -> None:
    """Bench, setup and gamepad are held while another board is selected."""
    harness = new_line("7", "9")
    harness.connect_number(7)
    device, motors, pads = harness.device, harness.device.motors, HeldPads(PAD)
    motors.lockout = 0
    bench, gamepad = Bench(device), Gamepad(device, pads)
    bench.set_plan(Plan(profile=Profile(speed=40, duration=60.0)))
    setup = RobotSetup(device, Learning(device))
    pulses = setup.pulses

    def runs(number: int) -> bool:
        return any(motor["direction"] != "brake" for motor in harness.show(number)["motors"])

    def hold_gamepad() -> None:
        gamepad.switch_on()  # selecting a board switches the gamepad off
        harness.until(lambda: gamepad.text.startswith("Hold"))
        pads.press(4)
        harness.until(lambda: gamepad.request.drives)
        pads.move(1, -1.0)

    holds: tuple[tuple[str, Callable[[], object]], ...] = (
        ("bench", bench.start),
        ("setup", lambda: pulses.start(1)),
        ("gamepad", hold_gamepad),
    )
    for (holder, hold), (first, second) in zip(holds, [(7, 9), (9, 7), (7, 9)], strict=True):
        harness.until(lambda: device.telemetry.motor_currents is not None and motors.can_arm)
        pulses.confirm_wheels(True)
        setup.record_movement(1, Movement.LEFT_FORWARD)
        motors.arm()
        hold()
        harness.until(partial(runs, first))
        assert motors.holder == holder
        harness.select(second)
        assert harness.is_stopped(first), holder
        assert not device.driving.lost_board
        harness.until(lambda: motors.can_arm)
        motors.arm()
        harness.pass_time(2)
        assert not runs(second), holder
        assert not motors.holder
        assert not pulses.wheels_are_free
        assert not setup.movements
        motors.stop()
    assert bench.runs[-1].reason == "Another board was selected."
    gamepad.switch_off()
    assert not harness.errors


def test_selecting_another_board_ends_measurements_of_sticks(new_line: NewLine) -> None:
    harness = new_line("7", "9")
    harness.connect_known(9, 7)
    device = harness.device
    learning = Learning(device)
    for _ in range(3):
        device.mix_jumper.feed((60, 0), (60, -60))
    harness.until(lambda: device.mix_jumper.is_on)
    learning.start()
    harness.until(lambda: learning.step is LearningStep.NEUTRAL)
    harness.select(7)
    assert device.mix_jumper.is_on is None
    assert learning.step is LearningStep.FAILED
    assert learning.problem == "Another board was selected. Nothing was changed."
    assert not harness.errors


def test_edits_return_with_their_board(new_line: NewLine) -> None:
    harness = new_line("7", "9")
    device = harness.device
    harness.connect_known(7, 9)
    device.parameters.edit("serial_timeout", 5)
    device.parameters.edit("crc7_polynomial", 0x11)
    harness.select(9)
    assert device.draft.pending == 0
    assert not device.draft.undo.canUndo()
    device.parameters.edit("serial_timeout", 9)
    harness.select(7)
    assert dict(device.parameters.values.pending) == {"serial_timeout": 5, "crc7_polynomial": 0x11}
    # Written values that need a power cycle stay known as waiting.
    device.writer.apply()
    harness.until(lambda: device.draft.pending == 0 and not device.writer.running)
    waiting = device.parameters.values.waiting_for_power
    assert waiting
    harness.select(9)
    assert dict(device.parameters.values.pending) == {"serial_timeout": 9}
    assert not device.parameters.values.waiting_for_power
    harness.select(7)
    assert device.parameters.values.waiting_for_power == waiting
    assert device.edit_backup.offer is None
    assert any("returns" in info or "return when" in info for info in harness.infos)


# --- Device numbers ---------------------------------------------------------------------


def test_board_gets_only_a_free_number(new_line: NewLine) -> None:
    harness = new_line("7", "9")
    harness.connect_number(7)
    harness.scan()
    harness.device.writer.set_device_number(9)
    harness.until(lambda: any("has the device number 9" in error for error in harness.errors))
    assert not harness.device.writer.running
    assert harness.show(7)["parameters"]["device_number"] == 7
    harness.device.writer.set_device_number(12)
    harness.until(lambda: harness.boards.selected == 12 and not harness.device.writer.running)
    assert harness.stored("device_number") == [12, 9]
    assert harness.presences == {9: Presence.RESPONDING, 12: Presence.SELECTED}
    harness.select(9)
    harness.select(12)
    assert harness.device.is_connected


# --- Settings for several boards --------------------------------------------------------


def settings_of(**parameters: int) -> Settings:
    return Settings(device_table().models[0], "1.2", parameters)


class ApplyHarness(ApplyToBoards):
    """Settings that are written to boards of a line."""

    def __init__(self, harness: LineHarness) -> None:
        super().__init__(harness.boards, harness.device, harness.device)
        self._harness = harness

    def review_and_wait(self, settings: Settings, *numbers: int) -> None:
        self.review(settings, numbers)
        self._harness.until(lambda: not self.is_running)

    def write_and_wait(self, *numbers: int) -> None:
        self.write(numbers)
        self._harness.until(lambda: not self.is_running)

    @property
    def steps(self) -> dict[int, BoardStep]:
        return {plan.number: plan.step for plan in self.plans}


def test_settings_are_written_to_several_boards(new_line: NewLine) -> None:
    harness = new_line("3", "7", "9:trexjr", "12")
    harness.connect_known(7, 3, 9, 12)
    harness.simulator.do("@12 power off")
    harness.device.parameters.edit("motor1_acceleration", 9)
    apply = ApplyHarness(harness)
    settings = settings_of(device_number=55, uart_settings=10, serial_timeout=5, ignored_channels=2)
    apply.review_and_wait(settings, 3, 7, 9, 12)
    assert harness.boards.selected == 7
    assert apply.steps == {
        3: BoardStep.REVIEWED,
        7: BoardStep.REVIEWED,
        9: BoardStep.FAILED,
        12: BoardStep.FAILED,
    }
    assert harness.presences[12] is Presence.SILENT
    assert [plan.to_write for plan in apply.plans] == [2, 2, 0, 0]
    assert "are for a TReX" in apply.plans[2].problem
    assert "does not respond" in apply.plans[3].problem
    assert harness.stored("serial_timeout") == [0] * 4

    apply.write_and_wait(3, 7)
    assert [apply.steps[number] for number in (3, 7)] == [BoardStep.WRITTEN] * 2
    assert harness.boards.selected == 7
    assert harness.stored("device_number") == [3, 7, 9, 12]
    assert harness.stored("serial_timeout") == [5, 5, 0, 0]
    assert harness.stored("uart_settings") == [5] * 4
    assert dict(harness.device.parameters.values.pending) == {"motor1_acceleration": 9}
    history = harness.device.writer.history
    saved = [history.load(snapshot) for snapshot in history.snapshots()]
    assert {settings.parameters["device_number"] for settings in saved} == {3, 7}


def test_plan_has_the_doubts_and_findings_of_each_board(new_line: NewLine) -> None:
    harness = new_line("3", "7")
    harness.connect_known(7, 3)
    harness.line.boards[0].eeprom.write("ignored_channels", 63)
    harness.simulator.do("@3 power cycle")
    apply = ApplyHarness(harness)
    apply.review_and_wait(settings_of(ignored_channels=63, serial_timeout=5), 3, 7)
    assert [plan.doubts for plan in apply.plans] == [(), ("Ignored Channels 63",)]
    harness.line.boards[0].eeprom.write("ignored_channels", 2)
    apply.review_and_wait(settings_of(required_channels=3), 3, 7)
    assert [[finding.keys for finding in plan.findings] for plan in apply.plans] == [
        [("required_channels", "ignored_channels")],
        [],
    ]


def test_review_continues_after_the_selected_board_if_it_is_silent(new_line: NewLine) -> None:
    harness = new_line("3", "7")
    harness.connect_known(3, 7)
    harness.simulator.do("@3 power off")
    harness.until_link(ConnectionState.NOT_RESPONDING)
    apply = ApplyHarness(harness)
    apply.review_and_wait(settings_of(serial_timeout=5), 3, 7)
    assert apply.steps == {3: BoardStep.FAILED, 7: BoardStep.REVIEWED}
    assert "does not respond" in apply.plans[0].problem


def test_first_error_while_writing_ends_the_apply(new_line: NewLine) -> None:
    harness = new_line("3", "7", "9")
    harness.connect_known(9, 3, 7)
    apply = ApplyHarness(harness)
    apply.review_and_wait(settings_of(serial_timeout=5), 3, 7, 9)
    harness.line.boards[0].eeprom.write("serial_timeout", 8)  # by another program
    harness.simulator.do("@3 power cycle")

    def cut_power() -> None:
        if apply.steps[7] is BoardStep.WRITING:
            harness.simulator.do("@7 power off")

    apply.changed.connect(cut_power)
    apply.write_and_wait(3, 7, 9)
    assert apply.steps == {3: BoardStep.FAILED, 7: BoardStep.FAILED, 9: BoardStep.SKIPPED}
    assert "have changed since the review" in apply.plans[0].problem
    timeouts = harness.stored("serial_timeout")
    assert (timeouts[0], timeouts[2]) == (8, 0)
    assert harness.boards.selected == 9


def test_closed_line_ends_the_review(new_line: NewLine) -> None:
    harness = new_line("3", "7", "9")
    harness.connect_known(7, 3, 9)
    apply = ApplyHarness(harness)
    apply.review(settings_of(serial_timeout=5), (3, 7, 9))
    harness.until(lambda: apply.steps[3] is BoardStep.READING)
    harness.connect_number(7)  # the line is closed and opened again
    assert not apply.is_running
    assert apply.steps == {3: BoardStep.FAILED, 7: BoardStep.SKIPPED, 9: BoardStep.SKIPPED}


def test_apply_is_cancelled_between_boards(new_line: NewLine) -> None:
    harness = new_line("3", "7", "9")
    harness.connect_known(7, 3, 9)
    apply = ApplyHarness(harness)
    apply.review_and_wait(settings_of(serial_timeout=5), 3, 7, 9)

    def cancel() -> None:
        if apply.steps[3] is BoardStep.WRITING and not harness.device.writer.is_saving_snapshot:
            apply.cancel()

    harness.device.link_changed.connect(cancel)
    apply.write_and_wait(3, 7, 9)
    assert apply.steps == {3: BoardStep.WRITTEN, 7: BoardStep.SKIPPED, 9: BoardStep.SKIPPED}
    assert harness.stored("serial_timeout") == [5, 0, 0]
    assert harness.boards.selected == 7


def test_stop_ends_the_apply_after_the_current_board(new_line: NewLine) -> None:
    harness = new_line("3", "7", "9")
    harness.connect_known(7, 3, 9)
    apply = ApplyHarness(harness)
    settings = settings_of(serial_timeout=5, motor1_acceleration=9, motor2_acceleration=9)

    def write_and_stop(condition: Callable[[], object]) -> None:
        apply.review_and_wait(settings, 3, 7, 9)
        apply.write((3, 7, 9))
        harness.until(condition)
        harness.device.motors.press_stop()
        harness.until(lambda: not apply.is_running and not harness.device.writer.running)

    write_and_stop(lambda: harness.boards.is_selecting and apply.steps[3] is BoardStep.READING)
    assert set(apply.steps.values()) == {BoardStep.SKIPPED}
    assert harness.stored("serial_timeout") == [0] * 3
    write_and_stop(lambda: harness.stored("motor1_acceleration")[0] == 9)
    assert harness.is_stopped(3)
    assert apply.steps == {3: BoardStep.WRITTEN, 7: BoardStep.SKIPPED, 9: BoardStep.SKIPPED}
    assert apply.was_stopped
    assert harness.stored("serial_timeout")[0] == 5
    assert harness.stored("motor1_acceleration")[1] != 9
    assert harness.boards.selected == 7
