"""Behaviour that widgets share: focus frame, header names, no work while hidden."""

from collections.abc import Callable
from functools import wraps
from typing import TypeVar

from PySide6.QtCore import QCoreApplication, Qt
from PySide6.QtGui import QFocusEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QWidget

from trex_gui.ui.theme.theme import theme


class FocusFramed(QWidget):
    """Draws a frame while it has the focus; layouts leave a pixel of margin for it."""

    def paintEvent(self, event: QPaintEvent) -> None:
        super().paintEvent(event)
        if self.hasFocus():
            with QPainter(self) as painter:
                painter.setPen(theme().color("highlight"))
                painter.drawRect(self.rect().adjusted(0, 0, -1, -1))

    def focusInEvent(self, event: QFocusEvent) -> None:
        super().focusInEvent(event)
        self.update()

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.update()


def paint_placeholder(view: QAbstractItemView, text: str, *, short: str = "") -> None:
    """Paint a text into an empty view; `short` instead where there is no room for all of it."""
    box = view.viewport().rect().adjusted(8, 4, -8, -4)
    how = Qt.AlignmentFlag.AlignCenter | Qt.TextFlag.TextWordWrap
    with QPainter(view.viewport()) as painter:
        painter.setPen(theme().color("muted"))
        if short and not box.contains(painter.boundingRect(box, how, text)):
            text = short if text else ""
        painter.drawText(box, how, text)


def name_headers(view: QAbstractItemView) -> None:
    """Name the headers of a view for screen readers."""
    for header in view.findChildren(QHeaderView, options=Qt.FindChildOption.FindDirectChildrenOnly):
        across = header.orientation() is Qt.Orientation.Horizontal
        header.setAccessibleName(_tr("Columns") if across else _tr("Rows"))


def _tr(text: str) -> str:
    return QCoreApplication.translate("header_names", text)


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
