"""Rows of the panel: name, slider, value, tick, in the same columns in every group."""

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QGridLayout, QGroupBox, QHBoxLayout, QLabel, QWidget

from trex_gui.views.widgets.stick_slider import StickSlider

_NAME, _SLIDER, _VALUE, _TICK = range(4)
_GROOVE = 7  # pixels from the edge of a slider to its groove: half a handle


class Rows(QGroupBox):
    """A group of such rows."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._row = 0
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(8, 4, 8, 6)
        self._grid.setHorizontalSpacing(6)
        self._grid.setVerticalSpacing(5)
        self._grid.setColumnStretch(_SLIDER, 1)
        for column, text in (
            (_NAME, self.tr("5 override")),
            (_VALUE, "2100\u00a0µs"),
            (_TICK, self.tr("No signal")),
        ):
            width = self.fontMetrics().horizontalAdvance(text)
            self._grid.setColumnMinimumWidth(column, width + 2)

    def add_headings(self, slider: str, tick: str) -> None:
        """Put words over the sliders and over the ticks below."""
        row = self._next()
        for column, text in ((_SLIDER, slider), (_TICK, tick)):
            label = QLabel(text, self)
            label.setAlignment(Qt.AlignmentFlag.AlignHCenter)
            self._grid.addWidget(label, row, column)

    def add_row(
        self, name: str, slider: StickSlider, value: QLabel, tick: QCheckBox | None
    ) -> QLabel:
        """Put a row below the others; return the label with the name."""
        row = self._next()
        label = QLabel(name, self)
        label.setBuddy(slider)
        value.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._grid.addWidget(label, row, _NAME)
        self._grid.addWidget(slider, row, _SLIDER)
        self._grid.addWidget(value, row, _VALUE)
        if tick is not None:
            self._grid.addWidget(tick, row, _TICK, Qt.AlignmentFlag.AlignHCenter)
        return label

    def add_words(self, words: QLabel) -> None:
        """Put words below the slider of the last row, as wide as slider and value."""
        words.setIndent(_GROOVE)
        self._grid.addWidget(words, self._next(), _SLIDER, 1, 2)

    def add_wide(self, widget: QWidget) -> None:
        """Put something over all columns."""
        self._grid.addWidget(widget, self._next(), 0, 1, 4)

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
