"""Checks of the names and descriptions that a screen reader speaks."""

import re

from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible, QTextDocumentFragment
from PySide6.QtWidgets import (
    QAbstractScrollArea,
    QAbstractSlider,
    QComboBox,
    QHeaderView,
    QLabel,
    QProgressBar,
    QScrollArea,
    QWidget,
)

from trex_gui.ui.widgets.accessible import Spoken

_USUALLY_EMPTY = {"bannerText"}
"""Widgets that are usually empty, but can accept the focus."""


def is_part(widget: QWidget) -> bool:
    """Return whether a widget is part of a compound widget, which has the name."""
    classes = {each.metaObject().className() for each in _with_parents(widget)}
    is_inside = widget.focusProxy() is widget.parentWidget() and not widget.objectName()
    return (
        is_inside or widget.objectName().startswith("qt_") or "QComboBoxPrivateContainer" in classes
    )


def _with_parents(widget: QWidget) -> list[QWidget]:
    parent = widget.parentWidget()
    return [widget, *(_with_parents(parent) if parent is not None else [])]


def is_visited(widget: QWidget) -> bool:
    """Return whether a screen reader visits a widget."""
    if isinstance(widget, QScrollArea):  # frame around named widgets
        return False
    is_area = isinstance(widget, QAbstractScrollArea | QHeaderView)
    parent = widget.parentWidget()
    is_viewport = (
        isinstance(parent, QAbstractScrollArea)
        and parent.viewport() is widget
        and bool(widget.objectName())
    )
    focusable = widget.focusPolicy() is not Qt.FocusPolicy.NoFocus
    return focusable or is_area or is_viewport or widget.objectName() in _USUALLY_EMPTY


def is_painted(widget: QWidget) -> bool:
    """Return whether a widget paints its content instead of setting a text."""
    return overrides(widget, "paintEvent") and not isinstance(widget, QLabel)


def overrides(widget: QWidget, method: str) -> bool:
    """Return whether a class of the program defines a method of a widget."""
    kinds = [kind for kind in type(widget).__mro__ if kind.__module__.startswith("trex_gui.")]
    return any(method in vars(kind) for kind in kinds)


def accessible_text(widget: QWidget, kind: QAccessible.Text) -> str:
    """Return the name, description or other text for a screen reader."""
    interface = QAccessible.queryAccessibleInterface(widget)
    return interface.text(kind) if interface is not None else ""


def path_of(widget: QWidget) -> str:
    path = [each.objectName() or type(each).__name__ for each in _with_parents(widget)[:5]]
    return f"{type(widget).__name__}: {' < '.join(path)}"


def nameless(root: QWidget) -> list[str]:
    """Return the paths of widgets without a name, a text or a label as buddy."""
    found = []
    for widget in [root, *root.findChildren(QWidget)]:
        needs_name = is_visited(widget) and not is_part(widget)
        if (
            (needs_name or is_painted(widget))
            and widget.window().isVisible()
            and not accessible_text(widget, QAccessible.Text.Name).strip()
        ):
            found.append(path_of(widget))
    return sorted(set(found))


def unspoken(root: QWidget) -> list[str]:
    """Return the widgets whose content a screen reader does not speak, with the reason."""
    found = []
    visible = [each for each in root.findChildren(QWidget) if each.isVisibleTo(root)]
    labelled = {each.buddy() for each in visible if isinstance(each, QLabel)}
    for widget in visible:
        name, description = (
            " ".join(accessible_text(widget, kind).split())
            for kind in (QAccessible.Text.Name, QAccessible.Text.Description)
        )
        match widget:
            case QLabel() if plain_text(widget) not in f"{name} {description}":
                found.append(f"the name replaces the text: {path_of(widget)}")
            # On Linux the name of a combo box is its text.
            case QComboBox() if widget not in labelled and not description:
                found.append(f"neither a label nor a description: {path_of(widget)}")
            case QAbstractSlider() | QProgressBar() if is_painted(widget) and not description:
                found.append(f"no description: {path_of(widget)}")
            case Spoken() if widget.spoken_role is QAccessible.Role.Chart and not description:
                found.append(f"no description: {path_of(widget)}")
    return found


def plain_text(label: QLabel) -> str:
    text = label.text()
    if label.buddy() is not None:
        text = text.replace("&", "")
    if re.search(r"<\w+[^<>]*>", text) and label.textFormat() is not Qt.TextFormat.PlainText:
        text = QTextDocumentFragment.fromHtml(text).toPlainText()
    return " ".join(text.split())


def spoken_state(widget: QWidget) -> str:
    """Return the state of a painted widget for a screen reader."""
    assert isinstance(widget, Spoken)
    return widget.spoken_state()
