"""Rows of messages, questions and actions across a window."""

from collections.abc import Callable
from functools import partial

from PySide6.QtCore import QEvent, QObject, Qt, Signal, Slot
from PySide6.QtGui import QGuiApplication, QKeyEvent, QMoveEvent, QResizeEvent
from PySide6.QtWidgets import (
    QAbstractItemView,
    QApplication,
    QFrame,
    QHBoxLayout,
    QPushButton,
    QWidget,
)

from trex_gui.core.translation import tr, tr_noop
from trex_gui.ui.notifier import (
    Answer,
    AnyRemedy,
    ConnectWith,
    CopyCommand,
    Notifier,
    Remedies,
    Remedy,
    never,
)
from trex_gui.ui.runtime import new_timer
from trex_gui.ui.theme.icons import set_sign
from trex_gui.ui.theme.theme import follow_theme, set_look, set_style_property
from trex_gui.ui.widgets import builders as ui

_BUTTONS: dict[Remedy | type[ConnectWith | CopyCommand], tuple[str, str]] = {
    Remedy.FIND: ("bannerFind", tr_noop("&Find now")),
    Remedy.RECONNECT: ("bannerReconnect", tr_noop("Reconnect")),
    Remedy.PLUG_IN: ("bannerReconnect", tr_noop("Reconnect")),
    Remedy.SET_UP_CRC: ("bannerSetUpCrc", tr_noop("Set up CRC…")),
    Remedy.CHECK_BOARD: ("bannerCheckBoard", tr_noop("C&heck the board…")),
    Remedy.REPORT: ("bannerReport", tr_noop("Sa&ve report…")),
    Remedy.STOP_MOTORS: ("bannerStop", tr_noop("Stop them now")),
    ConnectWith: ("bannerConnectWith", tr_noop("Connect with its settings")),
    CopyCommand: ("bannerCopy", tr_noop("Copy command")),
}
"""Object name and text of the button for each remedy."""

_NEWS_MS = 20_000  # display time of a news message, which remains in the log


class ActionBar(QFrame):
    def __init__(self, stop: QPushButton, parent: QWidget) -> None:
        super().__init__(parent)
        self.stop = stop
        stop.setParent(self)  # before the other children, so that Tab visits it first
        set_look(self, "actions")

    def fill(self, *items: ui.Item) -> QHBoxLayout:
        return ui.row(self.stop, *items, into=self, margins=(12, 6, 12, 6))


class _MessageRow(QFrame):
    def __init__(self, name: str, parent: QWidget | None, *, selectable: bool = False) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        set_look(self, "message")
        self._sign = ui.label(self)
        self._text = ui.label(self, f"{name}Text", wrap=True, expand=True, selectable=selectable)
        self._layout = ui.row(
            (self._sign, 0, Qt.AlignmentFlag.AlignTop),
            (self._text, 1),
            into=self,
            margins=(10, 4, 6, 4),
            spacing=10,
        )
        self._buttons: list[QPushButton] = []
        self.hide()

    @property
    def text(self) -> str:
        return self._text.text()

    def _add_button(self, name: str, text: str, before: QWidget) -> QPushButton:
        button = ui.button(self, name, text, default=False, confirms=True)
        self._layout.insertWidget(self._layout.indexOf(before), button)
        button.show()
        self._buttons.append(button)
        ui.tab_order(before, *self._buttons, before)
        return button

    def _remove_buttons(self) -> None:
        buttons, self._buttons = self._buttons, []
        for button in buttons:
            self._layout.removeWidget(button)
            button.hide()
            button.setParent(None)
            button.deleteLater()  # deferred: a click on the button may have called this method


