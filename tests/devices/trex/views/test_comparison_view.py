"""Comparison of settings, operated with mouse and keys."""

from dataclasses import replace

import pytest
from PySide6.QtCore import QItemSelectionModel, QPoint, QRect, Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QCheckBox, QTableView
from pytestqt.qtbot import QtBot

from tests.devices.trex.settings.samples import factory
from tests.support.pages.settings import ComparisonDialog
from tests.support.window import LEFT
from trex_gui.devices.trex.model.settings.comparison_table import ComparisonColumn
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import specs_for
from trex_gui.devices.trex.views.comparison_view import ComparisonView

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


@pytest.fixture
def driver(view: ComparisonView, qtbot: QtBot) -> ComparisonDialog:
    return ComparisonDialog(view, qtbot)


def test_click_on_a_check_box_clears_it(
    view: ComparisonView, driver: ComparisonDialog, qtbot: QtBot
) -> None:
    table = driver.table
    cell = table.visualRect(table.model().index(0, 0))
    box = QPoint(cell.left() + 10, cell.center().y())
    with qtbot.waitSignal(view.ticked_changed) as changed:
        QTest.mouseClick(table.viewport(), LEFT, pos=box)
    assert changed.args == [1]
    assert len(view.table.ticked) == 1


@pytest.mark.parametrize("column", [0, 2])
def test_space_bar_toggles_the_row_from_any_column(
    view: ComparisonView, driver: ComparisonDialog, column: int
) -> None:
    table = driver.table
    table.selectionModel().setCurrentIndex(
        table.model().index(1, column), QItemSelectionModel.SelectionFlag.SelectCurrent
    )
    QTest.keyClick(table, Qt.Key.Key_Space)
    assert len(view.table.ticked) == 1
    QTest.keyClick(table, Qt.Key.Key_Space)
    assert len(view.table.ticked) == 2


def test_box_checks_all_rows_or_none(view: ComparisonView, driver: ComparisonDialog) -> None:
    assert not driver.has("tickAllBox"), "two rows need no common box"
    changes = comparison(serial_timeout=5, motor1_acceleration=9, motor_mode=1, ignored_channels=2)
    view.show_comparison(changes, "Now", "File")
    driver.toggle("Motor Mode")
    box = driver.find(QCheckBox, "tickAllBox")
    assert box.checkState() is Qt.CheckState.PartiallyChecked
    for ticked in (4, 0):
        driver.click("tickAllBox")
        assert len(view.table.ticked) == ticked
    view.show_comparison(changes, "Now", "File", with_ticks=False)
    assert not driver.has("tickAllBox")
    assert not view.table.ticked


def test_details_show_wire_values_and_matches(
    view: ComparisonView, driver: ComparisonDialog
) -> None:
    assert driver.table.isColumnHidden(ComparisonColumn.WIRE)
    driver.click("detailsBox")
    assert not driver.table.isColumnHidden(ComparisonColumn.WIRE)
    assert len(driver.rows()) == len(view.table.comparison.rows)


def test_update_retains_the_current_row_and_its_check_box(
    view: ComparisonView, driver: ComparisonDialog
) -> None:
    driver.toggle(key := "Motor 1 Acceleration")
    changes = comparison(serial_timeout=6, motor1_acceleration=9, motor_mode=1)
    view.show_comparison(changes, "Now", "File", summary="Renewed.")
    assert driver.table.currentIndex().data() == key
    assert {row.key for row in view.table.ticked} == {"serial_timeout", "motor_mode"}
    assert driver.text("comparisonSummary") == "Renewed."


def test_left_out_settings_are_listed(view: ComparisonView, driver: ComparisonDialog) -> None:
    changes = replace(comparison(serial_timeout=5), left_out=("Motor Mode is left out.",))
    view.show_comparison(changes, "Now", "File")
    assert "left out" in driver.text("comparisonLeftOut")
    assert driver.has("comparisonLeftOut")
    view.show_nothing("Select a snapshot.")
    assert driver.text("comparisonSummary") == "Select a snapshot."
    assert driver.table.model().rowCount() == 0


# --- Text that fits its cell ------------------------------------------------------------


SIGN_WIDTH = 20  # pixels


def longest_texts() -> Comparison:
    """Return a comparison with the longest text of each setting and with a new calibration."""
    longest = {
        spec.key: max((len(spec.text(wire)), wire) for wire in spec.valid)[1]
        for spec in specs_for(BEFORE.product, BEFORE.firmware).readable
    }
    calibration = Calibration(2600, 3700, 4900, 61)
    before = {**BEFORE.calibrations}
    del before[CalibrationKey.RC_CHANNEL_3]
    after = {
        **BEFORE.calibrations,
        CalibrationKey.RC_CHANNEL_2: calibration,
        CalibrationKey.RC_CHANNEL_3: calibration,
    }
    return compare(
        replace(BEFORE, calibrations=before),
        replace(BEFORE, parameters=longest, calibrations=after),
    )


def truncated_texts(table: QTableView) -> list[str]:
    """Return the texts that do not fit into their cells, measured independently of the view."""
    bold = table.font()
    bold.setBold(True)
    model, truncated = table.model(), []
    for row in range(model.rowCount()):
        for column in range(model.columnCount()):
            index = model.index(row, column)
            cell, text = table.visualRect(index), str(index.data())
            is_visible = cell.left() >= 0 and cell.right() < table.viewport().width()
            sign = 0 if column in {ComparisonColumn.BEFORE, ComparisonColumn.WIRE} else SIGN_WIDTH
            font = index.data(Qt.ItemDataRole.FontRole)
            is_bold = font is not None and font.bold()
            metrics = QFontMetrics(bold if is_bold else table.font())
            space = QRect(0, 0, cell.width() - 6 - sign, 10_000)
            needed = metrics.boundingRect(space, Qt.TextFlag.TextWordWrap, text)
            if not is_visible or needed.width() > space.width() or needed.height() > cell.height():
                truncated.append(text)
    return truncated


def test_longest_rows_and_reasons_are_readable(
    view: ComparisonView, driver: ComparisonDialog
) -> None:
    view.resize(712, 400)  # in a dialog of width 760
    driver.click("detailsBox")
    view.show_comparison(longest_texts(), "On the board", "Factory default")
    table = driver.table
    texts = {str(table.model().index(row, 2).data()) for row in range(40)}
    assert any("stop bit" in text for text in texts)
    assert truncated_texts(table) == []

    reason = "The board refused it: Channels 1, 2 and 3 drive the motors, but not in this mode."
    outcomes = {row.key: reason for row in view.table.comparison.rows}
    view.show_comparison(longest_texts(), "Before", "After", with_ticks=False, outcomes=outcomes)
    assert truncated_texts(table) == []
