"""The comparison as a person sees and drives it."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QItemSelectionModel, QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QLabel, QPushButton, QTableView
from pytestqt.qtbot import QtBot

from tests.settings.samples import factory
from trex_gui.settings.comparison import Comparison, compare
from trex_gui.views.widgets.comparison_view import ComparisonView

BEFORE = factory()


def comparison(**values: int) -> Comparison:
    return compare(BEFORE, replace(BEFORE, parameters={**BEFORE.parameters, **values}))


@pytest.fixture
def view(qtbot: QtBot) -> ComparisonView:
    view = ComparisonView()
    qtbot.addWidget(view)
    view.resize(800, 400)
    view.show_comparison(comparison(serial_timeout=5, motor1_acceleration=9), "Now", "File")
    view.show()
    return view


def label(view: ComparisonView, name: str = "comparisonSummary") -> QLabel:
    found = view.findChild(QLabel, name)
    assert found is not None
    return found


def rows(view: ComparisonView) -> QTableView:
    found = view.findChild(QTableView, "comparisonTable")
    assert found is not None
    return found


def button(view: ComparisonView, name: str) -> QPushButton:
    found = view.findChild(QPushButton, name)
    assert found is not None
    return found


def test_the_counts_stand_above_it(view: ComparisonView) -> None:
    assert "2 will change" in label(view).text()
    assert not label(view, "comparisonLeftOut").isVisible()


def test_a_click_into_its_box_takes_a_tick_away(view: ComparisonView, qtbot: QtBot) -> None:
    table = rows(view)
    place = table.visualRect(table.model().index(0, 0))
    box = QPoint(place.left() + 10, place.center().y())
    with qtbot.waitSignal(view.ticked_changed) as told:
        QTest.mouseClick(table.viewport(), Qt.MouseButton.LeftButton, pos=box)
    assert told.args == [1]
    assert len(view.table.ticked) == 1


@pytest.mark.parametrize("column", [0, 2])
def test_the_space_bar_ticks_from_any_column(
    view: ComparisonView, qtbot: QtBot, column: int
) -> None:
    table = rows(view)
    table.selectionModel().setCurrentIndex(
        table.model().index(1, column), QItemSelectionModel.SelectionFlag.SelectCurrent
    )
    QTest.keyClick(table, Qt.Key.Key_Space)
    assert len(view.table.ticked) == 1
    QTest.keyClick(table, Qt.Key.Key_Space)
    assert len(view.table.ticked) == 2


def test_all_or_none_with_one_click(view: ComparisonView, qtbot: QtBot) -> None:
    QTest.mouseClick(button(view, "tickNoneButton"), Qt.MouseButton.LeftButton)
    assert not view.table.ticked
    QTest.mouseClick(button(view, "tickAllButton"), Qt.MouseButton.LeftButton)
    assert len(view.table.ticked) == 2


def test_what_matches_is_shown_on_demand(view: ComparisonView) -> None:
    box = view.findChild(QCheckBox, "showEqualBox")
    assert box is not None
    box.setChecked(True)
    assert rows(view).model().rowCount() == len(view.table.comparison.rows)


def test_without_ticks_there_is_nothing_to_tick_with(view: ComparisonView) -> None:
    view.show_comparison(comparison(serial_timeout=5), "Now", "File", with_ticks=False)
    assert not button(view, "tickAllButton").isVisible()
    assert not view.table.ticked


def test_renewing_keeps_the_place_and_the_widths(view: ComparisonView) -> None:
    table = rows(view)
    table.selectRow(1)
    key = table.currentIndex().data()
    table.setColumnWidth(0, 321)
    view.renew(comparison(serial_timeout=6, motor1_acceleration=9, motor_mode=1), "Renewed.")
    assert table.currentIndex().data() == key
    assert table.columnWidth(0) == 321
    assert label(view).text() == "Renewed."


def test_nothing_to_show_says_why(view: ComparisonView) -> None:
    view.show_nothing("Select a snapshot.")
    assert label(view).text() == "Select a snapshot."
    assert rows(view).model().rowCount() == 0


def test_what_is_left_out_stands_below(view: ComparisonView) -> None:
    found = replace(comparison(serial_timeout=5), left_out=("Motor Mode is left out.",))
    view.show_comparison(found, "Now", "File")
    assert "left out" in label(view, "comparisonLeftOut").text()
    assert label(view, "comparisonLeftOut").isVisible()
