"""Checks for users without a mouse: mnemonics, Tab order, accessible names."""

import re
from collections import Counter
from collections.abc import Iterator, Sequence
from itertools import pairwise
from typing import TypeGuard

from PySide6.QtCore import QLocale, QPoint, QRect, Qt
from PySide6.QtGui import QKeySequence
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QComboBox,
    QDialogButtonBox,
    QDockWidget,
    QGroupBox,
    QHeaderView,
    QLabel,
    QLineEdit,
    QMainWindow,
    QMenu,
    QPlainTextEdit,
    QScrollArea,
    QScrollBar,
    QSplitter,
    QTabBar,
    QToolBar,
    QToolButton,
    QWidget,
)

from tests.support.accessible_names import (
    is_painted,
    is_part,
    nameless,
    overrides,
    path_of,
    unspoken,
)
from tests.support.catalogs import OTHER_LANGUAGES, translation, translation_of_qt
from trex_gui.devices.trex.views.boards import BoardPanel
from trex_gui.ui.devices.demo_panel import DemoDock
from trex_gui.ui.diagnostics.problems import ProblemCard
from trex_gui.ui.widgets.behaviour import HoldButton, RedButton
from trex_gui.ui.widgets.messages import Banner, InlinePrompt

_INPUTS = (
    QAbstractSpinBox,
    QComboBox,
    QAbstractSlider,
    QAbstractItemView,
    QLineEdit,
    QPlainTextEdit,
)
_STANDARD = QDialogButtonBox.StandardButton
_ENTER_AND_ESC = {_STANDARD.Ok, _STANDARD.Cancel, _STANDARD.Close}
"""Standard buttons. The platform may make their first letter the mnemonic."""

_CLOSING_NAME = re.compile(r"(cancel|close)\w*Button$", re.IGNORECASE)

_WITHOUT_MNEMONIC = (
    RedButton,  # Esc stops in every window
    HoldButton,  # works only while held with the space bar
)
_CONTAINERS_WITHOUT_MNEMONICS = (
    Banner,  # appears over every page, so no page could use its mnemonics
    InlinePrompt,  # appears over every page, and has the focus
    ProblemCard,  # there is a card for each problem
    BoardPanel,  # its actions have mnemonics in the Device menu
    DemoDock,  # stays beside every page, and few letters are free
    QToolBar,  # its actions are in a menu
    QLineEdit,  # an icon in an editor
)
_NAMES_WITHOUT_MNEMONIC = {
    "lineButton",  # its action has a mnemonic in a menu
    "aracna_startPort",  # there is a button for each port
    "startPort",
    "stopRecordingButton",  # visible on every page, and in a menu
}


def check_keyboard(window: QWidget, *, note: str = "") -> None:
    """Check the visible widgets of a window."""
    found = [
        *_repeated_mnemonics(window),
        *_without_mnemonic(window),
        *_out_of_order(window),
        *_out_of_reach(window),
        *(f"no accessible name: {each}" for each in nameless(window)),
        *unspoken(window),
        *(f"mnemonic in a name: {name}" for name in _spoken(window) if mnemonic(name)),
    ]
    assert not found, "\n".join([f"{window.objectName()} {note}", *found])


def _spoken(window: QWidget) -> Iterator[str]:
    for each in shown_in(window):
        yield each.accessibleName()


def shown_in(window: QWidget) -> Iterator[QWidget]:
    for each in window.findChildren(QWidget):
        if each.isVisibleTo(window) and each.window() is window.window():
            yield each


# --- Mnemonics --------------------------------------------------------------------------


def mnemonic(text: str) -> str:
    return QKeySequence.mnemonic(text).toString()


def _repeated_mnemonics(window: QWidget) -> Iterator[str]:
    texts: list[str] = []
    standard: list[str] = []
    for each in shown_in(window):
        match each:
            case QAbstractButton():
                has_default = _is_standard(each) and not mnemonic(each.text())
                (standard if has_default else texts).append(each.text())
            case QLabel() if each.buddy() is not None:
                texts.append(each.text())
            case QGroupBox():
                texts.append(each.title())
            case QTabBar():
                texts += [each.tabText(index) for index in range(each.count())]
    if isinstance(window, QMainWindow):
        bar = window.menuBar()
        texts += [each.text() for each in bar.actions() if each.isVisible()]
        actions = [each for menu in bar.findChildren(QMenu) for each in menu.actions()]
        visible = [each for each in actions if each.isVisible()]
        yield from _clashes([(each.shortcut().toString(), each.text()) for each in visible])
    for menu in window.findChildren(QMenu):
        yield from _shared_mnemonics([each.text() for each in menu.actions() if each.isVisible()])
    yield from _shared_mnemonics(texts, standard)


