"""A message across the window that stays until it is read."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QFrame, QHBoxLayout, QLabel, QSizePolicy, QToolButton, QWidget

from trex_gui.ui.notifier import Notifier
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme


class Banner(QFrame):
    """Shows the newest message of a notifier, or of its owner; hidden while there is none."""

    def __init__(self, parent: QWidget | None = None, notifier: Notifier | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("banner")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)

        self._kind = "info"
        self._sign = QLabel(self)
        self._text = QLabel(self)
        self._text.setObjectName("bannerText")
        self._text.setWordWrap(True)
        self._text.setTextFormat(Qt.TextFormat.PlainText)
        self._text.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
        self._text.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._dismiss = QToolButton(self)
        self._dismiss.setObjectName("bannerDismiss")
        self._dismiss.setText(self.tr("Dismiss"))
        self._dismiss.setAutoRaise(True)

        layout = QHBoxLayout(self)
        layout.setContentsMargins(10, 6, 6, 6)
        layout.setSpacing(10)
        layout.addWidget(self._sign, 0, Qt.AlignmentFlag.AlignTop)
        layout.addWidget(self._text, 1)
        layout.addWidget(self._dismiss, 0, Qt.AlignmentFlag.AlignTop)

        self._dismiss.clicked.connect(self.clear)
        if notifier is not None:
            notifier.info.connect(self.show_news)
            notifier.error.connect(self.show_problem)
            notifier.cleared.connect(self.clear)
        self._name_text()
        theme().changed.connect(self._on_theme_changed)
        self._on_theme_changed()
        self.hide()

    @Slot(str)
    def show_problem(self, text: str) -> None:
        """Show what went wrong, in place of the message before."""
        self._show(text, "warning")

    @Slot(str)
    def show_news(self, text: str) -> None:
        """Show what was done, in place of the message before."""
        self._show(text, "info")

    @Slot()
    def clear(self) -> None:
        """Have nothing to say."""
        self._show("", self._kind)

    @property
    def text(self) -> str:
        """The message shown; empty while there is none."""
        return self._text.text()

    def _show(self, text: str, kind: str) -> None:
        self._kind = kind
        self._on_theme_changed()
        self._text.setText(text)
        self._name_text()
        self.setVisible(bool(text))

    def _name_text(self) -> None:
        """Let a screen reader say what stands there, or that nothing does."""
        self._text.setAccessibleName("" if self._text.text() else self.tr("No message"))

    @Slot()
    def _on_theme_changed(self) -> None:
        size = self.fontMetrics().height() + 4
        self._sign.setPixmap(icon(self._kind, self._kind).pixmap(size, size))
