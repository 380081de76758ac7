"""Spin boxes that show and accept numbers in several units, and a delegate for tables."""

import math
import re
from contextlib import suppress
from functools import partial

from PySide6.QtCore import QEvent, QObject, QSignalBlocker, Qt, Signal, Slot
from PySide6.QtGui import QAction, QKeyEvent, QValidator
from PySide6.QtWidgets import QLineEdit, QSpinBox, QStyledItemDelegate, QWidget

from trex_gui.core.decimals import DECIMAL, AmbiguousNumber, quantity
from trex_gui.core.errors import BadRequest
from trex_gui.core.translation import tr, with_decimal_point
from trex_gui.devices.trex.protocol.calibration import HIGHEST_CODED, read_count
from trex_gui.devices.trex.protocol.flags import InputSource
from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.translations import error_sentence
from trex_gui.ui.units import units
from trex_gui.ui.widgets.behaviour import focused_wheel
from trex_gui.ui.widgets.builders import plain
from trex_gui.ui.widgets.painted import never_mirror

BARE = re.compile(rf"\s*{DECIMAL}\s*")  # a number without a unit


class UnitSpinBox(QSpinBox):
    """Base of spin boxes whose input `parse` converts.

    A number without a unit is in the displayed unit. A change of units first accepts the typed
    text. Input that was reported as invalid is marked by an icon.
    """

    rejected = Signal(str)  # reason why the input is invalid, for the user

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        never_mirror(self)
        self.own_first = units().own_first  # as displayed; a change of units updates both
        self.setKeyboardTracking(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccelerated(True)
        self._problem = QAction(tr("Not a value"), self)
        set_icon(self._problem, "warning", "danger")
        self.lineEdit().addAction(self._problem, QLineEdit.ActionPosition.LeadingPosition)
        self._problem.setVisible(False)  # not earlier: Qt shows an action that is added hidden
        self.lineEdit().setTextMargins(4, 0, 0, 0)
        self._typed = ""
        self.lineEdit().textChanged.connect(self._on_text_changed)
        self.lineEdit().textEdited.connect(partial(setattr, self, "_typed"))
        units().changed.connect(self._on_units_changed)

    @property
    def problem(self) -> str:
        """Reason why the input is marked, else empty."""
        return self._problem.toolTip() if self._problem.isVisible() else ""

    def _mark(self, problem: str) -> None:
        self._problem.setToolTip(plain(problem))
        self._problem.setVisible(bool(problem))

    @Slot()
    def _on_text_changed(self) -> None:
        if self.problem and self.hasAcceptableInput():
            self._mark("")

    @property
    def rounding(self) -> str:
        """Sentence with the stored value if it differs from the typed value, else empty."""
        stored = self.textFromValue(self.value())
        number, unit, *_ = f"{stored} ".split(" ")
        with suppress(BadRequest):
            wanted, taken = quantity(self._typed, unit), quantity(number, unit)
            is_taken = self.parse(self._typed) == self.value()
            if is_taken and wanted and taken and not math.isclose(wanted, taken):
                return tr("The nearest that the board can store is {0}.").format(stored)
        return ""

    @Slot()
    def _on_units_changed(self) -> None:
        is_typed = self.lineEdit().isModified()
        if is_typed:
            self.interpretText()
        self.own_first = units().own_first
        self.setSuffix("")  # updates the text and the size
        self.lineEdit().setModified(is_typed)  # so that a delegate commits the value
        self._mark("")

    def parse(self, text: str) -> int:
        """Return the value of the input.

        Raises:
            BadRequest: the input is not a value, or outside the limits.
        """
        raise NotImplementedError

    def valueFromText(self, text: str) -> int:
        try:
            return self.parse(text)
        except BadRequest:
            return self.value()

    def validate(self, text: str, pos: int) -> tuple[QValidator.State, str, int]:
        try:
            self.parse(text)
        except BadRequest:
            return QValidator.State.Intermediate, text, pos
        return QValidator.State.Acceptable, text, pos

    def fixup(self, text: str) -> str:
        """Report why the input is dropped when the editor is left."""
        self.report_problem()
        return super().fixup(text)

    def report_problem(self) -> None:
        """Emit `rejected` if the input is not a value."""
        try:
            self.parse(self.text())
        except BadRequest as error:
            problem = error_sentence(error)
            self._mark(problem)
            self.rejected.emit(problem)


class UnitDelegate(QStyledItemDelegate):
    """Keeps the spin box of a cell open while its input is not a value."""

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if (
            isinstance(watched, UnitSpinBox)
            and isinstance(event, QKeyEvent)
            and event.type() == QEvent.Type.KeyPress
            and event.key() in {Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Tab}
            and not watched.hasAcceptableInput()
        ):
            watched.report_problem()
            return True
        return super().eventFilter(watched, event)


class CountEditor(UnitSpinBox):
    """Editor of a raw count, in µs, V or counts. Accepts `2.1 ms`, `1500 µs` or `3750 counts`."""

    def __init__(self, source: InputSource, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._source = source
        self.stepping = False  # True while a key, the wheel or a button changes the value
        self.setRange(0, HIGHEST_CODED)
        self.setToolTip(plain(self._expected()))

    def set_source(self, source: InputSource) -> None:
        """Change to the units of another input source. The count is unchanged."""
        if source is not self._source:
            self._source = source
            self.setToolTip(plain(self._expected()))
            with QSignalBlocker(self):
                self.lineEdit().setText(self.textFromValue(self.value()))

    def stepBy(self, steps: int) -> None:
        self.stepping = True
        super().stepBy(steps)
        self.stepping = False

    wheelEvent = focused_wheel(QSpinBox.wheelEvent)

    @property
    def other_text(self) -> str:
        """The value in the unit that is not shown, such as `3750 counts`."""
        counts = tr("%n count(s)", "", self.value())
        return self._physical(self.value()) if self.own_first else counts

    def textFromValue(self, val: int) -> str:
        return str(val) if self.own_first else self._physical(val)

    def _physical(self, val: int) -> str:
        decimals = 1 if self._source is InputSource.RC else 3
        number = f"{self._source.physical(val):.{decimals}f}".removesuffix(".0")
        return f"{with_decimal_point(number)} {self._source.unit}"

    def parse(self, text: str) -> int:
        is_physical = not self.own_first and BARE.fullmatch(text)
        try:
            count, source = read_count(f"{text} {self._source.unit}" if is_physical else text)
        except AmbiguousNumber:
            raise
        except BadRequest:
            count, source = -1, None
        if source not in {None, self._source} or not 0 <= count <= HIGHEST_CODED:
            message = tr("{0} is not a valid value. {1}")
            raise BadRequest(message.format(text.strip() or "“”", self._expected()))
        return count

    def _expected(self) -> str:
        example = tr("Enter 0 to {0}, such as 2.5 V, 2500 mV or 512 counts.")
        if self._source is InputSource.RC:
            example = tr("Enter 0 to {0}, such as 1500 µs, 1.5 ms or 3750 counts.")
        return example.format(self._source.text(HIGHEST_CODED))
