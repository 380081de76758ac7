"""Checks for users who have only a keyboard: mnemonics, Tab order, names."""

import re
from collections import Counter
from collections.abc import Iterable, Iterator
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
"""Standard buttons, to which the platform may give their first letter."""

_NAME_OF_ESC = re.compile(r"(cancel|close)\w*Button$", re.IGNORECASE)

_WITHOUT_LETTER = (
    RedButton,  # Esc stops in every window
    HoldButton,  # works only while held with the space bar
)
_INSIDE_WITHOUT_LETTER = (
    Banner,  # appears over every page and would take letters from each
    InlinePrompt,  # appears over every page, and has the focus
    ProblemCard,  # several cards, one for each problem
    BoardPanel,  # its actions have letters in the Device menu
    DemoDock,  # beside every page, where letters are short
    QToolBar,  # its actions are in a menu
    QLineEdit,  # icon in an editor
)
_NAMED_WITHOUT_LETTER = {
    "lineButton",  # in a menu with a letter
    "aracna_startPort",  # several buttons, one for each port
    "startPort",
    "stopRecordingButton",  # over every page, and in a menu
}


def check_keyboard(window: QWidget, *, note: str = "") -> None:
    """Check everything that a window shows."""
    found = [
        *_repeated_letters(window),
        *_without_letter(window),
        *_out_of_order(window),
        *_out_of_reach(window),
        *(f"no accessible name: {each}" for each in nameless(window)),
        *unspoken(window),
        *(f"letter in a name: {name}" for name in _spoken(window) if letter(name)),
    ]
    assert not found, "\n".join([f"{window.objectName()} {note}", *found])


def _spoken(window: QWidget) -> Iterator[str]:
    for each in shown_in(window):
        yield each.accessibleName()


def shown_in(window: QWidget) -> Iterator[QWidget]:
    for each in window.findChildren(QWidget):
        if each.isVisibleTo(window) and each.window() is window.window():
            yield each


# --- Letters ----------------------------------------------------------------------------


def letter(text: str) -> str:
    return QKeySequence.mnemonic(text).toString()


def _repeated_letters(window: QWidget) -> Iterator[str]:
    texts: list[str] = []
    standard: list[str] = []
    for each in shown_in(window):
        match each:
            case QAbstractButton():
                takes_first = _is_standard(each) and not letter(each.text())
                (standard if takes_first else texts).append(each.text())
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
        shown = [each for each in actions if each.isVisible()]
        yield from _clashes([(each.shortcut().toString(), each.text()) for each in shown])
    for menu in window.findChildren(QMenu):
        yield from _shared_letters([each.text() for each in menu.actions() if each.isVisible()])
    yield from _shared_letters(texts, standard)


def _shared_letters(texts: list[str], standard: Iterable[str] = ()) -> Iterator[str]:
    """Yield mnemonics of several texts, in English and in each translation.

    `standard` are those of buttons of Qt, which may get their first letter.
    """
    firsts = [f"&{text}" for text in standard]
    yield from _clashes([(letter(text), text) for text in (*texts, *firsts)])
    if QLocale().language() is QLocale.Language.English:
        for language in OTHER_LANGUAGES:
            there = [translation(language, text) for text in texts if letter(text)]
            firsts = [f"&{translation_of_qt(language, text)}" for text in standard]
            for clash in _clashes([(letter(text), text) for text in (*there, *firsts)]):
                yield f"{language}: {clash}"


def _clashes(keys: list[tuple[str, str]]) -> Iterator[str]:
    for key, count in Counter(key for key, _ in keys).items():
        if key and count > 1:
            yield f"{key} is {' and '.join(text for each, text in keys if each == key)}"


def _without_letter(window: QWidget) -> Iterator[str]:
    widgets = list(shown_in(window))
    buttons = [each for each in widgets if isinstance(each, QAbstractButton)]
    texts = Counter(each.text().replace("&", "") for each in buttons)
    for button in buttons:
        text = button.text()
        if _is_free(button) or _is_standard(button) or letter(text):
            continue
        if not text:
            if not (button.toolTip() and button.accessibleName()):
                yield f"no text, and no tool tip and accessible name: {button.objectName()}"
        elif texts[text] == 1 and not button.objectName()[-1:].isdigit():  # rows have no letter
            yield f"no letter: {button.objectName()} {text}"
    for each in widgets:
        if isinstance(each, QLabel) and isinstance(each.buddy(), _INPUTS) and not _is_free(each):
            text = each.text()
            if not letter(text) and not text.isdigit():
                yield f"no letter: label {text}"
            if "&" in text and ";" in text:
                yield f"the letter is that of a character entity: {text}"


def _is_standard(button: QAbstractButton) -> bool:
    box = button.parent()
    return isinstance(box, QDialogButtonBox) and box.standardButton(button) in _ENTER_AND_ESC


