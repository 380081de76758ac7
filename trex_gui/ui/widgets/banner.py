"""A message across the window that stays until it is read."""

from PySide6.QtCore import Qt, Slot
from PySide6.QtWidgets import QFrame, QLabel, QSizePolicy, QWidget

from trex_gui.ui.notifier import Notifier
from trex_gui.ui.theme.icons import icon
from trex_gui.ui.theme.theme import theme
from trex_gui.ui.widgets import builders as ui


class Banner(QFrame):
    """Shows the newest message of a notifier, or of its owner; hidden while there is none."""

    def __init__(self, parent: QWidget | None = None, notifier: Notifier | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("banner")
        self.setFrameShape(QFrame.Shape.StyledPanel)
        self.setAutoFillBackground(True)

        self._kind = "info"
        self._sign = QLabel(self)
        self._text = ui.label(self, "bannerText", wrap=True, plain=True, selectable=True)
        self._text.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Preferred)
        self._dismiss = ui.tool_button(
            self, "bannerDismiss", self.tr("Dismiss"), on_click=self.clear
        )
        self._dismiss.setAutoRaise(True)

        ui.row(
            (self._sign, 0, Qt.AlignmentFlag.AlignTop),
            (self._text, 1),
            (self._dismiss, 0, Qt.AlignmentFlag.AlignTop),
            into=self,
            margins=(10, 6, 6, 6),
            spacing=10,
        )

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
        """Give screen readers a name while there is no message."""
        self._text.setAccessibleName("" if self._text.text() else self.tr("No message"))

    @Slot()
    def _on_theme_changed(self) -> None:
        size = self.fontMetrics().height() + 4
        self._sign.setPixmap(icon(self._kind, self._kind).pixmap(size, size))
