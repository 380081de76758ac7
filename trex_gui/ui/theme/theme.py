"""Light, dark and high contrast: palette roles and named colours, for the whole application.

The colours are data: `resources/themes/*.toml`, one file a scheme, the same names in each.
"""

import tomllib
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cache
from typing import Any, Literal

from PySide6.QtCore import QCoreApplication, QEvent, QObject, Qt, Signal, Slot
from PySide6.QtGui import QColor, QFont, QFontDatabase, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication, QPushButton, QToolButton, QToolTip, QWidget

from trex_gui.core.resource_files import resource
from trex_gui.ui.preferences import Preferences
from trex_gui.ui.theme.focus_frame import FocusFrame

Scheme = Literal["system", "light", "dark", "high_contrast"]
SCHEMES: tuple[Scheme, ...] = ("system", "light", "dark", "high_contrast")

FONT_SIZES = (90, 100, 110, 125, 150, 175)  # percent of the system's font size

_SCHEME, _FONT_SIZE = "window/scheme", "window/font_size"

_FUSION_OUTLINE = 140
"""Percent by which Fusion darkens the window's colour for the outline of a control."""

_OUTLINED = (
    "QAbstractButton",
    "QAbstractSlider",
    "QAbstractSpinBox",
    "QComboBox",
    "QLineEdit",
    "QListView",
    "QMenu",
    "QPlainTextEdit",
    "QProgressBar",
    "QTableView",
    "QTreeView",
)
"""Controls: an outline made of the window's colour cannot be seen on it."""

_COLOUR_TABLES = ("text", "graphics", "fill", "surface")


@dataclass(frozen=True, slots=True)
class Colours:
    """One scheme file, read."""

    palette: dict[str, QColor]
    disabled: dict[str, QColor]
    named: dict[str, QColor]

    def qpalette(self) -> QPalette:
        palette = QPalette()
        for role, color in self.palette.items():
            palette.setColor(_role(role), color)
        for role, color in self.disabled.items():
            palette.setColor(QPalette.ColorGroup.Disabled, _role(role), color)
        return palette


def _role(name: str) -> QPalette.ColorRole:
    return QPalette.ColorRole[name.title().replace("_", "")]


@cache
def read_colours(scheme: str) -> Colours:
    """Read `resources/themes/<scheme>.toml`; a bad colour is a `ValueError` naming it."""
    tables = tomllib.loads(resource(f"themes/{scheme}.toml").read_text(encoding="utf-8"))

    def colours(table: str) -> dict[str, QColor]:
        found = {name: QColor.fromString(text) for name, text in tables[table].items()}
        for name, color in found.items():
            if not color.isValid():
                raise ValueError(f"{scheme}.toml, {table}.{name}: not a colour")
        return found

    named = {name: color for table in _COLOUR_TABLES for name, color in colours(table).items()}
    return Colours(colours("palette"), colours("disabled"), named)


class Theme(QObject):
    """The scheme and the font size in use. There is one, and `theme()` returns it."""

    # Colours or font size are others now; the application's palette and font are set already.
    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.choice: Scheme = "system"
        self.font_size = 100  # percent of the system's
        self._system_was_dark = False
        self._system_font = QFont()
        self.scheme = "light"
        self._colours = read_colours("light")
        self._app: QApplication | None = None
        self._focus_frame: FocusFrame | None = None

    def color(self, name: str) -> QColor:
        """Return a named colour, or a palette role by its name in the file, as a copy."""
        found = self._colours.named.get(name) or self._colours.palette.get(name)
        if found is None:
            raise KeyError(f"the theme has no colour {name!r}")
        return QColor(found)

    @contextmanager
    def painted_as(self, scheme: str) -> Iterator[None]:
        """Return the colours of a scheme inside, for a picture; nothing is repainted."""
        before, self._colours = self._colours, read_colours(scheme)
        try:
            yield
        finally:
            self._colours = before

    def install(self, app: QApplication) -> None:
        """Give the application the Fusion style and our palette, and follow the system."""
        if self._app is None:  # afterwards the palette is ours
            self._system_was_dark = app.palette().window().color().lightnessF() < 0.5
            self._system_font = app.font()
        self._app = app
        app.setStyle("Fusion")
        hints, once = app.styleHints(), Qt.ConnectionType.UniqueConnection
        hints.colorSchemeChanged.connect(self._show, once)
        hints.accessibility().contrastPreferenceChanged.connect(self._show, once)
        self._focus_frame = self._focus_frame or FocusFrame(app)
        self._show()

    def set_scheme(self, choice: Scheme) -> None:
        """Choose a scheme; `system` follows the desktop, also when that changes later."""
        if choice not in SCHEMES:
            raise ValueError(f"no scheme {choice!r}; there are {', '.join(SCHEMES)}")
        self.choice = choice
        if self._app is not None:
            # Title bars and native dialogs follow where the platform lets them.
            self._app.styleHints().setColorScheme(
                {
                    "system": Qt.ColorScheme.Unknown,
                    "light": Qt.ColorScheme.Light,
                    "dark": Qt.ColorScheme.Dark,
                    "high_contrast": Qt.ColorScheme.Dark,
                }[choice]
            )
        self._show()

    def set_font_size(self, percent: int) -> None:
        """Scale the system's font for every window; widgets inherit it."""
        if percent != self.font_size and self._app is not None:
            self.font_size = percent
            self._app.setFont(scaled_font(self._system_font, percent / 100))
            QCoreApplication.sendPostedEvents(None, QEvent.Type.ApplicationFontChange)
            self.changed.emit()

    def _resolve(self) -> str:
        if self.choice != "system":
            return self.choice
        if not isinstance(QGuiApplication.instance(), QGuiApplication):
            return "light"
        hints = QGuiApplication.styleHints()
        if hints.accessibility().contrastPreference() is Qt.ContrastPreference.HighContrast:
            return "high_contrast"
        match hints.colorScheme():
            case Qt.ColorScheme.Dark:
                return "dark"
            case Qt.ColorScheme.Light:
                return "light"
            case _:  # the desktop does not report it: its palette does
                return "dark" if self._system_was_dark else "light"

    @Slot()
    def _show(self) -> None:
        scheme = self._resolve()
        changes = scheme != self.scheme
        self.scheme = scheme
        self._colours = read_colours(scheme)
        if self._app is not None:
            palette = self._colours.qpalette()
            # Set again even when unchanged: the platform may have set its own meanwhile.
            if changes or self._app.palette() != palette:
                self._app.setPalette(palette)
                QToolTip.setPalette(palette)
            outlined = QPalette(palette)
            color = self.color("outline").lighter(_FUSION_OUTLINE)
            outlined.setColor(QPalette.ColorRole.Window, color)
            filled = QPalette(palette)  # a header inherits from its table, and fills its free room
            filled.setColor(QPalette.ColorRole.Window, self.color("button"))
            for kind in (*_OUTLINED, "QHeaderView"):
                wanted = filled if kind == "QHeaderView" else outlined
                name: Any = kind  # PySide takes a str here, not the bytes that its stubs name
                if QApplication.palette(name) != wanted:  # Qt may have dropped it
                    QApplication.setPalette(wanted, name)
        if changes:
            self.changed.emit()