def _shared_mnemonics(texts: list[str], standard: Sequence[str] = ()) -> Iterator[str]:
    """Yield the mnemonics that several texts share, in English and in each translation.

    `standard`: texts of standard buttons, whose first letter may become the mnemonic.
    """
    defaults = [f"&{text}" for text in standard]
    yield from _clashes([(mnemonic(text), text) for text in (*texts, *defaults)])
    if QLocale().language() is QLocale.Language.English:
        for language in OTHER_LANGUAGES:
            translated = [translation(language, text) for text in texts if mnemonic(text)]
            translated += [f"&{translation_of_qt(language, text)}" for text in standard]
            for clash in _clashes([(mnemonic(text), text) for text in translated]):
                yield f"{language}: {clash}"


def _clashes(keys: list[tuple[str, str]]) -> Iterator[str]:
    for key, count in Counter(key for key, _ in keys).items():
        if key and count > 1:
            yield f"{key} is {' and '.join(text for each, text in keys if each == key)}"


def _without_mnemonic(window: QWidget) -> Iterator[str]:
    widgets = list(shown_in(window))
    buttons = [each for each in widgets if isinstance(each, QAbstractButton)]
    texts = Counter(each.text().replace("&", "") for each in buttons)
    for button in buttons:
        text = button.text()
        if _is_exempt(button) or _is_standard(button) or mnemonic(text):
            continue
        if not text:
            if not (button.toolTip() and button.accessibleName()):
                yield f"no text, and no tool tip and accessible name: {button.objectName()}"
        elif texts[text] == 1 and not button.objectName()[-1:].isdigit():  # rows have no mnemonics
            yield f"no mnemonic: {button.objectName()} {text}"
    for each in widgets:
        if isinstance(each, QLabel) and isinstance(each.buddy(), _INPUTS) and not _is_exempt(each):
            text = each.text()
            if not mnemonic(text) and not text.isdigit():
                yield f"no mnemonic: label {text}"
            if "&" in text and ";" in text:
                yield f"the mnemonic is part of a character entity: {text}"


def _is_standard(button: QAbstractButton) -> bool:
    box = button.parent()
    return isinstance(box, QDialogButtonBox) and box.standardButton(button) in _ENTER_AND_ESC


def _is_exempt(widget: QWidget) -> bool:
    """Return whether a widget needs no mnemonic."""
    name = widget.objectName()
    return (
        isinstance(widget, _WITHOUT_MNEMONIC)
        or name in _NAMES_WITHOUT_MNEMONIC
        or _CLOSING_NAME.search(name) is not None
        or name.startswith("qt_")
        or any(isinstance(parent, _CONTAINERS_WITHOUT_MNEMONICS) for parent in _parents(widget))
    )


def _parents(widget: QWidget) -> Iterator[QWidget]:
    parent = widget.parentWidget()
    while parent is not None:
        yield parent
        if parent.isWindow():
            return
        parent = parent.parentWidget()


# --- Reachable widgets ------------------------------------------------------------------

_ALTERNATIVES = {
    # the joints of the drawing are also rows of a table and fields of a pose
    "aracnaDrawing": {"aracnaSlider0", "aracnaRecordedJoints", "aracnaPosition0"},
    "eventMarks": {"eventList"},
}
"""Widgets for the mouse only, and the widgets that replace them for the keyboard."""

_MOUSE_HANDLERS = "mousePressEvent", "mouseMoveEvent", "mouseReleaseEvent"


def _out_of_reach(window: QWidget) -> Iterator[str]:
    """Yield widgets that need a mouse, or that accept the focus, but no key."""
    reached = tab_order(window)
    names = {each.objectName() for each in reached}
    for each in shown_in(window):
        takes_tab = bool(each.focusPolicy() & Qt.FocusPolicy.TabFocus)
        uses_mouse = any(overrides(each, handler) for handler in _MOUSE_HANDLERS)
        is_input = isinstance(each, (QAbstractButton, *_INPUTS))
        if uses_mouse and each not in reached and not _is_inside(each):
            if names.isdisjoint(_ALTERNATIVES.get(each.objectName(), ())):
                yield f"reached with the mouse only: {path_of(each)}"
        elif is_input and not takes_tab and not _is_inside(each):
            yield f"not reached with Tab: {path_of(each)}"
        elif isinstance(each, QLabel) and "<a " in each.text():
            if not each.textInteractionFlags() & Qt.TextInteractionFlag.LinksAccessibleByKeyboard:
                yield f"links reached with the mouse only: {path_of(each)}"
        elif (
            is_painted(each)
            and takes_tab
            and not (uses_mouse or is_input or overrides(each, "keyPressEvent"))
        ):
            yield f"accepts the focus, but no key: {path_of(each)}"


