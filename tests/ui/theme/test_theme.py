"""Colours, contrasts and icons of every scheme."""

import tomllib
from itertools import product

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QAction, QColor, QIcon, QPalette
from PySide6.QtWidgets import (
    QApplication,
    QMenu,
    QPushButton,
    QRadioButton,
    QStyle,
    QStyleOptionButton,
    QTabBar,
    QWidget,
)
from pytestqt.qtbot import QtBot

from tests.support.colours import contrast
from trex_gui.core.resource_files import resource
from trex_gui.ui.theme.icons import application_icon, icon, set_icon
from trex_gui.ui.theme.theme import Scheme, read_colors, set_look, theme
from trex_gui.ui.widgets import builders as ui
from trex_gui.ui.widgets.messages import Banner

pytestmark = pytest.mark.usefixtures("light_scheme")

SCHEMES = ("light", "dark", "high_contrast")


def required(normal: float, scheme: str) -> float:
    """Return the required contrast. `normal`: 3 for shapes, 4.5 for text."""
    return {4.5: 7.0, 3: 4.5}[normal] if scheme == "high_contrast" else normal


def tables(scheme: str) -> dict[str, dict[str, str]]:
    return tomllib.loads(resource(f"themes/{scheme}.toml").read_text(encoding="utf-8"))


def test_schemes_define_the_same_names() -> None:
    light, *other_schemes = ({t: set(names) for t, names in tables(s).items()} for s in SCHEMES)
    assert other_schemes == [light, light]


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize(
    ("kind", "minimum", "backgrounds"),
    [
        ("text", 4.5, ("window", "base", "plot_background")),
        ("graphics", 3, ("window", "track", "plot_background")),
    ],
)
def test_each_colour_has_enough_contrast(
    scheme: Scheme, kind: str, minimum: float, backgrounds: tuple[str, ...]
) -> None:
    theme().set_scheme(scheme)
    for name, background in product(tables(scheme)[kind], backgrounds):
        ratio = contrast(theme().color(name), theme().color(background))
        assert ratio >= required(minimum, scheme), (name, background)


PAIRS = (
    ("window_text", "window"),
    ("text", "base"),
    ("text", "alternate_base"),
    ("text", "deadband"),
    ("text", "track_off"),
    ("button_text", "button"),
    ("tool_tip_text", "tool_tip_base"),
    ("highlighted_text", "highlight"),
    ("link", "base"),
    ("link", "window"),
    ("placeholder_text", "base"),
    ("stop_text", "stop"),
    ("primary_text", "primary"),
    ("primary_text", "primary_down"),
    ("stop_text", "stop_down"),
    ("armed_text", "armed_down"),
    ("armed_muted", "armed"),
    ("armed_text", "armed"),
    ("text", "selected"),
    ("muted", "base"),
    ("muted", "alternate_base"),
    ("placeholder_text", "alternate_base"),
    ("placeholder_text", "window"),
    ("link", "alternate_base"),
    ("link_visited", "window"),
)
"""Colour of a text, and colour behind the text."""


@pytest.mark.parametrize("scheme", SCHEMES)
def test_palette_pairs_and_disabled_text_have_enough_contrast(scheme: Scheme) -> None:
    """Disabled text must be readable because it shows values that cannot be changed now."""
    theme().set_scheme(scheme)
    for text, background in PAIRS:
        ratio = contrast(theme().color(text), theme().color(background))
        assert ratio >= required(4.5, scheme), (text, background)
    disabled = read_colors(scheme).disabled
    backgrounds = ("window", "base", "alternate_base", "track_off")
    for role, background in product(("window_text", "text", "button_text"), backgrounds):
        assert contrast(disabled[role], theme().color(background)) >= 4.5, (role, background)
    assert contrast(disabled["button_text"], disabled["button"]) >= 4.5
    palette, group = read_colors(scheme).qpalette(), QPalette.ColorGroup
    for drawn in (QPalette.ColorRole.WindowText, QPalette.ColorRole.ButtonText):
        assert palette.color(group.Disabled, drawn) != palette.color(group.Active, drawn)


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize(
    "matrix",
    [
        # Full protanopia and deuteranopia. Ref: Machado, Oliveira, Fernandes 2009.
        ((0.152, 1.053, -0.205), (0.115, 0.786, 0.099), (-0.004, -0.048, 1.052)),
        ((0.367, 0.861, -0.228), (0.280, 0.673, 0.047), (-0.012, 0.043, 0.969)),
    ],
)
def test_motor_colours_differ_for_the_colour_blind(
    scheme: Scheme, matrix: tuple[tuple[float, float, float], ...]
) -> None:
    theme().set_scheme(scheme)

    def appearance(color: QColor) -> list[float]:
        rgb = color.redF(), color.greenF(), color.blueF()
        return [sum(f * part for f, part in zip(row, rgb, strict=True)) for row in matrix]

    first, second = (appearance(theme().color(name)) for name in ("motor1", "motor2"))
    assert sum((a - b) ** 2 for a, b in zip(first, second, strict=True)) ** 0.5 > 0.2


def test_widget_palette_follows_the_scheme(qtbot: QtBot) -> None:
    widget = QWidget()
    qtbot.addWidget(widget)
    with qtbot.waitSignal(theme().changed):
        theme().set_scheme("dark")
    qtbot.waitUntil(lambda: widget.palette().window().color() == theme().color("window"))
    assert theme().scheme == "dark"


