"""The figures of a bench test beside those of another test."""

from PySide6.QtCore import QCoreApplication, QSize, Qt
from PySide6.QtWidgets import (
    QAbstractItemView,
    QHeaderView,
    QTableWidget,
    QTableWidgetItem,
    QWidget,
)

from trex_gui.devices.trex.bench.figures import BAND, Figures, figures
from trex_gui.devices.trex.bench.run import Run
from trex_gui.ui.widgets.bar import MINUS, NO_VALUE
from trex_gui.ui.widgets.behaviour import name_headers


def tr(text: str) -> str:
    """Translate a text of this table."""
    return QCoreApplication.translate("figures_table", text)


def _rows(band: float = BAND) -> tuple[tuple[str, str, str, int, str], ...]:
    """Return name, field of `Figures`, unit, decimals and explanation of each row."""
    return (
        (tr("Peak current"), "peak", "A", 2, tr("The highest reading.")),
        (tr("Steady current"), "steady", "A", 2, tr("At the end of the first constant speed.")),
        (tr("Mean current"), "mean", "A", 2, tr("From the first setpoint until braking.")),
        (tr("Charge"), "charge", "mAh", 2, tr("From the first setpoint until braking.")),
        (
            tr("Setpoint to current"),
            "delay",
            "ms",
            0,
            tr("Until the first reading of two counts: the line, the board and its measurement."),
        ),
        (
            tr("Settled within {0:.0f} % after").format(100 * band),
            "settled",
            "ms",
            0,
            tr(
                "Until the current stayed within this share of the steady current, or within two "
                "counts of it."
            ),
        ),
    )


class FiguresTable(QTableWidget):
    """A row for each figure: this test, the one compared with, and the difference."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("benchFigures")
        self.setAccessibleName(self.tr("Figures of the test"))
        name_headers(self)
        rows = _rows()
        self.setRowCount(len(rows))
        self.setColumnCount(3)
        self.setHorizontalHeaderLabels(
            [self.tr("This test"), self.tr("Compared"), self.tr("Change")]
        )
        self.setVerticalHeaderLabels([row[0] for row in rows])
        for index, row in enumerate(rows):
            if (header := self.verticalHeaderItem(index)) is not None:
                header.setToolTip(row[4])
            for column in range(3):
                item = QTableWidgetItem(NO_VALUE)
                item.setFlags(Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable)
                item.setTextAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
                item.setToolTip(row[4])
                self.setItem(index, column, item)
        self.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
        self.setTabKeyNavigation(False)
        self.horizontalHeader().setSectionResizeMode(QHeaderView.ResizeMode.Stretch)
        self.horizontalHeader().setHighlightSections(False)
        self.verticalHeader().setHighlightSections(False)
        self.verticalHeader().setDefaultSectionSize(self.fontMetrics().height() + 6)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)

    def show_runs(self, run: Run | None, before: Run | None, band: float = BAND) -> None:
        """Show the figures of two tests; `band` (0 to 1) of the steady current is settled."""
        now = figures(run, band) if run is not None else Figures()
        then = figures(before, band) if before is not None else Figures()
        for index, (name, field, unit, decimals, _) in enumerate(_rows(band)):
            if (header := self.verticalHeaderItem(index)) is not None:
                header.setText(name)
            scale = 1000 if unit == "ms" else 1
            values = [getattr(each, field) for each in (now, then)]
            one, other = (None if value is None else value * scale for value in values)
            change = None if one is None or other is None else one - other
            self._put(index, 0, _text(one, unit, decimals))
            self._put(index, 1, _text(other, unit, decimals))
            self._put(index, 2, _text(change, unit, decimals, sign=True))

    def _put(self, row: int, column: int, text: str) -> None:
        if (item := self.item(row, column)) is not None:
            item.setText(text)

    def sizeHint(self) -> QSize:
        rows = self.rowCount() * self.verticalHeader().defaultSectionSize()
        height = rows + self.horizontalHeader().sizeHint().height() + 2 * self.frameWidth()
        return QSize(super().sizeHint().width(), height)

    def minimumSizeHint(self) -> QSize:
        return QSize(super().minimumSizeHint().width(), self.sizeHint().height() // 2)


def _text(value: float | None, unit: str, decimals: int, *, sign: bool = False) -> str:
    if value is None:
        return NO_VALUE
    number = f"{value:+.{decimals}f}" if sign else f"{value:.{decimals}f}"
    return f"{number.replace('-', MINUS)} {unit}"
