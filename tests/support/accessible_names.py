"""Whether everything that a screen reader comes to has a name."""

from PySide6.QtCore import Qt
from PySide6.QtGui import QAccessible
from PySide6.QtWidgets import QAbstractScrollArea, QHeaderView, QScrollArea, QWidget

from trex_gui.ui.widgets.accessible import Spoken

_OFTEN_SILENT = {"bannerText"}
"""Empty most of the time, and can take the focus at any time."""


def is_part(widget: QWidget) -> bool:
    """Return whether a widget belongs to another one that has the name."""
    classes = {each.metaObject().className() for each in _up_from(widget)}
    is_inside = widget.focusProxy() is widget.parentWidget() and not widget.objectName()
    return (
        is_inside or widget.objectName().startswith("qt_") or "QComboBoxPrivateContainer" in classes
    )


def _up_from(widget: QWidget) -> list[QWidget]:
    above = widget.parentWidget()
    return [widget, *(_up_from(above) if above is not None else [])]


def takes_part(widget: QWidget) -> bool:
    """Return whether a screen reader comes to a widget."""
    if isinstance(widget, QScrollArea):  # only a frame around what has names
        return False
    is_area = isinstance(widget, QAbstractScrollArea | QHeaderView)
    parent = widget.parentWidget()
    is_viewport = (
        isinstance(parent, QAbstractScrollArea)
        and parent.viewport() is widget
        and bool(widget.objectName())
    )
    focusable = widget.focusPolicy() is not Qt.FocusPolicy.NoFocus
    return focusable or is_area or is_viewport or widget.objectName() in _OFTEN_SILENT


def nameless(root: QWidget) -> list[str]:
    """Return the widgets without an accessible name; names by buddy or text count."""
    found = []
    for widget in [root, *root.findChildren(QWidget)]:
        if not takes_part(widget) or not widget.window().isVisible() or is_part(widget):
            continue
        interface = QAccessible.queryAccessibleInterface(widget)
        name = interface.text(QAccessible.Text.Name) if interface is not None else ""
        if not name.strip():
            path = [each.objectName() or type(each).__name__ for each in _up_from(widget)[:5]]
            found.append(f"{type(widget).__name__}: {' < '.join(path)}")
    return sorted(set(found))


def assert_named(root: QWidget) -> None:
    found = nameless(root)
    assert not found, "\n".join(found)


def spoken_state(widget: QWidget) -> str:
    """Return what a screen reader is told of the state of a painted widget."""
    assert isinstance(widget, Spoken)
    return widget.spoken_state()
