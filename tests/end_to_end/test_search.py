"""*Search everything*: typed words, hits, and the actions of hits."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QCompleter, QLineEdit, QMenu, QWidget

from tests.support.window import WindowDriver

ENTER, ESC, DOWN = Qt.Key.Key_Return, Qt.Key.Key_Escape, Qt.Key.Key_Down


class SearchDriver(WindowDriver):
    def __init__(self, window: WindowDriver) -> None:
        super().__init__(window.program, window.qtbot)
        self.field = self.find(QLineEdit, "searchField")
        hits = self.find_only(QCompleter).popup()
        assert hits is not None
        self.hits = hits

    def type(self, words: str) -> None:
        self.window.activateWindow()  # a closed popup stays in front offscreen
        self.wait(self.window.isActiveWindow)
        self.trigger("search")
        QTest.keyClicks(self.hits, words)

    def press(self, key: Qt.Key) -> None:
        QTest.keyClick(self.window.windowHandle(), key)

    @property
    def titles(self) -> list[str]:
        model = self.hits.model()
        return [model.index(row, 0).data() for row in range(model.rowCount())]

    @property
    def page(self) -> str:
        return self.window.pages.tabText(self.window.pages.currentIndex())


@pytest.fixture
def search(connected_window: WindowDriver) -> SearchDriver:
    return SearchDriver(connected_window)


def test_enter_opens_the_selected_hit(search: SearchDriver) -> None:
    assert search.action("search").shortcut().toString() == "Ctrl+K"
    search.type("motors")
    assert search.titles[0] == "Motors"
    spoken = search.hits.currentIndex().data(Qt.ItemDataRole.AccessibleTextRole)
    assert spoken == "Motors. Window · Ctrl+3"
    search.press(ENTER)
    assert search.page == "Motors"

    search.type("serial timeout")
    search.press(ENTER)
    assert search.page == "Parameters"
    assert search.text("parameterTitle") == "Serial Timeout"
    assert QApplication.focusWidget() is search.find(QWidget, "parametersView")

    search.type("the guardian")
    search.press(ENTER)
    assert search.help.isVisible()


def test_empty_search_lists_the_pages(search: SearchDriver) -> None:
    search.type("")
    assert search.titles[:3] == ["Board", "Channels", "Motors"]
    search.press(DOWN)
    search.press(ENTER)
    assert search.page == "Channels"


def test_escape_leaves_search_and_stops_armed_motors(search: SearchDriver) -> None:
    search.type("zeppelin")
    assert search.titles == ["Nothing was found."]
    with search.qtbot.assertNotEmitted(search.motors.stop_requested):
        search.press(ESC)
    assert not search.field.text()
    assert not search.hits.isVisible()

    search.motors.arm()
    search.type("motors")
    with search.qtbot.waitSignal(search.motors.stop_requested):
        search.press(ESC)


def test_hit_that_would_arm_motors_is_shown_in_its_menu(search: SearchDriver) -> None:
    search.type("arm motors")
    assert search.titles[0] == "Arm motors"
    search.press(ENTER)
    assert not search.motors.armed
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    assert menu.activeAction() is search.action("run")
    menu.close()
