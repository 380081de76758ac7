"""What was typed and not confirmed: it is shown, so it counts."""

from PySide6.QtWidgets import QAbstractItemView, QAbstractSpinBox, QApplication, QWidget


def take_typed() -> None:
    """Let the box with the focus take its text, before something is done with what is shown.

    By itself it does so when the focus leaves it. A shortcut or a menu does not take the focus
    away, nor does a button on a Mac.
    """
    box = QApplication.focusWidget()
    if box is None:
        return
    if (view := _view_of(box)) is not None:
        view.setFocus()  # the editor of a cell gives its value away with the focus
    elif isinstance(box, QAbstractSpinBox):
        box.interpretText()


def _view_of(editor: QWidget) -> QAbstractItemView | None:
    """Return the list or table in which something is edited."""
    viewport = editor.parentWidget()
    view = viewport.parentWidget() if viewport is not None else None
    if isinstance(view, QAbstractItemView) and view.viewport() is viewport:
        return view
    return None