def _is_free(widget: QWidget) -> bool:
    """Return whether a widget needs no letter."""
    name = widget.objectName()
    return (
        isinstance(widget, _WITHOUT_LETTER)
        or name in _NAMED_WITHOUT_LETTER
        or _NAME_OF_ESC.search(name) is not None
        or name.startswith("qt_")
        or any(isinstance(above, _INSIDE_WITHOUT_LETTER) for above in _above(widget))
    )


def _above(widget: QWidget) -> Iterator[QWidget]:
    parent = widget.parentWidget()
    while parent is not None:
        yield parent
        if parent.isWindow():
            return
        parent = parent.parentWidget()


# --- What can be reached ----------------------------------------------------------------

_ELSEWHERE = {
    # its joints are rows of a table and fields of a pose
    "aracnaDrawing": {"aracnaSlider0", "aracnaRecordedJoints", "aracnaPosition0"},
    "eventMarks": {"eventList"},
}
"""Widgets for the mouse only. A sibling does the same by keyboard."""

_HANDS = "mousePressEvent", "mouseMoveEvent", "mouseReleaseEvent"


def _out_of_reach(window: QWidget) -> Iterator[str]:
    """Yield widgets that need a mouse, or that take the focus without a function."""
    reached = tab_order(window)
    names = {each.objectName() for each in reached}
    for each in shown_in(window):
        takes_tab = bool(each.focusPolicy() & Qt.FocusPolicy.TabFocus)
        takes_hands = any(overrides(each, hand) for hand in _HANDS)
        is_input = isinstance(each, (QAbstractButton, *_INPUTS))
        if takes_hands and each not in reached and not _is_inside(each):
            if names.isdisjoint(_ELSEWHERE.get(each.objectName(), ())):
                yield f"only the mouse reaches it: {path_of(each)}"
        elif is_input and not takes_tab and not _is_inside(each):
            yield f"Tab does not reach it: {path_of(each)}"
        elif isinstance(each, QLabel) and "<a " in each.text():
            if not each.textInteractionFlags() & Qt.TextInteractionFlag.LinksAccessibleByKeyboard:
                yield f"only the mouse reaches its links: {path_of(each)}"
        elif (
            is_painted(each)
            and takes_tab
            and not (takes_hands or is_input or overrides(each, "keyPressEvent"))
        ):
            yield f"takes the focus and no key: {path_of(each)}"


def _is_choice(widget: QWidget) -> TypeGuard[QAbstractButton]:
    return isinstance(widget, QAbstractButton) and (
        widget.autoExclusive() or widget.group() is not None
    )


def _is_inside(widget: QWidget) -> bool:
    """Return whether a parent handles the keys of a widget, or a menu has its action."""
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


# --- The order of Tab -------------------------------------------------------------------


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
    following.setParent(following.parentWidget())  # restores its parent for PySide
    return following


_REGIONS = QGroupBox, QDockWidget, QScrollArea
_COLUMNS = {"benchLeft", "boardPanel"}
"""Containers that Tab leaves only after their last widget, like parts of a splitter."""

_IN_COLUMNS = {"boardDrawing", "demoDrawing"}
"""Boxes in which Tab may go up to the next column."""


def _region(widget: QWidget, window: QWidget) -> list[QWidget]:
    """Return the columns and boxes around a widget, the widest first, and the widget."""
    regions = [widget]
    for above in _above(widget):
        if above is window:
            break
        is_part = isinstance(above.parentWidget(), QSplitter)
        if is_part or isinstance(above, _REGIONS) or above.objectName() in _COLUMNS:
            regions.append(above)
    return regions[::-1]


def _out_of_order(window: QWidget) -> Iterator[str]:
    paths = [_region(each, window) for each in tab_order(window)]
    left: set[QWidget] = set()
    for before, after in pairwise(paths):
        depth = next(i for i, (a, b) in enumerate(zip(before, after, strict=False)) if a is not b)
        names = f"{before[-1].objectName()} → {after[-1].objectName()}"
        left.update(before[depth:])
        if left & set(after):
            yield f"Tab comes back: {names}"
        elif not _follows(
            _place(before[depth], window),
            _place(after[depth], window),
            in_columns=depth > 0 and before[depth - 1].objectName() in _IN_COLUMNS,
        ):
            yield f"Tab goes back: {names}"


def _place(widget: QWidget, window: QWidget) -> QRect:
    """Return the rectangle of a widget. On a scrolling page it excludes the message space."""
    place = QRect(widget.mapTo(window, QPoint()), widget.size())
    if isinstance(widget, QScrollArea) and (content := widget.widget()) is not None:
        place.adjust(0, 0, 0, -content.contentsMargins().bottom())
    return place


def _follows(before: QRect, after: QRect, *, in_columns: bool) -> bool:
    """Return whether a rectangle is to the right of another in its row, or below it."""
    is_below = after.center().y() > before.bottom()
    is_beside = after.left() >= before.right() and (
        in_columns or (before.top() < after.bottom() and after.top() < before.bottom())
    )
    return is_below or is_beside
