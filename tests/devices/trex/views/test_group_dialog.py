"""Dialog that joins boards into a group."""

from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.support.window import WidgetDriver
from trex_gui.devices.trex.model.boards import BoardList, LineBoard, Presence
from trex_gui.devices.trex.model.device import Device
from trex_gui.devices.trex.model.group import BoardGroup
from trex_gui.devices.trex.views.group import GroupDialog


def test_dialog_shows_the_boards_of_the_last_scan(qtbot: QtBot) -> None:
    window, device = QWidget(), Device()
    qtbot.addWidget(window)
    boards = BoardList(device)
    dialog = GroupDialog(device, boards, BoardGroup(device), window)
    driver = WidgetDriver(dialog, qtbot)
    for numbers in ([7, 9], [7], [7, 9]):
        boards.boards = tuple(LineBoard(number, None, Presence.RESPONDING) for number in numbers)
        dialog.prompt()
        assert [n for n in (7, 9) if driver.has(f"wheel{n}1Side")] == numbers
        assert {wheel.board for wheel in dialog.wheels} == set(numbers)
    dialog.close()
