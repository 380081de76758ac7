"""What is written is seen first; what waits for a power cycle is followed until it is active."""

import sys
from collections.abc import Callable

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QDialog,
    QLabel,
    QPushButton,
    QTableView,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.held_line import before_storing
from tests.support.simulator import StartSimulator
from tests.support.virtual_devices import VirtualSimulator
from trex_gui.link.settings import LinkSettings
from trex_gui.model.comparison_table import ComparisonColumn
from trex_gui.model.device import Link
from trex_gui.model.power_cycle import PowerCycle
from trex_gui.protocol.calibration import Calibration
from trex_gui.protocol.line_settings import Detection, LineSettings
from trex_gui.window import Program

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="needs pseudo-terminals")

SLOW = LineSettings(57600, Detection.EVEN, 2)


class Desk:
    """The window, its dialogs beside it, and the simulated board."""

    def __init__(self, program: Program, simulator: VirtualSimulator, qtbot: QtBot) -> None:
        self.program = program
        self.device = program.device
        self.simulator = simulator
        self.qtbot = qtbot

    def wait(self, condition: Callable[[], bool], timeout: int = 20_000) -> None:
        self.qtbot.waitUntil(condition, timeout=timeout)

    def dialog(self, name: str) -> QDialog:
        found = self.program.window.findChild(QDialog, name)
        assert found is not None, name
        return found

    def button(self, name: str) -> QAbstractButton:
        found = self.program.window.findChild(QAbstractButton, name)
        assert found is not None, name
        return found

    def press(self, name: str) -> None:
        assert self.button(name).isEnabled(), f"{name} is greyed"
        QTest.mouseClick(self.button(name), Qt.MouseButton.LeftButton)

    def choose(self, name: str) -> None:
        action = self.program.window.findChild(QAction, f"{name}Action")
        assert action is not None
        assert action.isEnabled(), f"{name} is greyed"
        action.trigger()

    def text(self, name: str, within: str) -> str:
        label = self.dialog(within).findChild(QLabel, name)
        assert label is not None, name
        return label.text()

    def table(self, within: str = "reviewDialog") -> QTableView:
        found = self.dialog(within).findChild(QTableView, "comparisonTable")
        assert found is not None
        return found

    def rows(self, within: str = "reviewDialog") -> list[list[str]]:
        model = self.table(within).model()
        return [
            [str(model.index(row, column).data()) for column in range(model.columnCount())]
            for row in range(model.rowCount())
        ]

    def untick(self, name: str, within: str = "reviewDialog") -> None:
        """Click the tick of a row, as a person does."""
        view = self.table(within)
        model = view.model()
        row = next(r for r in range(model.rowCount()) if model.index(r, 0).data() == name)
        view.setCurrentIndex(model.index(row, ComparisonColumn.SETTING))
        QTest.keyClick(view, Qt.Key.Key_Space)

    def stored(self, key: str) -> int:
        return int(self.simulator.show()["parameters"][key])


@pytest.fixture
def desk(program: Program, quick_simulator: VirtualSimulator, qtbot: QtBot) -> Desk:
    program.device.connect_to(LinkSettings(quick_simulator.url))
    qtbot.waitUntil(lambda: program.device.link is Link.UP)
    return Desk(program, quick_simulator, qtbot)


