"""Comparison of settings as a Qt model, and checked changes."""

from dataclasses import replace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt
from pytestqt.modeltest import ModelTester
from pytestqt.qtbot import QtBot

from tests.devices.trex.settings.samples import factory
from trex_gui.devices.trex.model.settings.comparison_table import (
    ComparisonColumn,
    ComparisonTable,
    renew_rows,
)
from trex_gui.devices.trex.protocol.calibration import Calibration, CalibrationKey
from trex_gui.devices.trex.settings.comparison import Comparison, compare
from trex_gui.ui.theme.icons import icon

BEFORE = factory()


def comparison(**values: int) -> Comparison:
    return compare(BEFORE, replace(BEFORE, parameters={**BEFORE.parameters, **values}))


@pytest.fixture
def table(qtbot: QtBot) -> ComparisonTable:
    table = ComparisonTable()
    table.show_comparison(comparison(serial_timeout=5, motor1_acceleration=9), "Now", "File")
    return table


def keys(table: ComparisonTable) -> list[str]:
    return [table.index(row, 0).data(Qt.ItemDataRole.UserRole) for row in range(table.rowCount())]


def index(table: ComparisonTable, key: str, column: int = ComparisonColumn.SETTING) -> QModelIndex:
    return table.index(keys(table).index(key), column)


def checked_keys(table: ComparisonTable) -> set[str]:
    return {row.key for row in table.ticked}


def set_checked(table: ComparisonTable, key: str, checked: bool) -> bool:
    state = Qt.CheckState.Checked if checked else Qt.CheckState.Unchecked
    return table.setData(index(table, key), state, Qt.ItemDataRole.CheckStateRole)


def test_table_passes_qt_model_tester_through_changes(
    table: ComparisonTable, qtmodeltester: ModelTester
) -> None:
    qtmodeltester.check(table)  # type: ignore[no-untyped-call] # of pytest-qt
    table.set_with_equal(True)
    table.renew(comparison(serial_timeout=7, motor_mode=1))
    table.set_with_equal(False)
    table.renew(comparison(serial_timeout=7))
    table.show_comparison(table.comparison, "Was", "Is", outcomes={"serial_timeout": ""})
    table.show_comparison(Comparison(()), "", "")


def test_differing_rows_are_shown_and_checked(table: ComparisonTable) -> None:
    assert set(keys(table)) == {"serial_timeout", "motor1_acceleration"}
    assert checked_keys(table) == set(keys(table))
    columns = range(table.columnCount())
    headings = [table.headerData(column, Qt.Orientation.Horizontal) for column in columns]
    assert headings == ["Setting", "Now", "File", "Wire"]
    assert index(table, "serial_timeout", ComparisonColumn.AFTER).data() == "0.5 s"
    assert index(table, "serial_timeout", ComparisonColumn.WIRE).data() == "0 → 5"


def test_equal_rows_are_shown_on_request_without_check_box(table: ComparisonTable) -> None:
    row = QPersistentModelIndex(index(table, "serial_timeout"))
    table.set_with_equal(True)
    assert table.rowCount() == len(table.comparison.rows)
    assert index(table, "motor_mode").data(Qt.ItemDataRole.CheckStateRole) is None
    assert not set_checked(table, "motor_mode", True)
    table.set_with_equal(False)
    assert table.rowCount() == 2
    assert row.isValid()
    assert row.data(Qt.ItemDataRole.UserRole) == "serial_timeout"


def test_row_can_be_unchecked_and_checked(table: ComparisonTable, qtbot: QtBot) -> None:
    with qtbot.waitSignal(table.ticked_changed):
        assert set_checked(table, "serial_timeout", False)
    assert checked_keys(table) == {"motor1_acceleration"}
    table.toggle(index(table, "serial_timeout").row())
    assert checked_keys(table) == {"motor1_acceleration", "serial_timeout"}
    table.tick_all(False)
    assert not table.ticked
    table.tick_all(True)
    assert len(table.ticked) == 2


def test_rows_cannot_be_checked_without_check_boxes(table: ComparisonTable) -> None:
    table.show_comparison(comparison(serial_timeout=5), "Now", "File", with_ticks=False)
    assert not table.ticked
    table.tick_all(True)
    table.toggle(0)
    assert not table.ticked
    assert not set_checked(table, "serial_timeout", True)


def test_unchecked_row_stays_unchecked_when_values_change(table: ComparisonTable) -> None:
    set_checked(table, "serial_timeout", False)
    table.renew(comparison(serial_timeout=6, motor1_acceleration=9, motor_mode=1))
    assert checked_keys(table) == {"motor1_acceleration", "motor_mode"}
    table.renew(comparison(motor1_acceleration=9))
    table.renew(comparison(serial_timeout=6, motor1_acceleration=9))
    assert checked_keys(table) == {"motor1_acceleration"}
    table.renew(comparison(serial_timeout=6, motor1_acceleration=9, motor_mode=1), tick_new=False)
    assert checked_keys(table) == {"motor1_acceleration"}


