"""A spin box for raw counts that speaks µs or V."""

import re

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QValidator, QWheelEvent
from PySide6.QtWidgets import QSpinBox, QWidget

from trex_gui.devices.trex.protocol.calibration import HIGHEST_CODED
from trex_gui.devices.trex.protocol.flags import InputSource

_NUMBER = re.compile(r"\s*([0-9]{1,6}(?:[.,][0-9]{0,6})?)\s*(\S*)\s*")
_UNITS = {
    InputSource.RC: {"": 1.0, "µs": 1.0, "μs": 1.0, "us": 1.0, "ms": 1000.0, "s": 1e6},
    InputSource.ANALOG: {"": 1.0, "v": 1.0, "mv": 0.001},
}
_COUNTS = {"count", "counts", "#"}


class CountEditor(QSpinBox):
    """Counts as value, physical units as text; `2.1 ms`, `1500` or `3750 counts` may be typed.

    Signals:
        rejected: why the typed text is no value, as a sentence.
    """

    rejected = Signal(str)

    def __init__(self, source: InputSource, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._source = source
        self._stepping = False
        self.setRange(0, HIGHEST_CODED)
        self.setKeyboardTracking(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccelerated(True)
        self.setToolTip(self._expected())

    def set_source(self, source: InputSource) -> None:
        """Speak the units of another input source; the count stays."""
        if source is not self._source:
            self._source = source
            self.setToolTip(self._expected())
            with QSignalBlocker(self):
                self.lineEdit().setText(self.textFromValue(self.value()))

    @property
    def stepping(self) -> bool:
        """Whether the value changes by a step now: a key, the wheel or a button, nothing typed."""
        return self._stepping

    def stepBy(self, steps: int) -> None:
        self._stepping = True
        super().stepBy(steps)
        self._stepping = False

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Turn with the wheel only what has the focus."""
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()

    def textFromValue(self, val: int) -> str:
        decimals = 1 if self._source is InputSource.RC else 3
        number = f"{self._source.physical(val):.{decimals}f}".removesuffix(".0")
        return f"{number} {self._source.unit}"

    def valueFromText(self, text: str) -> int:
        count = self._count(text)
        return self.value() if count is None else count

    def validate(self, text: str, pos: int) -> tuple[QValidator.State, str, int]:
        good = self._count(text) is not None
        state = QValidator.State.Acceptable if good else QValidator.State.Intermediate
        return state, text, pos

    def fixup(self, text: str) -> str:
        """Say why what was typed is dropped when the editor is left."""
        self.report_problem()
        return super().fixup(text)

    def report_problem(self) -> None:
        """Emit `rejected` if the text is no value."""
        if self._count(self.text()) is None:
            words = self.tr("{0} is no value here. {1}")
            self.rejected.emit(words.format(self.text().strip() or "“”", self._expected()))

    def _count(self, text: str) -> int | None:
        found = _NUMBER.fullmatch(text)
        if found is None:
            return None
        number, unit = float(found[1].replace(",", ".")), found[2].casefold()
        if unit in _COUNTS:
            count = round(number)
        elif unit in _UNITS[self._source]:
            count = self._source.counts(number * _UNITS[self._source][unit])
        else:
            return None
        return count if 0 <= count <= HIGHEST_CODED else None

    def _expected(self) -> str:
        highest = self._source.text(HIGHEST_CODED)
        if self._source is InputSource.RC:
            return self.tr("Expected is 0 to {0}, such as 1500, 1.5 ms or 3750 counts.").format(
                highest
            )
        return self.tr("Expected is 0 to {0}, such as 2.5, 2500 mV or 512 counts.").format(highest)
