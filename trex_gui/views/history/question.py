"""Asking without standing in the way: the stop button of the window stays in reach."""

from collections.abc import Callable

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QAbstractButton, QMessageBox, QWidget


def ask(
    parent: QWidget, title: str, text: str, doing: str, then: Callable[[], object]
) -> QMessageBox:
    """Ask whether to do something that cannot be taken back; returns before the answer.

    Args:
        parent: the window that asks.
        title: of the question's window.
        text: the question.
        doing: what the button says that does it.
        then: what it does.
    """
    box = QMessageBox(parent)
    box.setObjectName("historyQuestion")
    box.setIcon(QMessageBox.Icon.Question)
    box.setWindowTitle(title)
    box.setText(text)
    yes = box.addButton(doing, QMessageBox.ButtonRole.AcceptRole)
    yes.setObjectName("historyQuestionYes")
    no = box.addButton(QMessageBox.StandardButton.Cancel)
    box.setDefaultButton(no)
    box.setEscapeButton(no)
    box.setWindowModality(Qt.WindowModality.NonModal)
    box.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)

    def answered(button: QAbstractButton) -> None:
        if button is yes:
            then()

    box.buttonClicked.connect(answered)
    box.show()
    return box
