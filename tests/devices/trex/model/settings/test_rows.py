"""A list of rows becomes another; whoever looks at it keeps their place."""

from typing import Any

from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QAbstractTableModel, QModelIndex, QPersistentModelIndex, Qt
from pytestqt.qtbot import QtBot

from trex_gui.devices.trex.model.settings.comparison_table import renew_rows

Cell = tuple[int, str]


class Table(QAbstractTableModel):
    def __init__(self) -> None:
        super().__init__()
        self.rows: list[Cell] = []

    def rowCount(self, parent: QModelIndex | QPersistentModelIndex | None = None) -> int:
        return 0 if parent is not None and parent.isValid() else len(self.rows)

    def columnCount(self, parent: QModelIndex | QPersistentModelIndex | None = None) -> int:
        return 2

    def data(
        self,
        index: QModelIndex | QPersistentModelIndex,
        role: int = Qt.ItemDataRole.DisplayRole,
    ) -> Any:
        return self.rows[index.row()][index.column()]

    def become(self, rows: list[Cell]) -> None:
        renew_rows(self, self.rows, rows, lambda row: row[0])


_rows = st.dictionaries(st.integers(0, 9), st.sampled_from("ab"))


@given(first=_rows, second=_rows)
def test_renewed_rows_equal_the_new_list_and_keep_indexes(
    first: dict[int, str], second: dict[int, str]
) -> None:
    table = Table()
    table.become(sorted(first.items()))
    places = {
        key: QPersistentModelIndex(table.index(row, 0)) for row, key in enumerate(sorted(first))
    }
    table.become(sorted(second.items()))
    assert table.rows == sorted(second.items())
    for key, place in places.items():
        assert place.isValid() == (key in second)
        assert not place.isValid() or place.data() == key


@given(first=st.permutations(range(5)), second=st.permutations(range(5)))
def test_reordered_rows_are_renewed_correctly(first: list[int], second: list[int]) -> None:
    table = Table()
    table.become([(number, "") for number in first])
    table.become([(number, "") for number in second])
    assert table.rows == [(number, "") for number in second]


def test_unchanged_rows_emit_no_signal(qtbot: QtBot) -> None:
    table = Table()
    table.become([(1, "a"), (2, "a")])
    with qtbot.assertNotEmitted(table.dataChanged), qtbot.assertNotEmitted(table.modelReset):
        table.become([(1, "a"), (2, "a")])
    with qtbot.waitSignal(table.dataChanged) as announced:
        table.become([(1, "a"), (2, "b")])
    assert announced.args is not None
    assert announced.args[0].row() == announced.args[1].row() == 1
