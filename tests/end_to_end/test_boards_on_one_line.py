"""Several boards on one line: list, new number, one settings file for all."""

from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QListWidget, QSpinBox, QTableWidget

from tests.support.keyboard import check_keyboard
from tests.support.pages.motors import Gesture, MotorsPage, is_stopped
from tests.support.simulator import StartSimulator
from tests.support.window import WidgetDriver, WindowDriver
from trex_gui.core.files import save
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.ui.devices.connection import ConnectionState
from trex_gui.ui.devices.ports import Port


def connect(window: WindowDriver, url: str, number: int) -> None:
    """Connect to one of several boards, like the *Find* dialog."""
    port: Port = window.program.ports.add_typed(url)
    settings = ConnectionSettings(url, device_number=number)
    window.program.device_manager.connect_with(port, settings)
    window.wait(lambda: window.device.is_connected and window.motors.is_available)


def rows(window: WindowDriver) -> list[list[str]]:
    shown = window.find(QListWidget, "boardList")
    return [shown.item(row).text().splitlines() for row in range(shown.count())]


def select(window: WindowDriver, row: int) -> None:
    """Click a board in the list."""
    shown = window.find(QListWidget, "boardList")
    place = shown.visualItemRect(shown.item(row)).center()
    QTest.mouseClick(shown.viewport(), Qt.MouseButton.LeftButton, pos=place)


def find_boards(window: WindowDriver) -> None:
    """Scan the line for boards. Wait until the scan ends."""
    window.trigger("boards")
    window.wait(lambda: window.has("boardsProgress"))
    window.wait(lambda: not window.has("boardsProgress"))