class Banner(_MessageRow):
    chosen = Signal(object)  # the `Remedy` or `ConnectWith` of the pressed button
    help_requested = Signal(str)  # help topic of the message

    def __init__(
        self,
        parent: QWidget | None = None,
        notifier: Notifier | None = None,
        help_topic: Callable[[str], str] = lambda _: "",
    ) -> None:
        """`help_topic` returns the help topic of a message, or an empty text."""
        super().__init__("banner", parent, selectable=True)
        self._help_topic = help_topic
        self._notifier = notifier
        self._offered: Remedies = ()
        self._is_suppressed = False  # True if a lasting danger hides the newest message
        self._expiry = new_timer(self, _NEWS_MS, self._on_expired, single_shot=True)
        self._help = ui.button(
            self, "bannerHelp", tr("Help"), default=False, on_click=self._on_help_clicked
        )
        self._layout.addWidget(self._help)
        self._dismiss = ui.tool_button(self, "bannerDismiss", tr("Dismiss"), on_click=self.clear)
        self._layout.addWidget(self._dismiss)
        if notifier is not None:
            notifier.info.connect(self.show_news)
            notifier.error.connect(self.show_problem)
            notifier.danger.connect(self.show_danger)
            notifier.remedies_offered.connect(self.show_remedies)
            notifier.resolved.connect(self._on_resolved)
            notifier.cleared.connect(self._on_cleared)
        self.clear()

    @Slot(str)
    def show_problem(self, text: str) -> None:
        if not self._check_danger():
            self._show(text, "warning")

    @Slot(str)
    def show_danger(self, text: str) -> None:
        self._is_suppressed = False
        self._show(text, "warning", is_danger=True)

    @Slot(str)
    def show_news(self, text: str) -> None:
        if not self._check_danger():
            self._show(text, "info")

    def _check_danger(self) -> bool:
        """Return whether a danger lasts. If it does, new messages are only logged."""
        self._is_suppressed = self._notifier is not None and self._notifier.danger_lasts()
        return self._is_suppressed

    @Slot(object)
    def _on_resolved(self, remedy: Remedy) -> None:
        if remedy in self._offered and not self._check_danger():
            self.clear()

    @Slot()
    def _on_cleared(self) -> None:
        is_over = Remedy.REPORT not in self._offered or Remedy.STOP_MOTORS in self._offered
        if is_over and not self._check_danger():
            self.clear()

    @Slot()
    def clear(self) -> None:
        if self._notifier is not None:
            self._notifier.danger_lasts = never
        self._show("")

    @Slot()
    def _on_expired(self) -> None:
        focused = self.window().focusWidget()
        is_used = self.underMouse() or (focused is not None and self.isAncestorOf(focused))
        if is_used:
            self._expiry.start()
        elif not self._offered:
            self.clear()

    @Slot(object)
    def show_remedies(self, remedies: Remedies) -> None:
        if self._is_suppressed:
            return
        self._offered = remedies
        for remedy in remedies:
            if isinstance(remedy, Answer):
                name, text = remedy.name, remedy.text
            else:
                name, source = _BUTTONS[remedy if isinstance(remedy, Remedy) else type(remedy)]
                text = tr(source).replace("&", "")  # the page below may use the same mnemonic
            button = self._add_button(name, text, self._help)
            button.clicked.connect(partial(self._on_chosen, button, remedy))

    @Slot()
    def _on_help_clicked(self) -> None:
        self.help_requested.emit(self._help_topic(self.text))

    def _on_chosen(self, button: QPushButton, remedy: AnyRemedy) -> None:
        if isinstance(remedy, CopyCommand):
            QGuiApplication.clipboard().setText(remedy.command)
            button.setText(tr("Copied"))
        elif isinstance(remedy, Answer):
            self.clear()
            remedy.then()
        else:
            self.chosen.emit(remedy)

    def _show(self, text: str, sign: str = "", *, is_danger: bool = False) -> None:
        self._remove_buttons()
        self._offered = ()
        if self._notifier is not None:
            # A danger must not prevent an automatic connection, which stops the motors.
            self._notifier.shown = text
            self._notifier.shows_problem = sign == "warning" and not is_danger
            self._notifier.shown_changed.emit()
        if text:
            set_sign(self._sign, sign, "stop_text" if is_danger else sign, 4)
        set_style_property(self, "danger", is_danger)
        ui.set_bold(self._text, is_danger)
        self._text.setText(text)
        if text and sign == "info":
            self._expiry.start()
        else:
            self._expiry.stop()
        self._help.setVisible(bool(text and self._help_topic(text)))
        # Screen readers need a name while there is no message.
        self._text.setAccessibleName("" if text else tr("No message"))
        self.setVisible(bool(text))


