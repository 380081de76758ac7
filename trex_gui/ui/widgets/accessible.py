"""Roles and states of painted widgets for screen readers."""

from typing import Any, NamedTuple

from PySide6.QtCore import QObject
from PySide6.QtGui import QAccessible, QAccessibleInterface, QAccessibleValueInterface
from PySide6.QtWidgets import QAbstractButton, QAccessibleWidget, QWidget
from shiboken6.Shiboken import VoidPtr, getCppPointer


class SpokenRange(NamedTuple):
    """A value between two ends, in the unit that the user sees."""

    lowest: float
    value: float
    highest: float


class Spoken:
    """Mixin for a widget whose state is read when a screen reader requests it.

    Qt's own properties send an event with each change, here with each sample. The state is the
    description, followed by the `accessibleDescription` or the tool tip.
    """

    spoken_role = QAccessible.Role.Graphic

    def spoken_name(self) -> str:
        """Return a changing name. If it is empty, `accessibleName` is the name."""
        return ""

    def spoken_state(self) -> str:
        """Return what the widget shows now."""
        return ""

    def spoken_range(self) -> SpokenRange | None:
        """Return the value of a widget that shows more than text."""
        return None

    def set_spoken_value(self, value: float) -> None:
        """Set a value from a screen reader. A widget without input ignores it."""


class _Interface(QAccessibleWidget):
    """Belongs to its widget, but holds no reference to it."""

    def state(self) -> QAccessible.State:
        state, widget = super().state(), self.widget()
        if isinstance(widget, QAbstractButton):
            state.checkable, state.checked = widget.isCheckable(), widget.isChecked()
        return state

    def text(self, kind: QAccessible.Text, /) -> str:
        said, widget = super().text(kind), self.widget()
        if not isinstance(widget, Spoken):
            return said
        if kind is QAccessible.Text.Name:
            return widget.spoken_name() or said
        if kind is QAccessible.Text.Value:
            shown = widget.spoken_range()
            return f"{shown.value:g}" if shown else widget.spoken_state()
        if kind is QAccessible.Text.Description:
            said = "" if said == widget.accessibleName() else said  # a tool tip may repeat it
            return "\n".join(part for part in (widget.spoken_state(), said) if part)
        return said


class _RangeInterface(_Interface, QAccessibleValueInterface):
    def __init__(self, widget: QWidget, role: QAccessible.Role) -> None:
        _Interface.__init__(self, widget, role)
        QAccessibleValueInterface.__init__(self)

    def interface_cast(self, kind: QAccessible.InterfaceType, /) -> Any:
        """Return a pointer. The type in the stubs, and `None` for a null pointer, crash Qt."""
        if kind is QAccessible.InterfaceType.ValueInterface:
            return VoidPtr(getCppPointer(self)[-1])
        return super().interface_cast(kind) or VoidPtr(0)

    def _range(self) -> SpokenRange:
        widget = self.widget()
        shown = widget.spoken_range() if isinstance(widget, Spoken) else None
        return shown or SpokenRange(0, 0, 0)

    def currentValue(self) -> float:
        return self._range().value

    def minimumValue(self) -> float:
        return self._range().lowest

    def maximumValue(self) -> float:
        return self._range().highest

    def minimumStepSize(self) -> float:
        return 0.0

    def setCurrentValue(self, value: object, /) -> None:
        widget = self.widget()
        if isinstance(widget, Spoken) and isinstance(value, int | float):
            widget.set_spoken_value(value)


def _create_interface(_class_name: str, widget: QObject) -> QAccessibleInterface | None:
    if not (isinstance(widget, QWidget) and isinstance(widget, Spoken)):
        return None
    has_range = type(widget).spoken_range is not Spoken.spoken_range
    return (_RangeInterface if has_range else _Interface)(widget, widget.spoken_role)


QAccessible.installFactory(_create_interface)
