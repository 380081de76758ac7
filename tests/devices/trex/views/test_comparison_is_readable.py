"""Nothing in a comparison is cut short: what is about to be written can be read in full."""

from dataclasses import replace
from functools import partial

import pytest
from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QFontMetrics
from PySide6.QtWidgets import QTableView
from pytestqt.qtbot import QtBot

from tests.devices.trex.settings.samples import factory
from tests.support.pages.settings import ComparisonDialog
from trex_gui.devices.trex.model.settings.comparison_table import ComparisonColumn
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.protocol.parameters import ParameterSpec
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.devices.trex.settings.document import specs_for
from trex_gui.devices.trex.views.comparison_view import ComparisonView

BEFORE = factory()
TICK, SIGN = 20, 20


def _length(spec: ParameterSpec, wire: int) -> int:
    return len(spec.text(wire))


def worst() -> Comparison:
    """The longest text that each setting has, a whole calibration and one not known before."""
    longest = {
        spec.key: max(spec.valid, key=partial(_length, spec))
        for spec in specs_for(BEFORE.product, BEFORE.firmware).readable
    }
    whole = Calibration(2600, 3700, 4900, 61)
    before = {p: c for p, c in BEFORE.calibrations.items() if p != "rc_channel_3"}
    after = {
        **BEFORE.calibrations,
        CalibrationKey.RC_CHANNEL_2: whole,
        CalibrationKey.RC_CHANNEL_3: whole,
    }
    return compare(
        replace(BEFORE, calibrations=before),
        replace(BEFORE, parameters=longest, calibrations=after),
    )


def cut_short(table: QTableView) -> list[str]:
    """Return the texts that their cells do not hold, measured without the view's own help."""
    bold = table.font()
    bold.setBold(True)
    model, cut = table.model(), []
    for row in range(model.rowCount()):
        for column in range(model.columnCount()):
            index = model.index(row, column)
            cell, text = table.visualRect(index), str(index.data())
            shown = cell.left() >= 0 and cell.right() < table.viewport().width()
            sign = TICK if column in {ComparisonColumn.SETTING, ComparisonColumn.OUTCOME} else 0
            font = index.data(Qt.ItemDataRole.FontRole)
            is_bold = font is not None and font.bold()
            metrics = QFontMetrics(bold if is_bold else table.font())
            room = QRect(0, 0, cell.width() - 6 - sign, 10_000)
            needed = metrics.boundingRect(room, Qt.TextFlag.TextWordWrap, text)
            if not shown or needed.width() > room.width() or needed.height() > cell.height():
                cut.append(text)
    return cut


@pytest.fixture
def view(qtbot: QtBot) -> ComparisonView:
    view = ComparisonView()
    qtbot.addWidget(view)
    view.resize(860, 400)  # inside a dialog that is 880 wide
    view.show_comparison(worst(), "On the board", "Factory default")
    view.show()
    return view


@pytest.fixture
def driver(view: ComparisonView, qtbot: QtBot) -> ComparisonDialog:
    return ComparisonDialog(view, qtbot)


def test_longest_rows_are_readable(driver: ComparisonDialog) -> None:
    texts = {str(driver.table.model().index(row, 2).data()) for row in range(40)}
    assert any("stop bit" in text for text in texts)
    assert cut_short(driver.table) == []


def test_rejection_reasons_are_readable(view: ComparisonView, driver: ComparisonDialog) -> None:
    why = "The board refused it: Channels 1, 2 and 3 drive the motors, but not in this mode."
    view.table.set_outcomes({row.key: why for row in view.table.comparison.rows})
    assert cut_short(driver.table) == []
    view.freeze("Before", "New value")
    assert cut_short(driver.table) == []


def test_rows_stay_readable_when_a_column_is_narrowed(driver: ComparisonDialog) -> None:
    table = driver.table
    table.setColumnWidth(ComparisonColumn.AFTER, 90)
    assert cut_short(driver.table) == []
