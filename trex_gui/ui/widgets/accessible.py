"""Roles and states of painted widgets for screen readers."""

from typing import Any, NamedTuple

from PySide6.QtCore import QObject
from PySide6.QtGui import QAccessible, QAccessibleInterface, QAccessibleValueInterface
from PySide6.QtWidgets import QAbstractButton, QAccessibleWidget, QWidget
from shiboken6.Shiboken import VoidPtr, getCppPointer


class SpokenRange(NamedTuple):
    """Value and limits in the displayed unit."""

    lowest: float
    value: float
    highest: float


class Spoken:
    """Mixin whose texts are computed when a screen reader requests them.

    Qt's own properties would send an event for every sample. The description consists of the
    state and of the `accessibleDescription` or the tool tip.
    """

    spoken_role = QAccessible.Role.Graphic

    def spoken_name(self) -> str:
        """Return the current name. If it is empty, `accessibleName` is used."""
        return ""

    def spoken_state(self) -> str:
        return ""

    def spoken_range(self) -> SpokenRange | None:
        """Return the displayed value and its limits, or `None` if the widget shows no number."""
        return None

    def set_spoken_value(self, value: float) -> None:
        """Handle a value set by a screen reader. Does nothing by default."""


class _Interface(QAccessibleWidget):
    def state(self) -> QAccessible.State:
        state, widget = super().state(), self.widget()
        if isinstance(widget, QAbstractButton):
            state.checkable, state.checked = widget.isCheckable(), widget.isChecked()
        return state

    def text(self, kind: QAccessible.Text, /) -> str:
        default, widget = super().text(kind), self.widget()
        if not isinstance(widget, Spoken):
            return default
        if kind is QAccessible.Text.Name:
            return widget.spoken_name() or default
        if kind is QAccessible.Text.Value:
            spoken_range = widget.spoken_range()
            return f"{spoken_range.value:g}" if spoken_range else widget.spoken_state()
        if kind is QAccessible.Text.Description:
            if default == widget.accessibleName():  # a tool tip may repeat the name
                default = ""
            return "\n".join(filter(None, (widget.spoken_state(), default)))
        return default


class _RangeInterface(_Interface, QAccessibleValueInterface):
    def __init__(self, widget: QWidget, role: QAccessible.Role) -> None:
        _Interface.__init__(self, widget, role)
        QAccessibleValueInterface.__init__(self)

    def interface_cast(self, kind: QAccessible.InterfaceType, /) -> Any:
        """Return a pointer. Qt crashes on `None` and on the type that the stub declares."""
        if kind is QAccessible.InterfaceType.ValueInterface:
            return VoidPtr(getCppPointer(self)[-1])
        return super().interface_cast(kind) or VoidPtr(0)

    def _range(self) -> SpokenRange:
        widget = self.widget()
        spoken_range = widget.spoken_range() if isinstance(widget, Spoken) else None
        return spoken_range or SpokenRange(0, 0, 0)

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
