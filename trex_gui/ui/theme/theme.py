"""Colour schemes of the application: light, dark and high contrast.

Each scheme is a file `resources/themes/*.toml` with palette roles and named colours.
"""

import tomllib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from string import Template
from typing import Literal

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, Signal, Slot
from PySide6.QtGui import QColor, QFont, QFontDatabase, QFontMetrics, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication, QLabel, QToolTip, QWidget

from trex_gui.core.resource_files import resource
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.focus_frame import FocusFrame

Scheme = Literal["system", "light", "dark", "high_contrast"]
SCHEMES: tuple[Scheme, ...] = ("system", "light", "dark", "high_contrast")

FONT_SIZES = (90, 100, 110, 125, 150, 175)  # percent of the system's font size

_SCHEME, _FONT_SIZE = "window/scheme", "window/font_size"

_SIZES = {"title": 1.6, "heading": 1.15, "caption": 0.9}  # relative to the application's font
_INDICATOR = 16  # size of check boxes and radio buttons in pixels, at a font size of 100 %
CARD_PADDING = 16  # pixels inside a card
_BELOW_TITLE = 8  # pixels below the title of a card

_SHAPES = ("up", "down", "check", "dot")
_COLOR_TABLES = ("text", "graphics", "fill", "surface")


@dataclass(frozen=True, slots=True)
class Colors:
    palette: dict[str, QColor]
    disabled: dict[str, QColor]
    named: dict[str, QColor]

    def style_sheet(self, scheme: str, font: QFont, percent: int) -> str:
        """Return `resources/themes/style.qss` with these colours and the font's sizes."""
        size, unit = font.pointSizeF(), "pt"
        if size <= 0:
            size, unit = font.pixelSize(), "px"
        indicator = _INDICATOR * percent // 100
        values = {name: color.name() for name, color in {**self.palette, **self.named}.items()}
        values |= {f"disabled_{name}": color.name() for name, color in self.disabled.items()}
        values |= {name: f"{size * factor:.1f}{unit}" for name, factor in _SIZES.items()}
        title = QFontMetrics(scaled_font(font, _SIZES["heading"])).height() + _BELOW_TITLE
        values |= {"padding": f"{CARD_PADDING}px", "below_title": f"{CARD_PADDING + title}px"}
        values |= {"indicator": f"{indicator}px", "half_indicator": f"{indicator // 2 + 1}px"}
        values |= {name: resource(f"themes/{scheme}/{name}.svg").as_posix() for name in _SHAPES}
        return Template(_template()).substitute(values)

    def qpalette(self) -> QPalette:
        palette = QPalette()
        for role, color in self.palette.items():
            palette.setColor(_role(role), color)
        for role, color in self.disabled.items():
            palette.setColor(QPalette.ColorGroup.Disabled, _role(role), color)
        return palette


@cache
def _template() -> str:
    return resource("themes/style.qss").read_text(encoding="utf-8")


def _role(name: str) -> QPalette.ColorRole:
    return QPalette.ColorRole[name.title().replace("_", "")]


@cache
def read_colors(scheme: str) -> Colors:
    """Read `resources/themes/<scheme>.toml`.

    Raises:
        ValueError: a colour is invalid.
    """
    tables = tomllib.loads(resource(f"themes/{scheme}.toml").read_text(encoding="utf-8"))

    def colors(table: str) -> dict[str, QColor]:
        parsed = {name: QColor.fromString(text) for name, text in tables[table].items()}
        for name, color in parsed.items():
            if not color.isValid():
                raise ValueError(f"{scheme}.toml, {table}.{name}: not a colour")
        return parsed

    named = {name: color for table in _COLOR_TABLES for name, color in colors(table).items()}
    return Colors(colors("palette"), colors("disabled"), named)