@cache
def theme() -> Theme:
    """The one theme of the application; without `install` it is the light one."""
    return Theme()


def choose_scheme(scheme: Scheme) -> None:
    """Set the scheme from now on, also at the next start."""
    theme().set_scheme(scheme)
    Preferences().set(_SCHEME, scheme)


def choose_font_size(percent: int) -> None:
    """Set the font size from now on, also at the next start."""
    theme().set_font_size(percent)
    Preferences().set(_FONT_SIZE, percent)


def restore_choices() -> None:
    """Use the scheme and the font size that were chosen."""
    store = Preferences()
    wanted = store.text(_SCHEME, "system")
    for scheme in SCHEMES:
        if scheme == wanted and scheme != theme().choice:
            theme().set_scheme(scheme)
    theme().set_font_size(store.integer(_FONT_SIZE, 100, FONT_SIZES[0], FONT_SIZES[-1]))


class _Follower(QObject):
    """Repeats what depends on the theme; lives as a child of its target."""

    apply: Callable[[], object]

    def __init__(self, target: QObject, key: str) -> None:
        super().__init__(target)
        self.setObjectName(key)
        theme().changed.connect(self._on_theme_changed)

    @Slot()
    def _on_theme_changed(self) -> None:
        self.apply()


def follow_theme(target: QObject, key: str, apply: Callable[[], object]) -> None:
    """Call `apply` now and when the theme changes; a later call with the same key replaces it."""
    options = Qt.FindChildOption.FindDirectChildrenOnly
    follower = target.findChild(_Follower, key, options) or _Follower(target, key)
    follower.apply = apply
    apply()


def scaled_font(font: QFont, factor: float) -> QFont:
    """Return a font of another size; its size may be in points or pixels."""
    scaled = QFont(font)
    if font.pointSizeF() > 0:
        scaled.setPointSizeF(font.pointSizeF() * factor)
    else:
        scaled.setPixelSize(round(font.pixelSize() * factor))
    return scaled


def fixed_font() -> QFont:
    """Return the system's fixed font in the font size of the theme."""
    font = QFontDatabase.systemFont(QFontDatabase.SystemFont.FixedFont)
    return scaled_font(font, theme().font_size / 100)


def set_text_color(widget: QWidget, name: str) -> None:
    def apply() -> None:
        palette = widget.palette()
        palette.setColor(widget.foregroundRole(), theme().color(name))
        widget.setPalette(palette)

    follow_theme(widget, "textColor", apply)


def tint(button: QPushButton | QToolButton, name: str) -> None:
    """Paint a button in the theme colour `name` with the text in `<name>_text`.

    Disabled, it looks like any other disabled button. An icon for it takes the same text colour:
    `set_icon(button, "stop", "stop_text")`.
    """

    def apply() -> None:
        palette = QPalette()
        fill = _before_fusion(theme().color(name))
        text = theme().color(f"{name}_text")
        for group in (QPalette.ColorGroup.Active, QPalette.ColorGroup.Inactive):
            palette.setColor(group, QPalette.ColorRole.Button, fill)
            palette.setColor(group, QPalette.ColorRole.ButtonText, text)
        button.setPalette(palette)

    follow_theme(button, "tint", apply)


def fill(widget: QWidget, name: str) -> None:
    """Fill a widget with the theme colour `name`, with its texts in `<name>_text`; empty: reset."""

    def apply() -> None:
        palette = QPalette()
        if name:
            palette.setColor(QPalette.ColorRole.Window, theme().color(name))
            palette.setColor(QPalette.ColorRole.WindowText, theme().color(f"{name}_text"))
        widget.setPalette(palette)

    follow_theme(widget, "fill", apply)


def _before_fusion(color: QColor) -> QColor:
    """Return the colour to give to Fusion so that it paints about `color`.

    Fusion takes a quarter of the saturation from a button's colour and brightens it, the more
    the darker it is.
    """
    saturation = min(255, round(color.hsvSaturation() / 0.75))
    return QColor.fromHsv(max(color.hsvHue(), 0), saturation, round(color.value() * 0.72))
