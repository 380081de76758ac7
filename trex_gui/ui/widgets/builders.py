"""Functions that create named widgets with usual properties, and layouts from their items."""

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
    """A group of controls: a plain surface with its title inside. Cards are never nested."""

    def __init__(self, title: str = "", parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._title = label(self, size="heading")
        self.setTitle(title)

    def setTitle(self, title: str) -> None:  # noqa: N802 - of Qt
        self._title.setText(title)
        set_style_property(self, "titled", bool(title))
        self.ensurePolished()  # Qt reserves the space that the present style defines
        super().setTitle(title)  # screen readers need it; the style sheet hides it

    def minimumSizeHint(self) -> QSize:
        title = self._title.sizeHint().width() + 2 * (CARD_PADDING + 1)
        return super().minimumSizeHint().expandedTo(QSize(title, 0))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        inside, height = self.contentsRect(), self._title.sizeHint().height()
        self._title.setGeometry(inside.x(), inside.x(), inside.width(), height)


class SpinBox(QSpinBox):
    """The wheel changes it only while it has the focus. Otherwise the page scrolls."""

    wheelEvent = focused_wheel(QSpinBox.wheelEvent)


_BESIDE_TEXT = QMargins(0, 0, 4, 0)


class ComboBox(QComboBox):
    """The wheel changes it only while it has the focus, as in `SpinBox`."""

    wheelEvent = focused_wheel(QComboBox.wheelEvent)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)

    def sizeHint(self) -> QSize:
        """Add the pixels that large text lacks under a style sheet."""
        return super().sizeHint().grownBy(_BESIDE_TEXT)

    def minimumSizeHint(self) -> QSize:
        return super().minimumSizeHint().grownBy(_BESIDE_TEXT)


Handler = Callable[..., object] | SignalInstance  # target of a signal
Trigger = Callable[[], object]  # handler of an action, without its checked state
Part = QWidget | QLayout
Item = Part | int | tuple[Part, int] | tuple[Part, int, Qt.AlignmentFlag]
"""Part of a layout, with its stretch and alignment. A number is empty space of that stretch."""

Margins = int | tuple[int, int, int, int] | None
"""Pixels at the left, top, right and bottom, or on all sides. `None`: 0 in cards, else Qt's."""

WidgetT = TypeVar("WidgetT", bound=QWidget)


def plain(text: str) -> str:
    """Return a text that Qt shows literally, even where it guesses the format.

    Tool tips and message boxes guess it, and would open files that markup from outside names.
    """
    return Qt.convertFromPlainText(text) if Qt.mightBeRichText(text) else text


def no_mnemonic(text: str) -> str:
    """Return a text for a menu or button that shows each `&`."""
    return text.replace("&", "&&")