def test_same_scheme_emits_no_change(qtbot: QtBot) -> None:
    with qtbot.assertNotEmitted(theme().changed):
        theme().set_scheme("light")


def test_second_install_does_not_change_the_system_scheme(qapp: QApplication) -> None:
    theme().set_scheme("dark")
    theme().install(qapp)
    theme().set_scheme("system")
    assert (theme().choice, theme().scheme) == ("system", "light")


def test_change_of_a_returned_colour_does_not_change_the_theme() -> None:
    theme().color("motor1").setAlpha(10)
    assert theme().color("motor1").alpha() == 255


@pytest.mark.parametrize("scheme", SCHEMES)
@pytest.mark.parametrize("look", ["stop", "primary"])
@pytest.mark.parametrize("down", [False, True])
def test_button_has_the_colour_of_its_look(
    qtbot: QtBot, scheme: Scheme, look: str, down: bool
) -> None:
    button = QPushButton()
    qtbot.addWidget(button)
    set_look(button, "link")
    button.show()
    set_look(button, look)  # while the button is visible
    theme().set_scheme(scheme)
    button.resize(100, 30)
    button.setDown(down)
    name = f"{look}_down" if down else look
    assert button.grab().toImage().pixelColor(50, 15) == theme().color(name)


def test_every_icon_is_neither_empty_nor_full() -> None:
    assert not application_icon().pixmap(64, 64).isNull()
    names = {path.stem for path in resource("icons").glob("*.svg")} - {"trex-studio"}
    for name, size in product(names, (16, 24, 48)):
        picture = icon(name).pixmap(size, size).toImage()
        opaque = sum(
            picture.pixelColor(x, y).alpha() > 128
            for x in range(picture.width())
            for y in range(picture.height())
        )
        assert 0.04 < opaque / (picture.width() * picture.height()) < 0.9, (name, size)


def most_opaque_color(drawn: QIcon, mode: QIcon.Mode = QIcon.Mode.Normal) -> QColor:
    """Return the colour of the most opaque pixel in the middle column."""
    picture = drawn.pixmap(48, 48, mode).toImage()
    pixels = (picture.pixelColor(24, y) for y in range(picture.height()))
    return max(pixels, key=QColor.alpha)


def test_icon_follows_the_theme(qtbot: QtBot) -> None:
    action = QAction()
    set_icon(action, "power")
    assert most_opaque_color(action.icon()) == theme().color("icon")
    for mode in (QIcon.Mode.Active, QIcon.Mode.Selected):  # highlighted row of a menu
        assert most_opaque_color(action.icon(), mode) == theme().color("highlighted_text")
    theme().set_scheme("dark")
    assert most_opaque_color(action.icon()) == theme().color("icon")
    set_icon(action, "power", "danger")
    theme().set_scheme("light")
    assert most_opaque_color(action.icon()) == theme().color("danger")
    assert most_opaque_color(action.icon(), QIcon.Mode.Disabled) != theme().color("danger")


def test_theme_ignores_a_deleted_button(qtbot: QtBot) -> None:
    button = QPushButton()
    set_icon(button, "stop")
    button.deleteLater()
    with qtbot.waitSignal(button.destroyed):
        pass
    theme().set_scheme("dark")


def test_frames_and_separators_are_visible_in_high_contrast(qtbot: QtBot) -> None:
    theme().set_scheme("high_contrast")
    box, banner, menu = ui.Card(), Banner(), QMenu()
    menu.addAction("first")
    separator = menu.addSeparator()
    menu.addAction("second")
    for widget in (box, banner, menu):
        qtbot.addWidget(widget)
        widget.resize(120, 80)
    middle = menu.actionGeometry(separator).center()
    for widget, points in ((box, ()), (banner, ()), (menu, (middle,))):
        picture = widget.grab().toImage()
        for point in (QPoint(60, picture.height() - 1), *points):
            assert contrast(picture.pixelColor(point), theme().color("window")) >= 3


def test_indicators_and_button_icons_grow_with_the_font(qtbot: QtBot) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    check, radio = ui.check_box(window, "", "text"), QRadioButton("text", window)
    button = ui.button(window, "", "text", icon="stop")

    def widths() -> list[int]:
        element = QStyle.SubElement
        sizes = [button.iconSize().width()]
        for box, part in (
            (check, element.SE_CheckBoxIndicator),
            (radio, element.SE_RadioButtonIndicator),
        ):
            option = QStyleOptionButton()
            box.initStyleOption(option)
            sizes.append(box.style().subElementRect(part, option, box).width())
        return sizes

    before = widths()
    theme().set_font_size(150)
    assert widths() == [pytest.approx(1.5 * width, abs=2) for width in before]


def test_tab_shows_accents_of_capital_letters(qtbot: QtBot) -> None:
    tabs = QTabBar()
    qtbot.addWidget(tabs)
    tabs.addTab("")
    tabs.addTab("E")
    tabs.show()
    plain = tabs.grab(tabs.tabRect(1)).toImage()
    tabs.setTabText(1, "É")
    assert tabs.grab(tabs.tabRect(1)).toImage() != plain
