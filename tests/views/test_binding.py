"""The Qt binding in use does not lose references, which would end the process in use."""

import sys

import pytest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from trex_gui.model.device import Link
from trex_gui.window import Program


@pytest.mark.timeout(300)  # paints every widget 60 times, on a computer with much else to do
def test_repainting_every_page_loses_no_references_to_none(program: Program, qtbot: QtBot) -> None:
    program.connector.connect_to(program.ports.demo)
    qtbot.waitUntil(lambda: program.device.link is Link.UP, timeout=20_000)
    tabs = program.window.pages
    qtbot.waitUntil(lambda: program.device.telemetry.raw is not None)
    before = sys.getrefcount(None)
    for index in range(tabs.count()):
        tabs.setCurrentIndex(index)
        for _ in range(60):
            program.device.telemetry.updated.emit()
            for widget in tabs.currentWidget().findChildren(QWidget):
                widget.repaint()
    assert sys.getrefcount(None) > before - 100