def test_outcomes_add_a_column_of_plain_text(table: ComparisonTable) -> None:
    outcomes = {"serial_timeout": "", "motor1_acceleration": "no <b>reply</b>"}
    table.show_comparison(table.comparison, "Now", "File", outcomes=outcomes)
    assert table.columnCount() == 5
    decoration = Qt.ItemDataRole.DecorationRole
    outcome = index(table, "serial_timeout", ComparisonColumn.OUTCOME)
    assert outcome.data().startswith("stored")
    assert outcome.data(decoration).cacheKey() == icon("ok").cacheKey()
    rejected = index(table, "motor1_acceleration", ComparisonColumn.OUTCOME)
    assert rejected.data() == "no <b>reply</b>"
    assert "&lt;b&gt;" in rejected.data(Qt.ItemDataRole.ToolTipRole)
    assert rejected.data(decoration).cacheKey() == icon("warning").cacheKey()


def test_calibration_row_shows_only_differing_fields(table: ComparisonTable) -> None:
    key = CalibrationKey.RC_CHANNEL_2
    old = BEFORE.calibrations[key]
    new = Calibration(old.minimum, old.neutral, old.maximum, old.deadband + 10)
    after = replace(BEFORE, calibrations={**BEFORE.calibrations, key: new})
    table.show_comparison(compare(BEFORE, after), "Now", "File")
    assert index(table, key, ComparisonColumn.AFTER).data().startswith("deadband ")
    assert index(table, key, ComparisonColumn.WIRE).data() == f"{old.deadband} → {new.deadband}"


def test_equal_calibration_with_a_note_is_shown_in_full(table: ComparisonTable) -> None:
    key = CalibrationKey.RC_CHANNEL_2
    table.show_comparison(compare(BEFORE, replace(BEFORE, notes={key: "by hand"})), "Now", "File")
    texts = [index(table, key, column).data() for column in (1, 2)]
    assert texts == ["1000 / 1500 / 2000 µs, deadband 30 µs"] * 2


def test_missing_value_is_shown_as_not_given(table: ComparisonTable) -> None:
    after = replace(BEFORE, parameters={"serial_timeout": 5}, calibrations={})
    table.show_comparison(compare(BEFORE, after), "Now", "File")
    assert index(table, "motor_mode", ComparisonColumn.AFTER).data() == "not given"
    assert checked_keys(table) == {"serial_timeout"}


# --- Renewed rows -----------------------------------------------------------------------


Row = tuple[int, str]


class Table(QAbstractTableModel):
    """Table with two columns whose rows are replaced."""

    def __init__(self) -> None:
        super().__init__()
        self.rows: list[Row] = []

    def rowCount(self, _parent: Any = None) -> int:
        return len(self.rows)

    def columnCount(self, _parent: Any = None) -> int:
        return 2

    def data(self, index: QModelIndex | QPersistentModelIndex, _role: int = 0) -> Any:
        return self.rows[index.row()][index.column()]

    def set_rows(self, rows: list[Row]) -> None:
        renew_rows(self, self.rows, rows, lambda row: row[0])


_rows = st.dictionaries(st.integers(0, 9), st.sampled_from("ab"))


@given(first=_rows, second=_rows)
def test_renewed_rows_equal_the_new_rows_and_retain_indexes(
    first: dict[int, str], second: dict[int, str]
) -> None:
    table = Table()
    table.set_rows(sorted(first.items()))
    indexes = {
        key: QPersistentModelIndex(table.index(row, 0)) for row, key in enumerate(sorted(first))
    }
    table.set_rows(sorted(second.items()))
    assert table.rows == sorted(second.items())
    for key, cell in indexes.items():
        assert cell.isValid() == (key in second)
        assert not cell.isValid() or cell.data() == key


@given(first=st.permutations(range(5)), second=st.permutations(range(5)))
def test_reordered_rows_are_renewed_correctly(first: list[int], second: list[int]) -> None:
    table = Table()
    table.set_rows([(number, "") for number in first])
    table.set_rows([(number, "") for number in second])
    assert table.rows == [(number, "") for number in second]


def test_unchanged_rows_emit_no_signal(qtbot: QtBot) -> None:
    table = Table()
    table.set_rows([(1, "a"), (2, "a")])
    with qtbot.assertNotEmitted(table.dataChanged), qtbot.assertNotEmitted(table.modelReset):
        table.set_rows([(1, "a"), (2, "a")])
    with qtbot.waitSignal(table.dataChanged) as changed:
        table.set_rows([(1, "a"), (2, "b")])
    assert changed.args is not None
    assert changed.args[0].row() == changed.args[1].row() == 1
