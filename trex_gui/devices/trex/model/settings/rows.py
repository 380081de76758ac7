"""Update the rows of a model without losing selection and scroll position."""

from collections.abc import Callable, Hashable, Sequence
from typing import TypeVar

from PySide6.QtCore import QAbstractItemModel, QModelIndex

RowT = TypeVar("RowT")


def renew_rows(
    model: QAbstractItemModel,
    rows: list[RowT],
    wanted: Sequence[RowT],
    key: Callable[[RowT], Hashable],
) -> None:
    """Change the `rows` of a model in place to the wanted ones, and announce only differences.

    Selection, scroll position and check boxes are kept. `key` identifies a row. A different
    order of rows that stay resets the model.
    """
    if not rows and not wanted:
        return
    keys = [key(row) for row in wanted]
    had = [key(row) for row in rows]
    stay = set(keys) & set(had)
    if not rows or [k for k in had if k in stay] != [k for k in keys if k in stay]:
        model.beginResetModel()
        rows[:] = wanted
        model.endResetModel()
        return
    nowhere = QModelIndex()
    for place in reversed(range(len(rows))):
        if key(rows[place]) not in stay:
            model.beginRemoveRows(nowhere, place, place)
            del rows[place]
            model.endRemoveRows()
    for place, row in enumerate(wanted):
        if place >= len(rows) or key(rows[place]) != keys[place]:
            model.beginInsertRows(nowhere, place, place)
            rows.insert(place, row)
            model.endInsertRows()
        elif rows[place] != row:
            rows[place] = row
            last = model.index(place, model.columnCount() - 1)
            model.dataChanged.emit(model.index(place, 0), last)
