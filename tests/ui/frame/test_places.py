"""Tab bar with the places of the window."""

from collections.abc import Iterator

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QPushButton, QWidget
from pytestqt.qtbot import QtBot

from trex_gui.ui.frame.places import Places


@pytest.fixture
def places(qtbot: QtBot) -> Iterator[Places]:
    window = QWidget()
    qtbot.addWidget(window)
    places = Places(window)
    for name in ("Board", "Channels", "Motors"):
        places.addTab(QWidget(places), name)
    places.bar.icons = ("board", "channels", "motor")
    places.setTabVisible(1, False)
    window.show()
    yield places
    window.close()


def test_narrow_bar_shows_icons_instead_of_names(places: Places) -> None:
    places.resize(1300, 400)
    wide = places.bar.tabRect(0).width()
    assert places.bar.tabToolTip(0) == ""
    places.resize(900, 400)
    assert places.bar.tabRect(0).width() < wide / 2
    assert places.bar.tabToolTip(0) == "Board"
    picture = places.bar.grab(places.bar.tabRect(0)).toImage()
    assert len({picture.pixel(x, 18) for x in range(picture.width())}) > 2


def test_tab_key_moves_the_focus_to_the_bar(places: Places) -> None:
    button = QPushButton(places.window())
    button.show()
    button.setFocus()
    QTest.keyClick(button, Qt.Key.Key_Tab)
    assert places.bar.hasFocus()


def test_arrow_keys_move_through_the_visible_places(places: Places) -> None:
    for key, index in (
        (Qt.Key.Key_Down, 2),
        (Qt.Key.Key_Down, 2),
        (Qt.Key.Key_Up, 0),
        (Qt.Key.Key_Right, 2),
        (Qt.Key.Key_Left, 0),
    ):
        QTest.keyClick(places.bar, key)
        assert places.currentIndex() == index