def named(widget: WidgetT, name: str, *, accessible: str = "", tip: str = "") -> WidgetT:
    """Give a widget its object name, accessible name and tool tip, and return it."""
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

    `default`: whether Enter presses it when no button has the focus; `None` leaves it to Qt.
    `confirms`: the button may appear under the pointer, see `ConfirmButton`.
    """
    kind = ConfirmButton if confirms else QPushButton
    made = named(kind(text, parent), name, accessible=accessible, tip=tip)
    made.setCheckable(checkable)
    if default:
        made.setDefault(True)
        set_look(made, "primary")
    elif default is False:
        made.setAutoDefault(False)
    return _connected(made, icon, on_click, on_toggle)


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
    """Create a tool button: the icon, with the text beside it if there is one."""
    made = named(QToolButton(parent), name, accessible=accessible, tip=tip)
    if text:
        made.setText(text)
        made.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextBesideIcon)
    return _connected(made, icon, on_click, None)


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
    made = named(QCheckBox(text, parent), name, accessible=accessible, tip=tip)
    made.setChecked(checked)
    return _connected(made, "", on_click, on_toggle)


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
    """Create a label. `wrap` breaks long text into lines, `expand` takes the remaining width.

    `size` is "title", "heading" or "caption", or empty for ordinary text.

    A `rich` text is markup, in which text from outside has to be escaped.
    """
    made = QLabel(parent)
    made.setObjectName(name)
    made.setToolTip(plain(tip))
    made.setTextFormat(Qt.TextFormat.RichText if rich else Qt.TextFormat.PlainText)
    made.setText(text)
    if size:
        set_style_property(made, "textSize", size)
    if selectable:
        made.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    if expand:
        made.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
    if wrap:
        made.setWordWrap(True)  # after the size policy: makes the height depend on the width
    if bold:
        set_bold(made)
    if buddy is not None:
        made.setBuddy(buddy)
    return made


def search_field(parent: QWidget, name: str, accessible: str, hint: str) -> QLineEdit:
    """Create a field with a clear button. Ctrl+F focuses it while `parent` is visible."""
    made = named(QLineEdit(parent), name, accessible=accessible)
    made.setPlaceholderText(hint)
    made.setClearButtonEnabled(True)
    clear = made.findChild(QAction, "_q_qlineeditclearaction")
    if clear is not None:
        set_icon(clear, "clear")

    def find() -> None:
        made.setFocus()
        made.selectAll()

    QShortcut(QKeySequence.StandardKey.Find, parent, find)
    return made


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
    """Create a combo box. An item is a text, or a text and its data.

    `on_activate` follows the user, `on_change` every change of the current index.
    """
    made = named(ComboBox(parent), name, accessible=accessible, tip=tip)
    for item in items:
        made.addItem(*([item] if isinstance(item, str) else item))
    _connect(made.activated, on_activate)
    _connect(made.currentIndexChanged, on_change)
    return made


UNGROUPED = QLocale(QLocale.Language.French)
"""Locale of spin boxes for whole numbers. Others read 1,5 or 1.5 as 15 where numbers are large."""


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
    """Create a spin box that reports a typed number when it is complete.

    It shows `value`, by default `lowest`, which is set before `on_change` is connected.
    """
    made = named(SpinBox(parent), name, accessible=accessible, tip=tip)
    made.setLocale(UNGROUPED)
    made.setRange(lowest, highest)
    made.setSingleStep(step)
    made.setValue(lowest if value is None else value)
    return _complete(made, suffix, on_change)


SpinT = TypeVar("SpinT", QSpinBox, QDoubleSpinBox)


def _complete(made: SpinT, suffix: str, on_change: Handler | None) -> SpinT:
    made.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    made.setSuffix(suffix)
    made.setKeyboardTracking(False)
    _connect(made.valueChanged, on_change)
    return made


_AROUND_NUMBER = 16  # pixels beside a number without buttons


def strip_style(box: QAbstractSpinBox, widest: str) -> None:
    """Hide the buttons of a spin box, and make it as narrow as its `widest` text."""

    def update_space() -> None:
        box.setMinimumWidth(box.fontMetrics().horizontalAdvance(widest) + _AROUND_NUMBER)

    set_look(box, "bare")
    follow_theme(box, "room", update_space)


class DecimalSpinBox(QDoubleSpinBox):
    """Reads a point or a comma as the decimal separator, never as a thousands separator."""

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
    """Create a spin box for numbers with decimals, like `spin_box`. It shows `lowest`."""
    made = named(DecimalSpinBox(parent), name, accessible=accessible)
    made.setDecimals(decimals)
    made.setRange(lowest, highest)
    made.setSingleStep(step)
    made.setValue(lowest)
    return _complete(made, suffix, on_change)


TableT = TypeVar("TableT", bound=QTableView)


def flat_table(table: TableT, name: str, accessible: str) -> TableT:
    """Give a table the common look: striped rows, no grid, whole rows selected. Return it.

    Its cells are read-only and one row can be selected, unless the caller changes that.
    """
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


def set_row_height(table: QTableView, room: int) -> None:
    """Make rows `room` pixels higher than a line, in any font. A later call replaces `room`."""
    header, line = table.verticalHeader(), table.fontMetrics
    follow_theme(table, "rows", lambda: header.setDefaultSectionSize(line().height() + room))


def splitter(
    parent: QWidget, name: str, orientation: Qt.Orientation, *parts: tuple[QWidget, int]
) -> QSplitter:
    """Create a splitter of widgets, each with its stretch. No widget can be dragged to nothing."""
    made = named(QSplitter(orientation, parent), name)
    made.setChildrenCollapsible(False)
    for index, (widget, stretch) in enumerate(parts):
        made.addWidget(widget)
        made.setStretchFactor(index, stretch)
    return made


def progress_bar(parent: QWidget, name: str, accessible: str) -> QProgressBar:
    made = named(QProgressBar(parent), name, accessible=accessible)
    made.setTextVisible(False)
    return made


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
    """Create an action. A widget needs `addAction` to have its shortcut."""
    made = QAction(QIcon(), text, parent)
    made.setObjectName(name)
    made.setShortcut(QKeySequence(shortcut))
    made.setShortcutContext(context)
    made.setCheckable(checkable)
    if icon:
        set_icon(made, icon)
    if on_trigger is not None:
        made.triggered.connect(lambda _checked: on_trigger())
    return made


def tab_order(*parts: QWidget) -> None:
    """Let Tab visit these widgets in order, and inside each in the order of creation."""
    for before, after in pairwise(stop for part in parts for stop in _tab_stops(part)):
        QWidget.setTabOrder(before, after)


def _tab_stops(part: QWidget) -> Iterator[QWidget]:
    if part.focusPolicy() & Qt.FocusPolicy.TabFocus:
        yield part
    if isinstance(part, QTabWidget):  # its tab bar is its last child
        pages = (part.widget(index) for index in range(part.count()))
        inside = [part.tabBar(), *(page for page in pages if page)]
    elif isinstance(part, QSplitter):  # it changes the order of its children
        inside = [found for index in range(part.count()) if (found := part.widget(index))]
    else:
        inside = part.findChildren(QWidget, options=Qt.FindChildOption.FindDirectChildrenOnly)
    for each in inside:
        if not each.isWindow():
            yield from _tab_stops(each)


def set_large(*buttons: QPushButton) -> None:
    """Make important buttons easy to hit, and never too narrow for their text."""

    def fit(button: QPushButton, height: int) -> None:
        button.setMinimumSize(max(4 * height, button.sizeHint().width()), height)

    for button in buttons:
        height = round(1.6 * button.fontMetrics().height()) + 18
        follow_theme(button, "large", partial(fit, button, height))


def set_bold(widget: QWidget, bold: bool = True) -> None:
    """Set bold through the style sheet, which discards the font of a reparented widget."""
    set_style_property(widget, "bold", bold)


def row(
    *items: Item, into: QWidget | None = None, margins: Margins = None, spacing: int | None = None
) -> QHBoxLayout:
    """Lay items out side by side, as the layout of `into` or for use in another layout."""
    return _filled(QHBoxLayout(into) if into else QHBoxLayout(), items, margins, spacing)


def column(
    *items: Item, into: QWidget | None = None, margins: Margins = None, spacing: int | None = None
) -> QVBoxLayout:
    """Lay items out one below the other. Otherwise like `row`."""
    return _filled(QVBoxLayout(into) if into else QVBoxLayout(), items, margins, spacing)


def grid(
    into: QWidget | None = None,
    *,
    margins: Margins = None,
    spacing: tuple[int, int] | None = None,
    stretch: Iterable[tuple[int, int]] = (),
) -> QGridLayout:
    """Create an empty grid. `spacing` is horizontal and vertical, `stretch` (column, factor)."""
    made = QGridLayout(into) if into else QGridLayout()
    _set_margins(made, margins)
    if spacing is not None:
        made.setHorizontalSpacing(spacing[0])
        made.setVerticalSpacing(spacing[1])
    for number, factor in stretch:
        made.setColumnStretch(number, factor)
    return made


ButtonT = TypeVar("ButtonT", bound=QAbstractButton)
LayoutT = TypeVar("LayoutT", bound=QBoxLayout)


def _connected(
    made: ButtonT, icon: str, on_click: Handler | None, on_toggle: Handler | None
) -> ButtonT:
    if icon:
        is_primary = made.property("look") == "primary"
        set_icon(made, icon, "primary_text" if is_primary else "icon")
    _connect(made.clicked, on_click)
    _connect(made.toggled, on_toggle)
    return made


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
