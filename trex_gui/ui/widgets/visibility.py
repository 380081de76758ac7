"""Pages that nobody sees need not be kept up to date sixty times a second."""

from collections.abc import Callable
from functools import wraps
from typing import TypeVar

from PySide6.QtWidgets import QWidget

WidgetT = TypeVar("WidgetT", bound=QWidget)


def only_when_visible(slot: Callable[[WidgetT], None]) -> Callable[[WidgetT], None]:
    """Let a slot do its work only while its widget can be seen.

    The widget calls the slot again from its `showEvent`.
    """

    @wraps(slot)
    def guarded(widget: WidgetT) -> None:
        if widget.isVisible():
            slot(widget)

    return guarded
