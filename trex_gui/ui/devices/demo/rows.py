"""Rows of a panel: name, slider, value, ticks, in the same columns in every group."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Generic

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QGridLayout, QGroupBox, QHBoxLayout, QLabel, QWidget

from trex_gui.ui.devices.demo_device import SnapshotT

_NAME, _SLIDER, _VALUE, _TICK = range(4)
_GROOVE = 7  # pixels from the edge of a slider to its groove: half a handle


@dataclass(frozen=True, slots=True)
class Columns:
    """The longest text of each column, so that all groups of a panel have them in line."""

    name: str
    value: str
    ticks: tuple[str, ...] = ()


class Rows(QGroupBox, Generic[SnapshotT]):
    """A group of such rows."""

    def __init__(self, columns: Columns, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._row = 0
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(8, 4, 8, 6)
        self._grid.setHorizontalSpacing(6)
        self._grid.setVerticalSpacing(5)
        self._grid.setColumnStretch(_SLIDER, 1)
        widest = {_NAME: columns.name, _VALUE: columns.value}
        widest |= dict(enumerate(columns.ticks, start=_TICK))
        for column, text in widest.items():
            width = self.fontMetrics().horizontalAdvance(text)
            self._grid.setColumnMinimumWidth(column, width + 2)

    def show_snapshot(self, snapshot: SnapshotT) -> None:
        """Show what it is about, as it is."""
        raise NotImplementedError

    def controls(self) -> list[QWidget]:
        """Return everything that takes the focus, in the order of Tab."""
        raise NotImplementedError

    def add_headings(self, slider: str, *ticks: str, over_value: bool = False) -> None:
        """Put words over the sliders, or over these and their values, and over the ticks below."""
        row = self._next()
        for column, text in ((_SLIDER, slider), *enumerate(ticks, start=_TICK)):
            label = QLabel(text, self)
            label.setAlignment(Qt.AlignmentFlag.AlignHCenter)
            columns = 2 if over_value and column == _SLIDER else 1
            self._grid.addWidget(label, row, column, 1, columns)

    def add_row(
        self, name: str, slider: QWidget, value: QLabel, ticks: Sequence[QWidget] = ()
    ) -> QLabel:
        """Put a row below the others; return the label with the name.

        What is no tick in a column of ticks is as wide as there is room.
        """
        row = self._next()
        label = QLabel(name, self)
        label.setBuddy(slider)
        value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._grid.addWidget(label, row, _NAME)
        self._grid.addWidget(slider, row, _SLIDER)
        self._grid.addWidget(value, row, _VALUE)
        for column, tick in enumerate(ticks, start=_TICK):
            if isinstance(tick, QCheckBox):
                self._grid.addWidget(tick, row, column, Qt.AlignmentFlag.AlignHCenter)
            else:
                self._grid.addWidget(tick, row, column)
                self._grid.setColumnStretch(column, 1)
        return label

    def add_words(self, words: QLabel) -> None:
        """Put words below the slider of the last row, as wide as slider and value."""
        words.setIndent(_GROOVE)
        self._grid.addWidget(words, self._next(), _SLIDER, 1, 2)

    def add_wide(self, widget: QWidget) -> None:
        """Put something over all columns."""
        self._grid.addWidget(widget, self._next(), 0, 1, -1)

    def _next(self) -> int:
        self._row += 1
        return self._row


def side_by_side(parent: QWidget, *widgets: tuple[QWidget, int]) -> QWidget:
    """Return widgets in one line, each with its stretch."""
    line = QWidget(parent)
    layout = QHBoxLayout(line)
    layout.setContentsMargins(0, 0, 0, 0)
    for widget, stretch in widgets:
        layout.addWidget(widget, stretch)
    return line
