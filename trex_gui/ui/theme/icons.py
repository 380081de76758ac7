"""Icons in colours of the theme."""

from functools import cache

from PySide6.QtCore import QByteArray, QRectF, QSize, Qt
from PySide6.QtGui import QAction, QColor, QIcon, QPainter, QPixmap
from PySide6.QtSvg import QSvgRenderer
from PySide6.QtWidgets import QAbstractButton, QLabel

from trex_gui.core.resource_files import resource
from trex_gui.ui.theme.theme import follow_theme, theme

_SIZES = (16, 24, 32, 48, 64)  # pixels; Qt scales down the next larger size
# Left edge and size of each icon in the picture from `_shapes`.
_CELLS = tuple((sum(_SIZES[:index]), size) for index, size in enumerate(_SIZES))
_BUTTON_ICON = 16  # pixels at a font size of 100 %, as in Fusion


def icon(name: str, color: str = "icon") -> QIcon:
    """Return an icon in a colour of the current theme. The icon does not follow the theme."""
    colors = (theme().color(key).rgb() for key in (color, "muted", "highlighted_text"))
    return _render(name, *colors)


def set_icon(target: QAction | QAbstractButton, name: str, color: str = "icon") -> None:
    """Set an icon that follows the theme."""

    def apply() -> None:
        image = icon(name, color)
        if isinstance(target, QAction):  # a menu paints its highlighted row as active
            image = QIcon(image)
            for size in _SIZES:
                image.addPixmap(image.pixmap(size, size, QIcon.Mode.Selected), QIcon.Mode.Active)
        else:
            side = _BUTTON_ICON * theme().font_size // 100
            target.setIconSize(QSize(side, side))
        target.setIcon(image)

    follow_theme(target, "icon", apply)


def set_sign(label: QLabel, name: str, color: str, extra: int = 0) -> None:
    """Show an icon that follows the theme and is `extra` pixels taller than the text."""

    def apply() -> None:
        side = label.fontMetrics().height() + extra
        label.setPixmap(icon(name, color).pixmap(side, side))

    follow_theme(label, "sign", apply)


@cache
def _render(name: str, color: int, disabled: int, selected: int) -> QIcon:
    shapes = _shapes(name)
    image = QIcon()
    for mode, argb, opacity in (
        (QIcon.Mode.Normal, color, 1.0),
        (QIcon.Mode.Disabled, disabled, 0.55),
        (QIcon.Mode.Selected, selected, 1.0),
    ):
        tint, tinted = QColor(argb), QPixmap(shapes)
        tint.setAlphaF(opacity)
        with QPainter(tinted) as painter:
            painter.setCompositionMode(QPainter.CompositionMode.CompositionMode_SourceIn)
            painter.fillRect(tinted.rect(), tint)
        for left, size in _CELLS:
            image.addPixmap(tinted.copy(left, 0, size, size), mode)
    return image


@cache
def _shapes(name: str) -> QPixmap:
    """Draw an icon in black, with all sizes side by side."""
    drawing = resource(f"icons/{name}.svg").read_text(encoding="utf-8")
    renderer = QSvgRenderer(QByteArray(drawing.replace("currentColor", "black").encode()))
    shapes = QPixmap(sum(_SIZES), max(_SIZES))
    shapes.fill(Qt.GlobalColor.transparent)
    with QPainter(shapes) as painter:
        for left, size in _CELLS:
            renderer.render(painter, QRectF(left, 0, size, size))
    return shapes


@cache
def application_icon() -> QIcon:
    return QIcon(str(resource("icons/trex-studio.svg")))
