"""Table that compares the figures of two bench tests."""

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from trex_gui.core.translation import Number, tr
from trex_gui.devices.trex.bench.run import BAND, Figures, Run, figures
from trex_gui.ui.widgets.bar import MINUS, NO_VALUE
from trex_gui.ui.widgets.behaviour import name_headers
from trex_gui.ui.widgets.builders import plain, set_row_height


def _rows(band: float = BAND) -> tuple[tuple[str, str, str, str], ...]:
    """Return name, field of `Figures`, unit and explanation of each row."""
    until_braking = tr("From the first setpoint until braking.")
    return (
        (tr("Peak current"), "peak", "A", tr("The highest reading.")),
        (tr("Steady current"), "steady", "A", tr("At the end of the first constant speed.")),
        (tr("Mean current"), "mean", "A", until_braking),
        (tr("Charge"), "charge", "mAh", until_braking),
        (
            tr("Setpoint to current"),
            "delay",
            "ms",
            tr("Until the first reading of two counts: the line, the board and its measurement."),
        ),
        (
            tr("Settled within {0:.0f} % after").format(100 * band),
            "settled",
            "ms",
            tr(
                "Until the current stayed within this share of the steady current, or within two "
                "counts of it."
            ),
        ),
    )


class FiguresTable(QTableWidget):
    """Table of figures: this test, the test compared with it, and the difference."""

    def __init__(self, parent: QWidget | None = None) -> None:
        rows = _rows()
        super().__init__(len(rows), 3, parent)
        self.setObjectName("benchFigures")
        self.setAccessibleName(tr("Figures of the test"))
        name_headers(self)
        self.setHorizontalHeaderLabels([tr("This test"), tr("Compared"), tr("Change")])
        for index, (name, _, _, explanation) in enumerate(rows):
            header = QTableWidgetItem(name)
            header.setToolTip(plain(explanation))
            self.setVerticalHeaderItem(index, header)
            for column in range(3):
                item = QTableWidgetItem(NO_VALUE)
                item.setFlags(Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable)
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                item.setToolTip(plain(explanation))
                self.setItem(index, column, item)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setTabKeyNavigation(False)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        for headers in (self.horizontalHeader(), self.verticalHeader()):
            headers.setHighlightSections(False)
        set_row_height(self, 12)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)

    def show_runs(self, run: Run | None, before: Run | None, band: float) -> None:
        """Show the figures of two tests. `band`: settling range, 0 to 1 of the steady current."""
        now, then = (Figures() if test is None else figures(test, band) for test in (run, before))
        for index, (name, field, unit, _) in enumerate(_rows(band)):
            one, other = getattr(now, field), getattr(then, field)
            change = None if one is None or other is None else one - other
            texts = _text(one, unit), _text(other, unit), _text(change, unit, "+")
            for column, text in enumerate(texts):
                self.model().setData(self.model().index(index, column), text)
            self.model().setHeaderData(index, Qt.Orientation.Vertical, name)

    def sizeHint(self) -> QSize:
        rows = self.rowCount() * self.verticalHeader().defaultSectionSize()
        height = rows + self.horizontalHeader().sizeHint().height() + 2 * self.frameWidth()
        return QSize(super().sizeHint().width(), height)

    def minimumSizeHint(self) -> QSize:
        return QSize(super().minimumSizeHint().width(), self.sizeHint().height() // 2)


def _text(value: float | None, unit: str, sign: str = "") -> str:
    if value is None:
        return NO_VALUE
    number = f"{1000 * value:{sign}.0f}" if unit == "ms" else f"{Number(value):{sign}.2f}"
    return f"{number.replace('-', MINUS)} {unit}"
