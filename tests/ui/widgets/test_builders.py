"""Functions that create widgets."""

import pytest
from PySide6.QtCore import QLocale, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders


def test_created_widgets_have_names_values_and_handlers(qtbot: QtBot) -> None:
    page = QWidget()
    qtbot.addWidget(page)
    clicks: list[str] = []
    push = builders.button(
        page, "goButton", "Go", tip="Starts", default=False, on_click=lambda: clicks.append("go")
    )
    box = builders.check_box(
        page, "onBox", "On", checked=True, on_toggle=lambda _on: clicks.append("on")
    )
    count = builders.spin_box(page, "countBox", "Count", 1, 9, value=4, suffix=" s")
    combo = builders.combo_box(page, "whichCombo", "Which", items=[("first", 1), "second"])

    push.click()
    box.click()

    assert clicks == ["go", "on"]
    assert (push.objectName(), push.toolTip(), push.autoDefault()) == ("goButton", "Starts", False)
    assert (count.value(), count.accessibleName(), count.keyboardTracking()) == (4, "Count", False)
    assert (combo.itemData(0), combo.itemText(1), combo.accessibleName()) == (1, "second", "Which")


@pytest.mark.parametrize("language", ["en", "de"])
def test_spin_box_ignores_separators_in_every_language(qtbot: QtBot, language: str) -> None:
    page = QWidget()
    qtbot.addWidget(page)
    before = QLocale()
    QLocale.setDefault(QLocale(language))
    box = builders.spin_box(page, "countBox", "Count", 0, 1023, suffix=" = 0.7 °/s")
    QLocale.setDefault(before)
    for typed, expected in (("1,5", 15), ("1.5", 15), ("1,000", 1000), ("250", 250)):
        box.selectAll()
        QTest.keyClicks(box, typed)
        QTest.keyClick(box, Qt.Key.Key_Return)
        assert box.value() == expected
        assert box.text() == f"{expected} = 0.7 °/s", "the displayed number has no separator"


@pytest.mark.parametrize("language", ["en", "de"])
def test_point_and_comma_separate_decimals_in_every_language(qtbot: QtBot, language: str) -> None:
    page = QWidget()
    qtbot.addWidget(page)
    box = builders.double_spin_box(page, "box", "Box", 0.5, 5000, decimals=2, suffix=" A")
    box.setLocale(QLocale(language))
    for typed, expected in (("2,4", 2.4), ("3.6", 3.6), ("4,", 4), ("1500", 1500)):
        box.selectAll()
        QTest.keyClicks(box, typed)
        QTest.keyClick(box, Qt.Key.Key_Return)
        assert box.value() == expected
    for pasted in ("1,500", "1.500", "1.000,5", "0.25", "0,25"):  # the last two are too low
        box.selectAll()
        box.lineEdit().insert(pasted)
        QTest.keyClick(box, Qt.Key.Key_Return)
        assert box.value() == 1500


def test_large_button_follows_the_font(qtbot: QtBot) -> None:
    page = QWidget()
    qtbot.addWidget(page)
    button = builders.button(page, "stopButton", "Stop")
    theme().set_font_size(175)
    builders.set_large(button)
    large = button.minimumHeight()
    theme().set_font_size(90)
    builders.set_large(other := builders.button(page, "otherButton", "Stop"))
    assert button.minimumHeight() == other.minimumHeight() < large
