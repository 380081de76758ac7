"""List of hits below the search field."""

import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from tests.support.window import LEFT
from trex_gui.ui.frame.search_field import SearchField
from trex_gui.ui.help.search import Findable


@pytest.mark.parametrize("column", [0, 1])
def test_click_on_either_column_opens_the_hit(qtbot: QtBot, column: int) -> None:
    shown: list[str] = []
    hit = Findable("page", "motors", "Motors", "Window", "Ctrl+3", lambda: shown.append("motors"))
    window = QWidget()
    qtbot.addWidget(window)
    window.resize(1000, 400)
    field = SearchField(lambda: [hit], window)
    window.show()
    field.start()
    QTest.keyClicks(field, "motors")
    view = field._hits
    place = view.visualRect(view.model().index(0, column)).center()
    QTest.mouseClick(view.viewport(), LEFT, pos=place)
    assert shown == ["motors"]