def _is_choice(widget: QWidget) -> TypeGuard[QAbstractButton]:
    return isinstance(widget, QAbstractButton) and (
        widget.autoExclusive() or widget.group() is not None
    )


def _is_inside(widget: QWidget) -> bool:
    """Return whether a parent handles the keys of a widget, or a menu contains its action."""
    parent = widget.parentWidget()
    return (
        is_part(widget)
        or widget.focusProxy() is not None
        or isinstance(widget, QScrollBar | QHeaderView)
        or isinstance(parent, QAbstractSpinBox | QComboBox | QLineEdit | QTabBar)
        or (_is_choice(widget) and not widget.isChecked())  # the arrow keys reach it
        or (isinstance(parent, QToolBar) and _is_in_menu(widget))
    )


def _is_in_menu(button: QWidget) -> bool:
    action = button.defaultAction() if isinstance(button, QToolButton) else None
    menus = button.window().findChildren(QMenu)
    return action is None or any(action in menu.actions() for menu in menus)


# --- Tab order --------------------------------------------------------------------------


def tab_order(window: QWidget) -> list[QWidget]:
    """Return the widgets in the Tab order, including disabled widgets."""
    order = []
    each = _next(window)
    while each is not window:
        takes_tab = bool(each.focusPolicy() & Qt.FocusPolicy.TabFocus)
        if (
            takes_tab
            and each.focusProxy() is None
            and each.window() is window.window()
            and each.isVisibleTo(window)
            and not isinstance(each, QScrollArea)
        ):
            order.append(each)
        each = _next(each)
    return order


def _next(widget: QWidget) -> QWidget:
    """Return the next widget in the Tab order. PySide makes it a child of `widget`."""
    following = widget.nextInFocusChain()
    assert following is not None
    following.setParent(following.parentWidget())  # restores the parent
    return following


_BOXES = QGroupBox, QDockWidget, QScrollArea
_COLUMNS = {"benchLeft", "boardPanel"}
"""Containers that Tab leaves only after the last widget, like parts of a splitter."""

_WITH_COLUMNS = {"boardDrawing", "demoDrawing"}
"""Boxes with columns. Tab may go up to the top of the next column."""


def _region(widget: QWidget, window: QWidget) -> list[QWidget]:
    """Return the columns and boxes around a widget from outside in, then the widget."""
    regions = [widget]
    for parent in _parents(widget):
        if parent is window:
            break
        is_splitter_part = isinstance(parent.parentWidget(), QSplitter)
        if is_splitter_part or isinstance(parent, _BOXES) or parent.objectName() in _COLUMNS:
            regions.append(parent)
    return regions[::-1]


def _out_of_order(window: QWidget) -> Iterator[str]:
    paths = [_region(each, window) for each in tab_order(window)]
    left: set[QWidget] = set()
    for before, after in pairwise(paths):
        depth = next(i for i, (a, b) in enumerate(zip(before, after, strict=False)) if a is not b)
        names = f"{before[-1].objectName()} → {after[-1].objectName()}"
        left.update(before[depth:])
        if left & set(after):
            yield f"Tab returns to a box: {names}"
        elif not _follows(
            _place(before[depth], window),
            _place(after[depth], window),
            in_columns=depth > 0 and before[depth - 1].objectName() in _WITH_COLUMNS,
        ):
            yield f"Tab goes backward: {names}"


def _place(widget: QWidget, window: QWidget) -> QRect:
    """Return the rectangle of a widget, in a scrolling page without the space for messages."""
    place = QRect(widget.mapTo(window, QPoint()), widget.size())
    if isinstance(widget, QScrollArea) and (content := widget.widget()) is not None:
        place.adjust(0, 0, 0, -content.contentsMargins().bottom())
    return place


def _follows(before: QRect, after: QRect, *, in_columns: bool) -> bool:
    """Return whether `after` is below `before`, or to the right of it in the same row."""
    is_below = after.center().y() > before.bottom()
    is_beside = after.left() >= before.right() and (
        in_columns or (before.top() < after.bottom() and after.top() < before.bottom())
    )
    return is_below or is_beside
