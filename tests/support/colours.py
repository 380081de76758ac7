"""Contrast of texts with the colours behind them."""

import re
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QAbstractListModel, QPoint, QRect, Qt
from PySide6.QtGui import QBrush, QColor, QFontInfo, QImage, QPalette
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QComboBox,
    QGroupBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPlainTextEdit,
    QPushButton,
    QToolButton,
    QWidget,
)


def luminance(color: QColor) -> float:
    """Relative luminance. Ref: WCAG 2.2."""
    red, green, blue = (
        part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4
        for part in (color.redF(), color.greenF(), color.blueF())
    )
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(first: QColor, second: QColor) -> float:
    """Return the contrast ratio, from 1 to 21. Ref: WCAG 2.2."""
    dark, light = sorted((luminance(first), luminance(second)))
    return (light + 0.05) / (dark + 0.05)


def min_contrast(font: QFontInfo) -> float:
    """Return the smallest allowed contrast of text in a font. Ref: WCAG 2.2, 1.4.3."""
    points = font.pointSizeF()
    return 3.0 if points >= 18 or (points >= 14 and font.bold()) else 4.5


def weak_texts(window: QWidget) -> dict[str, float]:
    """Return the contrast of each text that has too little. Checks disabled texts too."""
    pixels, weak = _pixels(window.grab().toImage()), {}
    for widget in window.findChildren(QWidget):
        if not widget.isVisibleTo(window) or widget.window() is not window:
            continue
        place = QRect(widget.mapTo(window, QPoint()), widget.size()).intersected(window.rect())
        if place.isEmpty():
            continue
        for name, color, backgrounds in _texts(widget):
            has_frame = isinstance(widget, _FRAMED)
            area = pixels[place.top() : place.bottom() + 1, place.left() : place.right() + 1]
            known = backgrounds or [_background(area, has_frame=has_frame)]
            lowest = min(contrast(color, background) for background in known)
            if lowest < min_contrast(widget.fontInfo()):
                weak[f"{widget.objectName() or type(widget).__name__} {name}"] = round(lowest, 2)
    return weak


def _pixels(picture: QImage) -> NDArray[np.uint32]:
    """Return the colours of a picture by row and column."""
    picture = picture.convertToFormat(QImage.Format.Format_RGB32)
    pixels = np.frombuffer(picture.constBits(), np.uint32)
    return pixels.reshape(picture.height(), picture.width()).copy()


def _background(pixels: NDArray[np.uint32], *, has_frame: bool) -> QColor:
    """Return the most frequent colour. In a frame, only pixels near its lower edge count."""
    height, width = pixels.shape
    if has_frame:
        sample = pixels[max(height - 5, 0), width // 4 : max(width - width // 4, 1)]
    else:
        sample = pixels[:: max(1, height // 12), :: max(1, width // 24)]
    colors, counts = np.unique(sample, return_counts=True)
    return QColor(int(colors[counts.argmax()]))


_FRAMED = QPushButton, QToolButton, QComboBox, QAbstractSpinBox, QLineEdit, QPlainTextEdit
_WITH_TEXT = QLabel, QAbstractButton, QComboBox, QAbstractSpinBox, QLineEdit, QGroupBox
_INLINE = re.compile(r"color:\s*(#[0-9a-fA-F]{6})")


def _texts(widget: QWidget) -> Iterator[tuple[str, QColor, list[QColor]]]:
    """Yield the name and colour of each text, and its background colours if known."""
    palette = widget.palette()
    match widget:
        case QAbstractItemView() if not isinstance(widget, QHeaderView):
            yield from _cells(widget)
        case QPlainTextEdit():
            yield "text", palette.color(QPalette.ColorRole.Text), []
        case QLabel() | QAbstractButton() if not widget.text():
            return
        case QLineEdit() if isinstance(widget.parentWidget(), QAbstractSpinBox | QComboBox):
            return
        case widget if isinstance(widget, _WITH_TEXT):
            yield "text", palette.color(widget.foregroundRole()), []
    if isinstance(widget, QLabel):
        for color in _INLINE.findall(widget.text()):
            yield color, QColor(color), []
        if "<a " in widget.text():
            yield "link", palette.color(QPalette.ColorRole.Link), []
    if isinstance(widget, QLineEdit) and widget.placeholderText():
        yield "placeholder", palette.color(QPalette.ColorRole.PlaceholderText), []


def _base(widget: QWidget) -> QColor:
    """Return the background colour of a view. A transparent view shows its parent's."""
    brush, parent = widget.palette().brush(QPalette.ColorRole.Base), widget.parentWidget()
    is_transparent = brush.style() is Qt.BrushStyle.NoBrush
    return _base(parent) if is_transparent and parent is not None else brush.color()


def _cells(view: QAbstractItemView) -> Iterator[tuple[str, QColor, list[QColor]]]:
    """Yield the cells, and once the colours that all selected rows share."""
    model, palette, role = view.model(), view.palette(), QPalette.ColorRole
    selected = palette.color(role.Highlight)
    yield "selection", palette.color(role.HighlightedText), [selected]
    rows = [_base(view)]
    if view.alternatingRowColors():
        rows.append(palette.color(role.AlternateBase))
    columns = 1 if isinstance(model, QAbstractListModel) else model.columnCount()
    for row in range(min(model.rowCount(), 40)):
        for column in range(columns):
            index = model.index(row, column)
            foreground, background = (
                index.data(kind)
                for kind in (Qt.ItemDataRole.ForegroundRole, Qt.ItemDataRole.BackgroundRole)
            )
            is_plain = foreground is None
            color = palette.color(role.Text) if is_plain else QBrush(foreground).color()
            colors = rows if background is None else [QBrush(background).color()]
            yield f"{row}, {column}", color, colors