def test_the_review_shows_old_and_new_in_wire_and_physical_units(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.device.calibrations.edit(2, Calibration(2600, 3750, 5000, 60))
    desk.press("applyButton")
    timeout, calibration = desk.rows()
    assert timeout == ["Serial Timeout", "off", "1.5 s", "0 → 15"]
    assert calibration[0] == "Calibration of RC channel 2"
    assert "minimum" in calibration[2]
    assert "maximum" not in calibration[2]
    assert desk.button("writeButton").text() == "Write 2 settings"
    head = desk.text("reviewHead", "reviewDialog")
    assert head.startswith("2 settings of the TReX 1.2 (device number 7, ")


def test_nothing_is_written_before_the_second_click(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.press("applyButton")
    desk.press("reviewCloseButton")
    assert not desk.dialog("reviewDialog").isVisible()
    assert desk.stored("serial_timeout") == 0
    assert desk.device.pending == 1
    assert desk.device.history.snapshots() == ()


def test_what_is_unticked_waits(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.device.parameters.edit("motor1_acceleration", 5)
    desk.press("applyButton")
    desk.untick("Serial Timeout")
    assert desk.button("writeButton").text() == "Write 1 setting"
    desk.press("writeButton")
    desk.wait(lambda: desk.stored("motor1_acceleration") == 5)
    desk.wait(lambda: not desk.device.applying)
    assert desk.stored("serial_timeout") == 0
    assert desk.device.parameters.pending == (("serial_timeout", 15),)


def test_the_review_follows_the_edits_while_it_is_open(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.device.parameters.edit("motor1_acceleration", 5)
    desk.press("applyButton")
    desk.untick("Serial Timeout")
    desk.device.parameters.edit("motor2_acceleration", 7)
    assert len(desk.rows()) == 3
    assert desk.button("writeButton").text() == "Write 2 settings"
    desk.device.discard_edits()
    assert desk.rows() == []
    assert not desk.button("writeButton").isEnabled()
    assert "nothing to write" in desk.text("reviewHead", "reviewDialog")


def test_the_result_says_of_each_value_that_it_is_stored(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.device.calibrations.edit(2, Calibration(2600, 3750, 5000, 60))
    desk.press("applyButton")
    desk.press("writeButton")
    desk.wait(lambda: len(desk.rows()[0]) == len(ComparisonColumn))
    assert [row[-1] for row in desk.rows()] == ["stored"] * 2
    assert "2 settings stored and read back equal" in desk.text("reviewHead", "reviewDialog")
    assert desk.button("reviewCloseButton").text() == "Close"
    assert not desk.button("writeButton").isVisible()


def test_the_result_names_what_did_not_stick(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.device.parameters.edit("motor1_acceleration", 5)
    desk.simulator.do("jumper mode rc")
    desk.simulator.do("power cycle")
    desk.wait(lambda: desk.device.state is not None and not desk.device.state.mode.is_serial)
    desk.press("applyButton")
    assert "RC mode and takes no settings" in desk.text("reviewHead", "reviewDialog")
    desk.press("writeButton")
    desk.wait(lambda: "did not stick" in desk.text("reviewHead", "reviewDialog"))
    untried, refused = sorted((row[-1] for row in desk.rows()), key=len)
    assert "not in serial mode" in refused
    assert untried == "not tried after that"
    assert desk.device.pending == 2


def test_a_plug_that_is_pulled_while_writing_is_told_and_the_rest_stays_an_edit(
    desk: Desk,
) -> None:
    keys = [key for key in desk.device.parameters.all_stored if key.startswith("motor")][:12]
    for key in keys:
        desk.device.parameters.edit(key, 1 - min(1, desk.device.parameters.all_stored[key]))
    count = desk.device.pending
    desk.press("applyButton")
    before_storing(desk.simulator, 3, lambda: desk.simulator.do("line unplug"))
    desk.press("writeButton")
    desk.wait(lambda: desk.device.link is Link.NONE)
    desk.wait(lambda: desk.button("reviewCloseButton").text() == "Close")
    assert "did not stick" in desk.text("reviewHead", "reviewDialog")
    assert count > desk.device.pending > 0
    assert desk.rows()[0][-1] == "stored"
    assert any("gone" in row[-1] for row in desk.rows())
    assert desk.rows()[-1][-1] == "not tried after that"


def test_the_stop_button_can_be_pressed_while_the_review_is_open(desk: Desk) -> None:
    desk.device.motors.arm()
    desk.device.motors.set_speed(1, 60)
    desk.wait(lambda: desk.simulator.show()["motors"][0]["speed"] == 60)
    desk.device.parameters.edit("serial_timeout", 15)
    desk.press("applyButton")
    assert not desk.dialog("reviewDialog").isModal()
    desk.press("stopButton")
    desk.wait(lambda: desk.simulator.show()["motors"][0]["direction"] == "brake")


# --- The power cycle --------------------------------------------------------------------


def write(desk: Desk) -> None:
    desk.press("applyButton")
    desk.press("writeButton")
    desk.wait(lambda: "read back equal" in desk.text("reviewHead", "reviewDialog"))


def cycle_text(desk: Desk, within: str = "reviewDialog") -> str:
    return desk.text("powerCycleResult", within)


def test_what_waits_for_power_is_followed_until_it_is_active(desk: Desk) -> None:
    desk.device.parameters.edit("motor_mode", 1)
    write(desk)
    panel = desk.dialog("reviewDialog").findChild(QWidget, "powerCyclePanel")
    assert panel is not None
    assert panel.isVisible()
    assert "Motor Mode" in desk.text("powerCycleTitle", "reviewDialog")
    assert "Waiting for the board to fall silent" in cycle_text(desk)
    desk.simulator.do("power off")
    desk.wait(lambda: "Waiting for it to answer again" in cycle_text(desk))
    desk.simulator.do("power on")
    desk.wait(lambda: "everything that it stores is active" in cycle_text(desk))
    assert desk.device.parameters.active_of("motor_mode") == 1


def test_a_value_that_acts_at_once_asks_for_no_power_cycle(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    write(desk)
    panel = desk.dialog("reviewDialog").findChild(QWidget, "powerCyclePanel")
    assert panel is not None
    assert not panel.isVisible()


@pytest.mark.parametrize(
    "line",
    [SLOW, LineSettings(115200), LineSettings(38400, Detection.CRC7)],
    ids=lambda line: line.text(),
)
def test_a_board_with_another_line_is_found_again_after_its_power_cycle(
    desk: Desk, line: LineSettings
) -> None:
    desk.device.parameters.edit("uart_settings", line.to_wire())
    write(desk)
    assert line.text() in desk.text("powerCycleStep2", "reviewDialog")
    desk.simulator.do("power off")
    desk.wait(lambda: desk.device.link is Link.SILENT)
    desk.simulator.do("power on")
    desk.wait(lambda: desk.device.link is Link.UP)
    assert desk.device.settings is not None
    assert desk.device.settings.line == line
    assert "everything that it stores is active" in cycle_text(desk)
    assert desk.device.parameters.waiting_for_power == ()


def test_a_power_cycle_can_be_guided_later_from_the_page(desk: Desk) -> None:
    desk.device.parameters.edit("motor_mode", 1)
    write(desk)
    desk.press("reviewCloseButton")
    desk.program.window.pages.setCurrentIndex(5)
    desk.press("makeActiveButton")
    within = "powerCycleDialog"
    assert "Motor Mode" in desk.text("powerCycleTitle", within)
    desk.simulator.do("power off")
    desk.wait(lambda: "Waiting for it to answer again" in cycle_text(desk, within))
    desk.simulator.do("power on")
    desk.wait(lambda: "active" in cycle_text(desk, within))
    desk.press("powerCycleCloseButton")
    assert not desk.button("makeActiveButton").isVisible()


# --- Defaults ---------------------------------------------------------------------------


def test_restoring_defaults_shows_first_what_changes_and_goes_through_the_review(
    desk: Desk,
) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.device.parameters.edit("motor1_acceleration", 5)
    write(desk)
    desk.press("reviewCloseButton")
    desk.choose("defaults")
    names = [row[0] for row in desk.rows("defaultsDialog")]
    assert names == ["Serial Timeout", "Motor 1 Acceleration"]
    desk.untick("Serial Timeout", "defaultsDialog")
    desk.press("takeDefaultsButton")
    assert desk.stored("motor1_acceleration") == 5
    assert desk.dialog("reviewDialog").isVisible()
    desk.press("writeButton")
    desk.wait(lambda: desk.stored("motor1_acceleration") == 0)
    desk.wait(lambda: not desk.device.applying)
    assert desk.stored("serial_timeout") == 15


def test_serial_defaults_change_nothing_but_how_the_board_is_reached(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.device.parameters.edit("uart_settings", SLOW.to_wire())
    write(desk)
    desk.press("reviewCloseButton")
    desk.choose("serial_defaults")
    assert [row[0] for row in desk.rows("defaultsDialog")] == ["UART Settings"]
    desk.press("takeDefaultsButton")
    assert desk.device.parameters.pending == (("uart_settings", LineSettings().to_wire()),)


def test_the_board_resets_itself_and_comes_back_at_the_factorys_line(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.device.parameters.edit("uart_settings", SLOW.to_wire())
    write(desk)
    desk.simulator.do("power off")
    desk.wait(lambda: desk.device.link is Link.SILENT)
    desk.simulator.do("power on")
    desk.wait(lambda: desk.device.link is Link.UP)
    desk.press("reviewCloseButton")
    desk.choose("defaults")
    desk.press("boardResetButton")
    assert not desk.device.reset_ordered
    desk.press("boardResetSureButton")
    desk.wait(lambda: desk.dialog("powerCycleDialog").isVisible())
    assert len(desk.device.history.snapshots()) == 2
    desk.simulator.do("power off")
    desk.wait(lambda: desk.device.link is Link.SILENT)
    desk.simulator.do("power on")
    desk.wait(lambda: desk.device.link is Link.UP)
    assert desk.stored("serial_timeout") == 0
    assert desk.device.parameters.stored_of("serial_timeout") == 0
    assert desk.device.settings is not None
    assert desk.device.settings.line == LineSettings()
    button = desk.dialog("powerCycleDialog").findChild(QPushButton, "powerCycleCloseButton")
    assert button is not None
    button.click()


def test_nothing_is_written_that_an_ordered_reset_would_wipe(desk: Desk) -> None:
    desk.choose("defaults")
    desk.press("boardResetButton")
    desk.press("boardResetSureButton")
    desk.wait(lambda: desk.device.reset_ordered)
    desk.press("powerCycleCloseButton")
    desk.device.parameters.edit("motor1_acceleration", 5)
    desk.press("applyButton")
    assert "told to reset itself" in desk.text("reviewHead", "reviewDialog")
    assert not desk.button("writeButton").isEnabled()
    desk.device.apply()
    assert not desk.device.applying
    desk.press("reviewCloseButton")
    desk.choose("power")  # the way on can be found again
    desk.simulator.do("power off")
    desk.wait(lambda: desk.device.link is Link.SILENT)
    desk.simulator.do("power on")
    desk.wait(lambda: desk.device.link is Link.UP)
    assert not desk.device.reset_ordered
    desk.press("applyButton")
    assert desk.button("writeButton").isEnabled()
    desk.press("powerCycleCloseButton")
    desk.press("reviewCloseButton")


# --- What is said when things go another way --------------------------------------------


def test_a_line_that_closes_meanwhile_is_no_power_cycle(desk: Desk) -> None:
    desk.device.parameters.edit("motor_mode", 1)
    write(desk)
    desk.program.connector.disconnect_port()
    desk.wait(lambda: "The line was closed" in cycle_text(desk))
    desk.device.connect_to(LinkSettings(desk.simulator.url))
    desk.wait(lambda: "cannot be seen" in cycle_text(desk))
    waiting = [desk.device.parameters.waiting_for_power]
    done = desk.dialog("reviewDialog").findChild(QAbstractButton, "powerCycleDone")
    assert done is not None
    QTest.mouseClick(done, Qt.MouseButton.LeftButton)
    assert "everything that it stores is active" in cycle_text(desk)
    waiting.append(desk.device.parameters.waiting_for_power)
    assert waiting == [("Motor Mode",), ()]


def test_who_waits_long_is_told_what_to_look_at(desk: Desk) -> None:
    said: list[str] = []
    for cycle in desk.program.window.findChildren(PowerCycle):
        patience = cycle.findChild(QTimer)
        assert patience is not None
        patience.setInterval(300)
        cycle.changed.connect(lambda: said.append(cycle_text(desk)))
    desk.device.parameters.edit("motor_mode", 1)
    write(desk)
    desk.wait(lambda: "A short break is not seen" in cycle_text(desk))
    desk.simulator.do("power off")
    desk.wait(lambda: "Is its power on" in cycle_text(desk))
    assert any("has fallen silent" in text for text in said)
    desk.simulator.do("power on")
    desk.wait(lambda: "active" in cycle_text(desk))
    assert desk.text("powerCycleTitle", "reviewDialog") == "The power cycle is over."


def test_closing_the_guide_of_the_menu_ends_no_other(desk: Desk) -> None:
    desk.device.parameters.edit("motor_mode", 1)
    write(desk)
    desk.choose("power")
    desk.press("powerCycleCloseButton")
    assert "Waiting for the board to fall silent" in cycle_text(desk)


def test_a_cut_in_the_middle_says_what_was_not_tried(desk: Desk) -> None:
    for key in ("serial_timeout", "motor1_acceleration", "motor2_acceleration"):
        desk.device.parameters.edit(key, 15)
    desk.press("applyButton")
    desk.simulator.do("line mute on")
    desk.press("writeButton")
    desk.wait(lambda: "did not stick" in desk.text("reviewHead", "reviewDialog"), 30_000)
    outcomes = [row[-1] for row in desk.rows()]
    assert "not tried after that" in outcomes
    assert "the factory's" in desk.text("reviewHead", "reviewDialog")
    desk.simulator.do("line mute off")
    desk.wait(lambda: desk.device.link is Link.UP)


def test_what_was_written_behind_a_closed_review_is_told_in_the_window(desk: Desk) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    desk.press("applyButton")
    desk.press("writeButton")
    desk.dialog("reviewDialog").close()
    label = desk.program.window.findChild(QLabel, "bannerText")
    assert label is not None
    desk.wait(lambda: "stored and read back" in label.text())


def test_edits_meet_the_next_board_of_their_kind_with_a_word(desk: Desk) -> None:
    desk.device.parameters.edit("device_number", 9)
    desk.program.connector.disconnect_port()
    desk.wait(lambda: desk.device.link is Link.NONE)
    action = desk.program.window.findChild(QAction, "saveAction")
    assert action is not None
    assert action.isEnabled()  # what was edited can still be saved
    desk.device.connect_to(LinkSettings(desk.simulator.url))
    desk.wait(lambda: desk.device.link is Link.UP)
    label = desk.program.window.findChild(QLabel, "bannerText")
    assert label is not None
    desk.wait(lambda: "Edits made before wait here: 1" in label.text())


def test_edits_for_another_kind_of_board_are_kept_in_the_history(
    desk: Desk, start_simulator: StartSimulator
) -> None:
    desk.device.parameters.edit("serial_timeout", 15)
    junior = start_simulator("--unpaced", "--model", "trexjr")
    desk.device.connect_to(LinkSettings(junior.url))
    desk.wait(lambda: "TReX Jr" in desk.device.status)
    desk.wait(lambda: desk.device.link is Link.UP)
    assert desk.device.pending == 0
    (snapshot,) = desk.device.history.snapshots()
    assert desk.device.history.load(snapshot).parameters["serial_timeout"] == 15
    assert "not applied" in snapshot.reason
    label = desk.program.window.findChild(QLabel, "bannerText")
    assert label is not None
    desk.wait(lambda: "are kept in File, History" in label.text())


def test_calibrations_for_the_other_inputs_wait_until_they_are_read_again(desk: Desk) -> None:
    wanted = Calibration(2600, 3750, 5000, 60)
    desk.device.calibrations.edit(2, wanted)
    desk.device.parameters.edit("channel_input_source", 1)
    desk.press("applyButton")
    desk.untick("Calibration of RC channel 2")
    desk.press("writeButton")
    desk.wait(lambda: "read back equal" in desk.text("reviewHead", "reviewDialog"))
    for wire in (1, 0):
        desk.simulator.do("power off")
        desk.wait(lambda: desk.device.link is Link.SILENT)
        desk.simulator.do("power on")
        desk.wait(lambda: desk.device.link is Link.UP)
        if wire == 1:
            assert desk.device.calibrations.pending == ()
            assert desk.device.pending == 1
            desk.press("reviewCloseButton")
            desk.press("applyButton")
            assert "RC channel 2" in desk.text("reviewFoot", "reviewDialog")
            assert not desk.button("writeButton").isEnabled()
            desk.device.parameters.edit("channel_input_source", 0)
            desk.press("writeButton")
            desk.wait(lambda: desk.stored("channel_input_source") == 0)
            desk.wait(lambda: not desk.device.applying)
    assert desk.device.calibrations.pending == ((2, wanted),)