class Theme(QObject):
    """Scheme and font size in use. `theme()` returns the only instance."""

    changed = Signal()  # the colours or the font size have changed

    def __init__(self) -> None:
        super().__init__()
        self.choice: Scheme = "system"
        self.font_size = 100  # percent of the system's font size
        self._system_was_dark = False
        self._system_font = QFont()
        self.scheme = "light"
        self._colors = read_colors("light")
        self._app: QApplication | None = None
        self._focus_frame: FocusFrame | None = None

    def color(self, name: str) -> QColor:
        """Return a copy of a named colour or palette role."""
        color = self._colors.named.get(name) or self._colors.palette.get(name)
        if color is None:
            raise KeyError(f"the theme has no colour {name!r}")
        return QColor(color)

    @contextmanager
    def painted_as(self, scheme: str) -> Iterator[None]:
        """Use another scheme inside the block, without repainting widgets."""
        previous, self._colors = self._colors, read_colors(scheme)
        try:
            yield
        finally:
            self._colors = previous

    def install(self, app: QApplication) -> None:
        """Set the Fusion style and the palette. Follow the system's scheme and contrast."""
        if self._app is None:  # the application still has the system's palette and font
            self._system_was_dark = app.palette().window().color().lightnessF() < 0.5
            self._system_font = app.font()
        if self._app is not app:
            app.setStyle("Fusion")
        self._app = app
        hints, once = app.styleHints(), Qt.ConnectionType.UniqueConnection
        hints.colorSchemeChanged.connect(self._show, once)
        hints.accessibility().contrastPreferenceChanged.connect(self._show, once)
        self._focus_frame = self._focus_frame or FocusFrame(app)
        self._show()

    def set_scheme(self, choice: Scheme) -> None:
        self.choice = choice
        if self._app is not None:
            # On some platforms, this also affects title bars and native dialogs.
            qt_schemes = {"system": Qt.ColorScheme.Unknown, "light": Qt.ColorScheme.Light}
            self._app.styleHints().setColorScheme(qt_schemes.get(choice, Qt.ColorScheme.Dark))
        self._show()

    def set_font_size(self, percent: int) -> None:
        if percent != self.font_size and self._app is not None:
            self.font_size = percent
            self._app.setFont(scaled_font(self._system_font, percent / 100))
            QCoreApplication.sendPostedEvents(None, QEvent.Type.ApplicationFontChange)
            self._show()
            self.changed.emit()

    def _resolve(self) -> str:
        if self.choice != "system":
            return self.choice
        if not isinstance(QGuiApplication.instance(), QGuiApplication):
            return "light"
        hints = QGuiApplication.styleHints()
        if hints.accessibility().contrastPreference() is Qt.ContrastPreference.HighContrast:
            return "high_contrast"
        is_dark = hints.colorScheme() is Qt.ColorScheme.Dark
        if hints.colorScheme() is Qt.ColorScheme.Unknown:
            is_dark = self._system_was_dark
        return "dark" if is_dark else "light"

    @Slot()
    def _show(self) -> None:
        scheme = self._resolve()
        has_changed = scheme != self.scheme
        self.scheme = scheme
        self._colors = read_colors(scheme)
        if self._app is not None:
            palette = self._colors.qpalette()
            # The platform may have replaced the palette.
            if has_changed or self._app.palette() != palette:
                self._app.setPalette(palette)
                QToolTip.setPalette(palette)
            sheet = self._colors.style_sheet(scheme, self._app.font(), self.font_size)
            if self._app.styleSheet() != sheet:
                # Replacing the sheet directly takes 0.6 s: Qt styles a widget once per ancestor.
                self._app.setStyleSheet("")
                self._app.setStyleSheet(sheet)
        if has_changed:
            self.changed.emit()


@cache
def theme() -> Theme:
    """Return the only theme of the application. The scheme is light before `install`."""
    return Theme()


def select_scheme(scheme: Scheme) -> None:
    """Set the scheme, and save it for the next start."""
    theme().set_scheme(scheme)
    Preferences().set(_SCHEME, scheme)


def select_font_size(percent: int) -> None:
    """Set the font size, and save it for the next start."""
    theme().set_font_size(percent)
    Preferences().set(_FONT_SIZE, percent)


def restore_choices() -> None:
    store = Preferences()
    saved = store.text(_SCHEME, "system")
    for scheme in SCHEMES:
        if scheme == saved and scheme != theme().choice:
            theme().set_scheme(scheme)
    theme().set_font_size(store.integer(_FONT_SIZE, 100, FONT_SIZES[0], FONT_SIZES[-1]))


class _Follower(QObject):
    apply: Callable[[], object]

    def __init__(self, target: QObject, key: str) -> None:
        super().__init__(target)
        self.setObjectName(key)
        theme().changed.connect(self._on_theme_changed)

    @Slot()
    def _on_theme_changed(self) -> None:
        self.apply()


def follow_theme(target: QObject, key: str, apply: Callable[[], object]) -> None:
    """Call `apply` now and after each change of the theme.

    A later call with the same `key` replaces `apply`.
    """
    options = Qt.FindChildOption.FindDirectChildrenOnly
    follower = target.findChild(_Follower, key, options) or _Follower(target, key)
    follower.apply = apply
    apply()


def scaled_font(font: QFont, factor: float) -> QFont:
    scaled = QFont(font)
    if font.pointSizeF() > 0:
        scaled.setPointSizeF(font.pointSizeF() * factor)
    else:
        scaled.setPixelSize(round(font.pixelSize() * factor))
    return scaled


def fixed_font() -> QFont:
    font = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
    return scaled_font(font, theme().font_size / 100)


def set_text_color(label: QLabel, name: str) -> None:
    """Set the colour of a label to a colour in `style.qss`. Any other name resets the colour."""
    set_style_property(label, "textColor", name)


def set_look(widget: QWidget, look: str) -> None:
    """Set the look of a widget to a look in `style.qss`. Any other name resets the look."""
    set_style_property(widget, "look", look)


def set_style_property(widget: QWidget, name: str, value: object) -> None:
    """Set a property that `style.qss` uses. Restyle the widget and its child widgets."""
    if widget.property(name) == value:
        return
    widget.setProperty(name, value)
    if widget.testAttribute(Qt.WidgetAttribute.WA_WState_Polished):
        for restyled in (widget, *widget.findChildren(QWidget)):
            restyled.style().unpolish(restyled)
            restyled.style().polish(restyled)
        QCoreApplication.sendEvent(widget, QEvent(QEvent.Type.StyleChange))  # updates the padding
