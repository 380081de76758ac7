"""Functions that create named widgets and layouts."""

import re
from collections.abc import Callable, Iterable, Iterator
from functools import partial
from itertools import pairwise
from typing import Any, TypeVar

from PySide6.QtCore import QLocale, QMargins, QObject, QSize, SignalInstance
from PySide6.QtGui import QAction, QIcon, QKeySequence, QResizeEvent, QShortcut, Qt
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSpinBox,
    QBoxLayout,
    QCheckBox,
    QComboBox,
    QDoubleSpinBox,
    QGridLayout,
    QGroupBox,
    QHBoxLayout,
    QLabel,
    QLayout,
    QLineEdit,
    QProgressBar,
    QPushButton,
    QSizePolicy,
    QSlider,
    QSpinBox,
    QSplitter,
    QTableView,
    QTabWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from trex_gui.ui.theme.icons import set_icon
from trex_gui.ui.theme.theme import CARD_PADDING, follow_theme, set_look, set_style_property, theme
from trex_gui.ui.units import units
from trex_gui.ui.widgets.behaviour import ConfirmButton, focused_wheel, name_headers
from trex_gui.ui.widgets.painted import never_mirror


class Card(QGroupBox):
    """Group of controls with its title inside. Cards are never nested."""

    def __init__(self, title: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._title = label(self, size="heading")
        self.setTitle(title)

    def setTitle(self, title: str) -> None:  # noqa: N802 - Qt's name
        self._title.setText(title)
        set_style_property(self, "titled", bool(title))
        self.ensurePolished()  # Qt reserves the space that the current style defines
        super().setTitle(title)  # for screen readers; the style sheet hides the title

    def minimumSizeHint(self) -> QSize:
        title = self._title.sizeHint().width() + 2 * (CARD_PADDING + 1)
        return super().minimumSizeHint().expandedTo(QSize(title, 0))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        inside, height = self.contentsRect(), self._title.sizeHint().height()
        self._title.setGeometry(inside.x(), inside.x(), inside.width(), height)


class SpinBox(QSpinBox):
    """Spin box that reacts to the wheel only while focused. Otherwise the page scrolls."""

    wheelEvent = focused_wheel(QSpinBox.wheelEvent)


_TEXT_MARGIN = QMargins(0, 0, 4, 0)


class ComboBox(QComboBox):
    """Combo box that reacts to the wheel only while focused, like `SpinBox`."""

    wheelEvent = focused_wheel(QComboBox.wheelEvent)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def sizeHint(self) -> QSize:
        """Add pixels, because Qt reserves too few for large text if there is a style sheet."""
        return super().sizeHint().grownBy(_TEXT_MARGIN)

    def minimumSizeHint(self) -> QSize:
        return super().minimumSizeHint().grownBy(_TEXT_MARGIN)


Handler = Callable[..., object] | SignalInstance  # target of a signal
Trigger = Callable[[], object]  # handler of an action; does not receive the checked state
Part = QWidget | QLayout
Item = Part | int | tuple[Part, int] | tuple[Part, int, Qt.AlignmentFlag]
"""Part of a layout, with stretch and alignment. A number is the stretch of an empty space."""

Margins = int | tuple[int, int, int, int] | None
"""Pixels on the left, top, right and bottom, or on all sides.

`None`: 0 in cards, otherwise Qt's default.
"""

WidgetT = TypeVar("WidgetT", bound=QWidget)


def plain(text: str) -> str:
    """Return a text that Qt shows literally.

    Tool tips and message boxes guess the format of a text. They open files named in its markup.
    """
    return Qt.convertFromPlainText(text) if Qt.mightBeRichText(text) else text


def no_mnemonic(text: str) -> str:
    return text.replace("&", "&&")


def named(widget: WidgetT, name: str, *, accessible: str = "", tip: str = "") -> WidgetT:
    widget.setObjectName(name)
    if isinstance(widget, QAbstractSpinBox | QSlider):
        never_mirror(widget)
    if accessible:
        widget.setAccessibleName(accessible)
    if tip:
        widget.setToolTip(plain(tip))
    return widget


def button(
    parent: QWidget,
    name: str,
    text: str = "",
    *,
    icon: str = "",
    tip: str = "",
    accessible: str = "",
    checkable: bool = False,
    default: bool | None = None,
    confirms: bool = False,
    on_click: Handler | None = None,
    on_toggle: Handler | None = None,
) -> QPushButton:
    """Create a push button.

    `default`: Enter presses the button while no button has the focus. `None` leaves this to Qt.
    `confirms`: create a `ConfirmButton`, because the button may appear under the pointer.
    """
    kind = ConfirmButton if confirms else QPushButton
    widget = named(kind(text, parent), name, accessible=accessible, tip=tip)
    widget.setCheckable(checkable)
    if default:
        widget.setDefault(True)
        set_look(widget, "primary")
    elif default is False:
        widget.setAutoDefault(False)
    return _connected(widget, icon, on_click, on_toggle)


def tool_button(
    parent: QWidget,
    name: str,
    text: str = "",
    *,
    icon: str = "",
    tip: str = "",
    accessible: str = "",
    on_click: Handler | None = None,
) -> QToolButton:
    widget = named(QToolButton(parent), name, accessible=accessible, tip=tip)
    if text:
        widget.setText(text)
        widget.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    return _connected(widget, icon, on_click, None)


def check_box(
    parent: QWidget,
    name: str,
    text: str = "",
    *,
    tip: str = "",
    accessible: str = "",
    checked: bool = False,
    on_click: Handler | None = None,
    on_toggle: Handler | None = None,
) -> QCheckBox:
    """Create a check box. `checked` is set before `on_toggle` is connected."""
    widget = named(QCheckBox(text, parent), name, accessible=accessible, tip=tip)
    widget.setChecked(checked)
    return _connected(widget, "", on_click, on_toggle)


def label(
    parent: QWidget | None,
    name: str = "",
    text: str = "",
    *,
    tip: str = "",
    wrap: bool = False,
    expand: bool = False,
    rich: bool = False,
    selectable: bool = False,
    bold: bool = False,
    size: str = "",
    buddy: QWidget | None = None,
) -> QLabel:
    """Create a label.

    `expand`: take the remaining width. `rich`: the text is markup. Escape text from other sources.
    `size`: "title", "heading", "caption", or empty for ordinary text.
    """
    widget = QLabel(parent)
    widget.setObjectName(name)
    widget.setToolTip(plain(tip))
    widget.setTextFormat(Qt.TextFormat.RichText if rich else Qt.TextFormat.PlainText)
    widget.setText(text)
    if size:
        set_style_property(widget, "textSize", size)
    if selectable:
        widget.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    if expand:
        widget.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
    if wrap:
        widget.setWordWrap(True)  # after `setSizePolicy`, which would reset height-for-width
    if bold:
        set_bold(widget)
    if buddy is not None:
        widget.setBuddy(buddy)
    return widget


def search_field(parent: QWidget, name: str, accessible: str, hint: str) -> QLineEdit:
    """Create a search field. Ctrl+F focuses it while `parent` is visible."""
    widget = named(QLineEdit(parent), name, accessible=accessible)
    widget.setPlaceholderText(hint)
    widget.setClearButtonEnabled(True)
    clear = widget.findChild(QAction, "_q_qlineeditclearaction")
    if clear is not None:
        set_icon(clear, "clear")

    def focus() -> None:
        widget.setFocus()
        widget.selectAll()

    QShortcut(QKeySequence.StandardKey.Find, parent, focus)
    return widget


def combo_box(
    parent: QWidget,
    name: str,
    accessible: str,
    *,
    items: Iterable[str | tuple[str, object]] = (),
    tip: str = "",
    on_activate: Handler | None = None,
    on_change: Handler | None = None,
) -> ComboBox:
    """Create a combo box. An item is a text, or a text with its data.

    `on_activate`: called on a selection by the user. `on_change`: called on every new index.
    """
    widget = named(ComboBox(parent), name, accessible=accessible, tip=tip)
    for item in items:
        widget.addItem(*([item] if isinstance(item, str) else item))
    _connect(widget.activated, on_activate)
    _connect(widget.currentIndexChanged, on_change)
    return widget


UNGROUPED = QLocale(QLocale.Language.French)
"""Locale of spin boxes for whole numbers.

Other locales read 1,5 or 1.5 as 15 in large ranges.
"""


def spin_box(
    parent: QWidget,
    name: str,
    accessible: str,
    lowest: int,
    highest: int,
    *,
    value: int | None = None,
    suffix: str = "",
    step: int = 1,
    tip: str = "",
    on_change: Handler | None = None,
) -> QSpinBox:
    """Create a spin box that reports a typed number once it is complete.

    `value`, by default `lowest`, is set before `on_change` is connected.
    """
    widget = named(SpinBox(parent), name, accessible=accessible, tip=tip)
    widget.setLocale(UNGROUPED)
    widget.setRange(lowest, highest)
    widget.setSingleStep(step)
    widget.setValue(lowest if value is None else value)
    return _set_up_spin_box(widget, suffix, on_change)


SpinT = TypeVar("SpinT", QSpinBox, QDoubleSpinBox)


def _set_up_spin_box(widget: SpinT, suffix: str, on_change: Handler | None) -> SpinT:
    widget.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    widget.setSuffix(suffix)
    widget.setKeyboardTracking(False)
    _connect(widget.valueChanged, on_change)
    return widget


_NUMBER_PADDING = 16  # pixels beside a number in a spin box without buttons


def strip_style(box: QAbstractSpinBox, widest: str) -> None:
    """Hide the buttons of a spin box. Its minimum width fits the text `widest`."""

    def update_space() -> None:
        box.setMinimumWidth(box.fontMetrics().horizontalAdvance(widest) + _NUMBER_PADDING)

    set_look(box, "bare")
    follow_theme(box, "space", update_space)


class DecimalSpinBox(QDoubleSpinBox):
    """Spin box that reads a point or a comma as the decimal separator."""

    wheelEvent = focused_wheel(QDoubleSpinBox.wheelEvent)

    def validate(self, text: str, position: int) -> Any:
        return super().validate(re.sub("[.,]", self.locale().decimalPoint(), text), position)


def double_spin_box(
    parent: QWidget,
    name: str,
    accessible: str,
    lowest: float,
    highest: float,
    *,
    decimals: int,
    suffix: str = "",
    step: float = 1.0,
    on_change: Handler | None = None,
) -> QDoubleSpinBox:
    """Create a spin box for decimal numbers. Its initial value is `lowest`."""
    widget = named(DecimalSpinBox(parent), name, accessible=accessible)
    widget.setDecimals(decimals)
    widget.setRange(lowest, highest)
    widget.setSingleStep(step)
    widget.setValue(lowest)
    return _set_up_spin_box(widget, suffix, on_change)


TableT = TypeVar("TableT", bound=QTableView)


def flat_table(table: TableT, name: str, accessible: str) -> TableT:
    """Set the common look of a table. By default, a single row can be selected."""
    named(table, name, accessible=accessible)
    name_headers(table)
    table.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
    table.setSelectionMode(QAbstractItemView.SelectionMode.SingleSelection)
    table.setEditTriggers(QAbstractItemView.EditTrigger.NoEditTriggers)
    table.setAlternatingRowColors(True)
    table.setShowGrid(False)
    table.setTabKeyNavigation(False)
    table.verticalHeader().hide()
    set_row_height(table, 12)
    header = table.horizontalHeader()
    header.setDefaultAlignment(Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter)
    header.setHighlightSections(False)
    for changed in (theme().changed, units().changed):
        changed.connect(table.viewport().update)
    return table


def set_row_height(table: QTableView, padding: int) -> None:
    """Set the row height to the line height plus `padding` pixels. The height follows the font."""
    header, line = table.verticalHeader(), table.fontMetrics
    follow_theme(table, "rows", lambda: header.setDefaultSectionSize(line().height() + padding))


def splitter(
    parent: QWidget, name: str, orientation: Qt.Orientation, *parts: tuple[QWidget, int]
) -> QSplitter:
    """Create a splitter whose widgets cannot collapse. `parts`: widgets and their stretch."""
    result = named(QSplitter(orientation, parent), name)
    result.setChildrenCollapsible(False)
    for index, (widget, stretch) in enumerate(parts):
        result.addWidget(widget)
        result.setStretchFactor(index, stretch)
    return result


def progress_bar(parent: QWidget, name: str, accessible: str) -> QProgressBar:
    widget = named(QProgressBar(parent), name, accessible=accessible)
    widget.setTextVisible(False)
    return widget


def action(
    parent: QObject,
    name: str,
    text: str,
    *,
    icon: str = "",
    shortcut: QKeySequence | QKeySequence.StandardKey | str = "",
    context: Qt.ShortcutContext = Qt.ShortcutContext.WindowShortcut,
    checkable: bool = False,
    on_trigger: Trigger | None = None,
) -> QAction:
    """Create an action. Its shortcut works in widgets to which the action is added."""
    result = QAction(QIcon(), text, parent)
    result.setObjectName(name)
    result.setShortcut(QKeySequence(shortcut))
    result.setShortcutContext(context)
    result.setCheckable(checkable)
    if icon:
        set_icon(result, icon)
    if on_trigger is not None:
        result.triggered.connect(lambda _checked: on_trigger())
    return result


def tab_order(*parts: QWidget) -> None:
    """Set the Tab order of widgets. The children of a widget follow in the order of creation."""
    for before, after in pairwise(stop for part in parts for stop in _tab_stops(part)):
        QWidget.setTabOrder(before, after)


def _tab_stops(part: QWidget) -> Iterator[QWidget]:
    if part.focusPolicy() & Qt.FocusPolicy.TabFocus:
        yield part
    if isinstance(part, QTabWidget):  # the tab bar is the last child
        pages = (part.widget(index) for index in range(part.count()))
        children = [part.tabBar(), *(page for page in pages if page)]
    elif isinstance(part, QSplitter):  # a splitter reorders its children
        children = [child for index in range(part.count()) if (child := part.widget(index))]
    else:
        children = part.findChildren(QWidget, options=Qt.FindChildOption.FindDirectChildrenOnly)
    for child in children:
        if not child.isWindow():
            yield from _tab_stops(child)


def set_large(*buttons: QPushButton) -> None:
    def fit(button: QPushButton) -> None:
        height = round(1.6 * button.fontMetrics().height()) + 18
        button.setMinimumSize(max(4 * height, button.sizeHint().width()), height)

    for button in buttons:
        follow_theme(button, "large", partial(fit, button))


def set_bold(widget: QWidget, bold: bool = True) -> None:
    """Use the style sheet for bold text, since a new parent resets the font of a widget."""
    set_style_property(widget, "bold", bold)


def row(
    *items: Item, into: QWidget | None = None, margins: Margins = None, spacing: int | None = None
) -> QHBoxLayout:
    """Create a horizontal layout for the widget `into`, or for another layout by default."""
    return _filled(QHBoxLayout(into) if into else QHBoxLayout(), items, margins, spacing)


def column(
    *items: Item, into: QWidget | None = None, margins: Margins = None, spacing: int | None = None
) -> QVBoxLayout:
    return _filled(QVBoxLayout(into) if into else QVBoxLayout(), items, margins, spacing)


def grid(
    into: QWidget | None = None,
    *,
    margins: Margins = None,
    spacing: tuple[int, int] | None = None,
    stretch: Iterable[tuple[int, int]] = (),
) -> QGridLayout:
    """Create an empty grid. `spacing`: horizontal, vertical. `stretch`: columns and factors."""
    layout = QGridLayout(into) if into else QGridLayout()
    _set_margins(layout, margins)
    if spacing is not None:
        layout.setHorizontalSpacing(spacing[0])
        layout.setVerticalSpacing(spacing[1])
    for index, factor in stretch:
        layout.setColumnStretch(index, factor)
    return layout


ButtonT = TypeVar("ButtonT", bound=QAbstractButton)
LayoutT = TypeVar("LayoutT", bound=QBoxLayout)


def _connected(
    widget: ButtonT, icon: str, on_click: Handler | None, on_toggle: Handler | None
) -> ButtonT:
    if icon:
        is_primary = widget.property("look") == "primary"
        set_icon(widget, icon, "primary_text" if is_primary else "icon")
    _connect(widget.clicked, on_click)
    _connect(widget.toggled, on_toggle)
    return widget


def _connect(signal: SignalInstance, handler: Handler | None) -> None:
    if handler is not None:
        signal.connect(handler)


def _filled(
    layout: LayoutT, items: Iterable[Item], margins: Margins, spacing: int | None
) -> LayoutT:
    _set_margins(layout, margins)
    if spacing is not None:
        layout.setSpacing(spacing)
    for item in items:
        if isinstance(item, int):
            layout.addStretch(item)
            continue
        part, stretch, *alignment = item if isinstance(item, tuple) else (item, 0)
        if isinstance(part, QLayout):
            layout.addLayout(part, stretch)
            for flag in alignment:
                layout.setAlignment(part, flag)
        else:
            layout.addWidget(part, stretch, *alignment)
    return layout


def _set_margins(layout: QLayout, margins: Margins) -> None:
    if margins is None and isinstance(layout.parent(), Card):
        margins = 0
    if isinstance(margins, int):
        layout.setContentsMargins(margins, margins, margins, margins)
    elif margins is not None:
        layout.setContentsMargins(*margins)
