"""Commits what the user has typed, so that an action uses what is shown."""

from PySide6.QtWidgets import QAbstractItemView, QAbstractSpinBox, QApplication, QWidget


def take_typed() -> None:
    """Commit the text of the focused spin box or cell.

    It does so by itself when it loses the focus. But a shortcut or a menu does not take the focus,
    nor does a button on a Mac.
    """
    box = QApplication.focusWidget()
    if box is None:
        return
    if (view := _view_of(box)) is not None:
        view.setFocus()  # the editor of a cell commits when it loses the focus
    elif isinstance(box, QAbstractSpinBox):
        box.interpretText()


def _view_of(editor: QWidget) -> QAbstractItemView | None:
    viewport = editor.parentWidget()
    view = viewport.parentWidget() if viewport is not None else None
    if isinstance(view, QAbstractItemView) and view.viewport() is viewport:
        return view
    return None