def test_boards_are_listed_selected_renumbered_and_written(
    window: WindowDriver,
    start_simulator: StartSimulator,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    options = [word for board in ("3", "7", "9:trexjr") for word in ("--device", board)]
    boards = start_simulator("--unpaced", *options)
    boards.do("@3 eeprom ignored_channels 2")
    assert not window.has("boardPanel")
    assert not window.action("boards").isEnabled()
    connect(window, boards.url, 7)
    assert not window.has("boardPanel")

    find_boards(window)
    assert rows(window) == [
        ["3 · TReX 1.2", "responding"],
        ["7 · TReX 1.2", "selected"],
        ["9 · TReX Jr 1.2", "responding"],
    ]
    check_keyboard(window.window)

    # Selecting another board stops the driven board and switches all pages.
    window.motors.arm()
    window.motors.set_speed(1, 30)
    window.wait(lambda: boards.show("@7")["motors"][0]["target_speed"])
    assert rows(window)[1][1] == "selected, armed"
    assert not window.is_enabled("scanBoardsButton")
    select(window, 2)
    window.wait(lambda: rows(window)[2][1] == "selected")
    assert is_stopped(boards, "@7")
    assert rows(window)[1][1] == "responding"
    assert window.window.windowTitle().startswith("TReX Jr 1.2, device 9")
    window.wait(lambda: window.motors.is_available)
    window.motors.arm()
    window.motors.set_speed(1, 30)
    window.wait(lambda: boards.show("@9")["motors"][0]["target_speed"])
    assert is_stopped(boards, "@7")
    window.press_escape()
    window.wait(lambda: is_stopped(boards, "@9"))

    # A reset would set the number of another board.
    window.trigger("defaults")
    review = window.dialog("reviewDialog")
    review.click("boardResetButton")
    assert "The board would get device number 7, which another board" in review.text("questionText")
    review.click("questionCancel")
    review.click("reviewCloseButton")

    # A board is also selected by keyboard.
    shown = window.find(QListWidget, "boardList")
    shown.setCurrentRow(1)
    QTest.keyClick(shown, Qt.Key.Key_Return)
    window.wait(lambda: rows(window)[1][1] == "selected")

    # Only a free number can be written.
    window.trigger("number")
    dialog = window.dialog("numberDialog")
    check_keyboard(dialog.root)
    field = dialog.find(QSpinBox, "newNumberField")
    assert field.value() == 8
    field.setValue(9)
    assert dialog.text("numberKnown") == "Taken: 9 · TReX Jr 1.2."
    field.setValue(12)
    QTest.keyClick(field, Qt.Key.Key_Return)
    window.wait(lambda: [row[0] for row in rows(window)][-1] == "12 · TReX 1.2")
    assert boards.show("@7")["parameters"]["device_number"] == 12

    # With one file for all boards, each keeps its number. Unsuitable settings are omitted.
    path = tmp_path / "fleet.txt"
    save(path, "product: TReX\ndevice_number: 55\nserial_timeout: 7\nrequired_channels: 3\n")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_a, **_k: (str(path), ""))
    window.trigger("to_boards")
    window.wait(lambda: window.has("applyToBoardsDialog"))
    fleet: WidgetDriver = window.dialog("applyToBoardsDialog")
    check_keyboard(fleet.root)
    window.wait(lambda: fleet.is_enabled("writeBoardsButton"))
    table = fleet.find(QTableWidget, "boardsToWrite")

    def results() -> list[list[str]]:
        cells = [[table.item(row, column) for column in (1, 2)] for row in range(3)]
        return [[cell.text() if cell else "" for cell in row] for row in cells]

    assert results()[0] == ["2 settings", "read, with warnings"]
    assert results()[2] == ["2 settings", "read"]
    assert "are for a TReX, not a TReX Jr" in results()[1][1]
    assert boards.show("@3")["parameters"]["serial_timeout"] == 0
    assert fleet.has("boardsFindings")
    table.setCurrentCell(2, 0)
    assert not fleet.has("boardsFindings")
    assert fleet.button("writeBoardsButton").text() == "&Write to 2 boards"
    for row in (0, 2):
        if (item := table.item(row, 0)) is not None:
            item.setCheckState(Qt.CheckState.Unchecked)
    assert fleet.button("writeBoardsButton").text() == "&Write to boards"
    # After the dialog is closed, only the current board is written. The window reports this.
    window.trigger("to_boards")
    window.wait(lambda: fleet.is_enabled("writeBoardsButton"))
    window.device.applied.connect(fleet.root.close, Qt.ConnectionType.SingleShotConnection)
    fleet.click("writeBoardsButton")
    window.wait_for_text("bannerText", "Written to 1 board.")
    assert "Board 12: not tried." in window.text("bannerText")
    window.trigger("to_boards")
    window.wait(lambda: fleet.is_enabled("writeBoardsButton"))
    fleet.click("writeBoardsButton")
    window.wait(lambda: results()[2][1] == "written and verified")
    window.wait(lambda: rows(window)[2][1] == "selected")
    stored = [
        (shown["device_number"], shown["serial_timeout"])
        for name in ("@3", "@7", "@9")
        for shown in (boards.show(name)["parameters"],)
    ]
    assert stored == [(3, 7), (12, 7), (9, 0)]
    # The dialog may cover the window, so it has its own stop button.
    window.wait(lambda: window.motors.can_arm)
    window.motors.arm()
    window.motors.set_speed(1, 30)
    window.wait(lambda: boards.show("@7")["motors"][0]["target_speed"] == 30)
    assert not fleet.is_enabled("writeBoardsButton")
    QTest.mousePress(fleet.button("boardsStopButton"), Qt.MouseButton.LeftButton)
    window.wait(lambda: is_stopped(boards, "@7"))
    assert not window.motors.armed
    QTest.mouseRelease(fleet.button("boardsStopButton"), Qt.MouseButton.LeftButton)
    fleet.click("closeBoardsButton")

    # Disconnecting hides the list.
    window.disconnect()
    assert not window.has("boardPanel")


