"""Connection bar above the pages."""

from PySide6.QtWidgets import QStyleOptionComboBox
from pytestqt.qtbot import QtBot

from trex_gui.ui.frame.connection_bar import PortList


def test_narrow_port_list_elides_its_text(qtbot: QtBot) -> None:
    ports = PortList()
    qtbot.addWidget(ports)
    ports.addItem("Demo TReX (no hardware)")

    def shown(width: int) -> str:
        ports.resize(width, 30)
        option = QStyleOptionComboBox()
        ports.initStyleOption(option)
        return option.currentText

    assert shown(400) == "Demo TReX (no hardware)"
    assert shown(100).endswith("…")
