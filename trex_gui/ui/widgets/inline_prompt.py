"""Asking without standing in the way: the red button stays in reach, and in sight."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

from PySide6.QtCore import Qt, Slot
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QFrame, QLabel, QPushButton, QSizePolicy, QWidget

from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui


@dataclass(frozen=True, slots=True)
class PromptAnswer:
    """One way to go on.

    Attributes:
        name: of its button, in code.
        text: on its button.
        then: what it does.
    """

    name: str
    text: str
    then: Callable[[], object]


def _always() -> bool:
    return True


def _nothing() -> None:
    pass


class InlinePrompt(QFrame):
    """A row across the window with a button for each answer; hidden without a question.

    Cancel is beside every answer and does nothing. A new question replaces the present one,
    which counts as cancelled.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("question")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)
        self._still: Callable[[], bool] = _always
        self._otherwise: Callable[[], object] = _nothing
        self._buttons: list[QPushButton] = []

        self._sign = QLabel(self)
        self._text = ui.label(self, "questionText", wrap=True, plain=True)
        self._text.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._cancel = ui.button(
            self, "questionCancel", self.tr("Cancel"), default=False, on_click=self.withdraw
        )

        self._layout = ui.row(
            (self._sign, 0, Qt.AlignmentFlag.AlignTop),
            (self._text, 1),
            self._cancel,
            into=self,
            margins=(10, 6, 6, 6),
        )

        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()
        self.hide()

    def ask(
        self,
        text: str,
        *answers: PromptAnswer,
        still: Callable[[], bool] = _always,
        otherwise: Callable[[], object] = _nothing,
    ) -> None:
        """Ask; returns before the answer.

        Args:
            text: the question.
            answers: the ways to go on, besides Cancel.
            still: whether the question makes sense yet; see `reconsider`.
            otherwise: what to do when it is cancelled, or makes no sense any more.
        """
        self.withdraw()
        self._still, self._otherwise = still, otherwise
        self._text.setText(text)
        self.setAccessibleName(text)
        place = self._layout.indexOf(self._cancel)
        for number, answer in enumerate(answers):
            button = ui.button(self, answer.name, answer.text, default=False)
            button.clicked.connect(partial(self._on_answered, answer))
            self._layout.insertWidget(place + number, button)
            self._buttons.append(button)
        self.show()
        self._cancel.setFocus()

    @property
    def text(self) -> str:
        """The question; empty if there is none."""
        return self._text.text()

    @Slot()
    def withdraw(self) -> None:
        """Withdraw the question without an answer."""
        otherwise = self._otherwise
        self._close()
        otherwise()

    def reconsider(self) -> None:
        """Withdraw a question that things have answered by themselves."""
        if self.text and not self._still():
            self.withdraw()

    def _on_answered(self, answer: PromptAnswer) -> None:
        if self._still():
            self._close()
            answer.then()
        else:
            self.withdraw()

    def _close(self) -> None:
        self.hide()
        self._still, self._otherwise = _always, _nothing
        self._text.clear()
        buttons, self._buttons = self._buttons, []
        for button in buttons:
            self._layout.removeWidget(button)
            button.hide()
            button.setParent(None)
            button.deleteLater()  # later: the click that brought us here may be its own

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.withdraw()
        else:
            super().keyPressEvent(event)

    @Slot()
    def _on_theme_changed(self) -> None:
        size = self.fontMetrics().height() + 4
        self._sign.setPixmap(icon("warning", "warning").pixmap(size, size))
