"""Spin boxes for numbers with units."""

import math
import re
from contextlib import suppress
from functools import partial

from PySide6.QtCore import QSignalBlocker, Qt, Signal, Slot
from PySide6.QtGui import QAction, QValidator
from PySide6.QtWidgets import QLineEdit, QSpinBox, QWidget

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
    """Base class of spin boxes that convert their input with `parse`.

    A number without a unit is in the displayed unit. If the units change while the user is typing,
    the typed text is accepted first. An icon marks rejected input.
    """

    rejected = Signal(str)  # reason, for the user

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        never_mirror(self)
        self.own_first = units().own_first  # True if the text shows the board's own units
        self.setKeyboardTracking(False)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAccelerated(True)
        self._problem = QAction(tr("Not a value"), self)
        set_icon(self._problem, "warning", "danger")
        self.lineEdit().addAction(self._problem, QLineEdit.ActionPosition.LeadingPosition)
        self._problem.setVisible(False)  # set after `addAction`, which shows hidden actions
        self.lineEdit().setTextMargins(4, 0, 0, 0)
        self._typed = ""
        self.lineEdit().textChanged.connect(self._on_text_changed)
        self.lineEdit().textEdited.connect(partial(setattr, self, "_typed"))
        units().changed.connect(self._on_units_changed)

    @property
    def problem(self) -> str:
        """Reason for the warning icon, or an empty text."""
        return self._problem.toolTip() if self._problem.isVisible() else ""

    def _mark(self, problem: str) -> None:
        self._problem.setToolTip(plain(problem))
        self._problem.setVisible(bool(problem))
        self.lineEdit().update()  # the icon moves the text, but Qt repaints only parts of it

    @Slot()
    def _on_text_changed(self) -> None:
        if self.problem and self.hasAcceptableInput():
            self._mark("")

    @property
    def rounding(self) -> str:
        """Message about the stored value if the input was rounded, or an empty text."""
        stored = self.textFromValue(self.value())
        number, unit, *_ = f"{stored} ".split(" ")
        with suppress(BadRequest):
            typed, rounded = quantity(self._typed, unit), quantity(number, unit)
            is_current = self.parse(self._typed) == self.value()
            if is_current and typed and rounded and not math.isclose(typed, rounded):
                return tr("The nearest value that the board can store is {0}.").format(stored)
        return ""

    @Slot()
    def _on_units_changed(self) -> None:
        is_typed = self.lineEdit().isModified()
        if is_typed:
            self.interpretText()
        self.own_first = units().own_first
        self.setSuffix("")  # updates the text and the size
        self.lineEdit().setModified(is_typed)  # otherwise a delegate would not commit the value
        self._mark("")

    def parse(self, text: str) -> int:
        """Return the value of the input.

        Raises:
            BadRequest: the input is invalid or out of range.
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
        """Report invalid input before Qt replaces it."""
        self.report_problem()
        return super().fixup(text)

    def report_problem(self) -> None:
        """Mark invalid input and emit `rejected`."""
        try:
            self.parse(self.text())
        except BadRequest as error:
            problem = error_sentence(error)
            self._mark(problem)
            self.rejected.emit(problem)


class CountEditor(UnitSpinBox):
    """Editor for a raw count, entered as `2.1 ms`, `1500 µs`, `2.5 V` or `3750 counts`."""

    def __init__(self, source: InputSource, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._source = source
        self.is_stepping = False  # True while a key, the wheel or a button changes the value
        self.setRange(0, HIGHEST_CODED)
        self.setToolTip(plain(self._expected()))

    def set_source(self, source: InputSource) -> None:
        """Set the input source and its units. The count does not change."""
        if source is not self._source:
            self._source = source
            self.setToolTip(plain(self._expected()))
            with QSignalBlocker(self):
                self.lineEdit().setText(self.textFromValue(self.value()))

    def stepBy(self, steps: int) -> None:
        self.is_stepping = True
        super().stepBy(steps)
        self.is_stepping = False

    wheelEvent = focused_wheel(QSpinBox.wheelEvent)

    @property
    def other_text(self) -> str:
        """Value in the other unit, such as `3750 counts`."""
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