def message_height(widget: QWidget) -> int:
    """Return the height in pixels of a one-line message."""
    return widget.fontMetrics().height() + 26


class MessageSpace(QWidget):
    """Space in a layout for a message of one line.

    A taller message covers the widget above. At the top of a window, it covers the widget below.
    """

    def __init__(self, parent: QWidget, *messages: QWidget, floats: bool = False) -> None:
        """`floats`: take no height, because the widget above reserves space at the bottom."""
        super().__init__(parent)
        self._cover = QWidget(parent)  # not in the layout
        self._cover.setAutoFillBackground(True)
        self._rows = ui.column(*messages, into=self._cover, margins=0)
        for widget in (self._cover, *messages):
            widget.installEventFilter(self)
        follow_theme(
            self, "height", lambda: self.setFixedHeight(0 if floats else message_height(self))
        )

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if event.type() in {QEvent.Type.LayoutRequest, QEvent.Type.Show}:
            self._fit()
        return False

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._fit()

    def moveEvent(self, event: QMoveEvent) -> None:
        super().moveEvent(event)
        self._fit()

    def _fit(self) -> None:
        height = 0
        if not self._rows.isEmpty():
            height = self._rows.totalHeightForWidth(self.width())
        self.setMinimumWidth(self._rows.totalMinimumSize().width())
        top = max(0, self.geometry().bottom() + 1 - height)
        self._cover.setGeometry(self.x(), top, self.width(), height)
        self._cover.raise_()


class InlinePrompt(_MessageRow):
    """Question with a button for each answer and a Cancel button.

    Unlike a dialog, a question does not cover the stop button. A new question cancels the
    current question.
    """

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("question", parent)
        self._is_valid: Callable[[], bool] = lambda: True
        self._on_withdrawn: Callable[[], object] = lambda: None
        self._cancel = ui.button(
            self, "questionCancel", tr("Cancel"), default=False, on_click=self.withdraw
        )
        self._layout.addWidget(self._cancel)
        set_sign(self._sign, "warning", "warning", 4)

    def prompt(
        self,
        text: str,
        *answers: Answer,
        is_valid: Callable[[], bool] = lambda: True,
        on_withdrawn: Callable[[], object] = lambda: None,
    ) -> None:
        """Show a question without waiting for the answer.

        `is_valid`: returns whether the question still makes sense (see `reconsider`).
        `on_withdrawn`: called when the question is cancelled or no longer makes sense.
        """
        self.withdraw()
        self._is_valid, self._on_withdrawn = is_valid, on_withdrawn
        self._text.setText(text)
        self.setAccessibleName(text)
        for answer in answers:
            button = self._add_button(answer.name, answer.text, self._cancel)
            button.clicked.connect(partial(self._on_answered, answer))
        self.show()
        focused, accepts_text = QApplication.focusWidget(), Qt.WidgetAttribute.WA_InputMethodEnabled
        is_editor = focused is not None and focused.testAttribute(accepts_text)
        if not is_editor or isinstance(focused, QAbstractItemView):
            self._cancel.setFocus()  # never while the user is typing

    @Slot()
    def withdraw(self) -> None:
        on_withdrawn = self._on_withdrawn
        self._close()
        on_withdrawn()

    def reconsider(self) -> None:
        """Withdraw a question that no longer makes sense."""
        if self.text and not self._is_valid():
            self.withdraw()

    def _on_answered(self, answer: Answer) -> None:
        if self._is_valid():
            self._close()
            answer.then()
        else:
            self.withdraw()

    def _close(self) -> None:
        self.hide()
        self._on_withdrawn = lambda: None
        self._text.clear()
        self._remove_buttons()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.withdraw()
        else:
            super().keyPressEvent(event)
