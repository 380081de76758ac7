"""Dialog for the line settings of this computer."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSpinBox, QWidget
from pytestqt.qtbot import QtBot

from tests.support.window import WidgetDriver
from trex_gui.devices.trex.protocol.connection_settings import ConnectionSettings
from trex_gui.devices.trex.views.line_settings_dialog import LineSettingsDialog


@pytest.mark.parametrize(("number", "group"), [(7, (7, 9)), (5, ())])
def test_another_device_number_ends_the_group(
    qtbot: QtBot, number: int, group: tuple[int, ...]
) -> None:
    window, accepted = QWidget(), list[ConnectionSettings]()
    qtbot.addWidget(window)
    dialog = LineSettingsDialog(ConnectionSettings("").with_group((7, 9)), window)
    dialog.chosen.connect(accepted.append)
    WidgetDriver(dialog, qtbot).find(QSpinBox, "deviceNumberField").setValue(number)
    dialog.show()
    QTest.keyClick(dialog, Qt.Key.Key_Return)
    (settings,) = accepted
    assert (settings.device_number, settings.group) == (number, group)
