"""What Fusion draws in one size and one colour, in the size and the colours of the theme."""

from typing import cast

from PySide6.QtCore import QRect
from PySide6.QtGui import QPainter, QPen
from PySide6.QtWidgets import (
    QApplication,
    QProxyStyle,
    QStyle,
    QStyleOption,
    QStyleOptionMenuItem,
    QWidget,
)

from trex_gui.ui.theme.theme import theme

_GROWING = {
    QStyle.PixelMetric.PM_IndicatorWidth,
    QStyle.PixelMetric.PM_IndicatorHeight,
    QStyle.PixelMetric.PM_ExclusiveIndicatorWidth,
    QStyle.PixelMetric.PM_ExclusiveIndicatorHeight,
}
_ACCENT = 4  # pixels above and below a text, which is in the middle
_FRAMES = {QStyle.PrimitiveElement.PE_Frame, QStyle.PrimitiveElement.PE_FrameGroupBox}


class _ThemeStyle(QProxyStyle):
    def pixelMetric(
        self,
        metric: QStyle.PixelMetric,
        option: QStyleOption | None = None,
        widget: QWidget | None = None,
    ) -> int:
        size = super().pixelMetric(metric, option, widget)
        return size * theme().font_size // 100 if metric in _GROWING else size

    def subElementRect(  # noqa: N802 # of Qt
        self, element: QStyle.SubElement, option: QStyleOption, widget: QWidget | None = None
    ) -> QRect:
        rect = super().subElementRect(element, option, cast("QWidget", widget))  # may be none
        # Fusion gives the text of a tab less than a line: É loses its accent
        if element == QStyle.SubElement.SE_TabBarTabText:
            rect.adjust(0, -_ACCENT, 0, _ACCENT)
        return rect

    def drawPrimitive(
        self,
        element: QStyle.PrimitiveElement,
        option: QStyleOption,
        painter: QPainter,
        widget: QWidget | None = None,
    ) -> None:
        if element not in _FRAMES:
            super().drawPrimitive(element, option, painter, widget)
            return
        painter.save()
        painter.setPen(QPen(theme().color("plot_frame"), 1))
        painter.drawRect(option.rect.adjusted(0, 0, -1, -1))
        painter.restore()

    def drawControl(
        self,
        element: QStyle.ControlElement,
        option: QStyleOption,
        painter: QPainter,
        widget: QWidget | None = None,
    ) -> None:
        is_separator = (
            isinstance(option, QStyleOptionMenuItem)
            and option.menuItemType == QStyleOptionMenuItem.MenuItemType.Separator
            and not option.text
        )
        if is_separator:
            rect = option.rect
            painter.setPen(QPen(theme().color("plot_frame"), 1))
            middle = rect.center().y()
            painter.drawLine(rect.left() + 5, middle, rect.right() - 5, middle)
        else:
            super().drawControl(element, option, painter, widget)


def theme_style() -> QStyle:
    """The one style of the application; it is made at the first call."""
    app = QApplication.instance()
    style = app.findChild(_ThemeStyle) if app is not None else None
    if style is None:
        style = _ThemeStyle("Fusion")
        style.setParent(app)
    return style


def use_theme_style(widget: QWidget) -> None:
    """Let check and radio buttons grow with the font; show frames, accents and lines of menus.

    Not for the whole application: each metric and each shape is asked of Python.
    """
    widget.setStyle(theme_style())