class TwoBoards(MotorsPage):
    """Motors page of board 7. Board 9 is on the same line."""

    def moves(self, board: str) -> bool:
        return bool(self.simulator.show(board)["motors"][0]["direction"] == "forward")

    def drive(self, board: str) -> None:
        self.arm()
        self.motors.set_speed(1, 30)
        self.wait(lambda: self.moves(board))

    def switch_to(self, row: int) -> None:
        """Select a board with the keyboard while the mouse holds a control."""
        shown = self.find(QListWidget, "boardList")
        shown.setCurrentRow(row)
        QTest.keyClick(shown, Qt.Key.Key_Return)
        self.wait(lambda: rows(self)[row][1] == "selected")

    def lose_line(self) -> None:
        """Unplug the cable, and plug it in again."""
        self.simulator.do("line unplug")
        self.wait(lambda: self.device.link is ConnectionState.DISCONNECTED)
        assert self.device.may_move
        self.simulator.do("line plug")

    def hold_key(self) -> None:
        self.pad.setFocus()
        self.press_key(Qt.Key.Key_Up)

    def repeat_key(self) -> None:
        no_modifier = Qt.KeyboardModifier.NoModifier
        event = QKeyEvent(QKeyEvent.Type.KeyPress, Qt.Key.Key_Up, no_modifier, "", True)
        QApplication.sendEvent(self.pad, event)


@pytest.fixture
def two_boards(
    window: WindowDriver, start_simulator: StartSimulator, monkeypatch: pytest.MonkeyPatch
) -> TwoBoards:
    monkeypatch.setattr("trex_gui.devices.trex.model.boards.NUMBERS", 16)
    boards = start_simulator("--unpaced", "--device", "7", "--device", "9")
    connect(window, boards.url, 7)
    find_boards(window)
    two_boards = TwoBoards(window, boards)
    two_boards.motors.accelerate = False
    two_boards.motors.lockout = 0
    return two_boards


def test_control_held_for_one_board_drives_no_other(two_boards: TwoBoards) -> None:
    """A board that is armed while a control is still held does not follow the control."""
    gestures: tuple[tuple[Gesture, Gesture, Gesture], ...] = (
        (
            lambda: two_boards.hold_pad(0.8, 0),
            lambda: two_boards.move_pad(0.9, 0),
            two_boards.release_pad,
        ),
        (
            lambda: two_boards.hold_slider("motor1Slider", 60),
            lambda: two_boards.move_slider("motor1Slider", 70),
            lambda: two_boards.release_slider("motor1Slider"),
        ),
        (two_boards.hold_key, two_boards.repeat_key, lambda: two_boards.release_key(Qt.Key.Key_Up)),
    )
    for hold, change, release in gestures:
        two_boards.arm()
        hold()
        two_boards.wait(lambda: two_boards.moves("@7"))
        two_boards.switch_to(1)
        assert is_stopped(two_boards.simulator, "@7")
        two_boards.wait(lambda: two_boards.motors.can_arm)
        two_boards.motors.arm()
        change()
        two_boards.let_nothing_happen(0.5)
        assert not two_boards.moves("@9")
        assert is_stopped(two_boards.simulator, "@7")
        release()
        two_boards.press_escape()
        two_boards.switch_to(0)


def test_escape_during_the_selection_stops_both_boards(two_boards: TwoBoards) -> None:
    two_boards.drive("@7")
    select(two_boards, 1)
    two_boards.press_escape()
    two_boards.wait(lambda: rows(two_boards)[1][1] == "selected")
    two_boards.let_nothing_happen(0.5)
    assert is_stopped(two_boards.simulator, "@7")
    assert not two_boards.moves("@9")


def test_last_driven_board_is_stopped_after_a_lost_line(two_boards: TwoBoards) -> None:
    two_boards.switch_to(1)
    two_boards.drive("@9")
    two_boards.lose_line()
    two_boards.click("bannerReconnect")
    two_boards.wait(lambda: not two_boards.device.may_move)
    assert is_stopped(two_boards.simulator, "@9")
    assert not two_boards.device.driving.lost_board


def test_warning_remains_until_the_lost_board_is_stopped(two_boards: TwoBoards) -> None:
    two_boards.switch_to(1)
    two_boards.drive("@9")
    two_boards.lose_line()
    connect(two_boards, two_boards.simulator.url, 7)
    assert not two_boards.moves("@9")
    assert "reached the TReX 1.2, device 9" in two_boards.device.driving.lost_board
    select(two_boards, 1)
    two_boards.wait(lambda: rows(two_boards)[1][1] == "selected" and not two_boards.device.may_move)
    assert is_stopped(two_boards.simulator, "@9")
    assert not two_boards.device.driving.lost_board
